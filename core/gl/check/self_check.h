// SPDX-License-Identifier: Apache-2.0
// Whether a device keeps the promise of the same bits.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "core/gl/transfer.h"
#include "ddt/core.h"

namespace ddt::gl {

struct Gpu;

/// The job that is checked in place of `job`: one that uses the same programs, those of their
/// branches that it takes, on a small picture. `clipped` and `start` are the job's own: where
/// others differ in them alone, each is checked.
Job check_job(const Job& job);

/// Do it on the device and on the CPU; compare meshes, gains and results bit for bit, each before
/// what needs it is begun. Empty if they are the same, else what differs first. On the context's
/// thread; throws Failure. GLSL promises what is needed (see core/base/arith.h), but a driver that
/// contracts or reorders all the same must not be used.
std::string differs_from_cpu(Gpu& gpu, const Job& job);

/// What came of the checks of a device, by the programs that were checked.
class SelfChecks {
public:
    /// differs_from_cpu(), the first time that its programs are wanted, and transfer_differs().
    const std::string& differs(Gpu& gpu, const Job& job, const Transfer& transfer = {});
    /// tin_differs_from_cpu() of core/gl/check/tin_check.h alike.
    const std::string& differs(Gpu& gpu, const MeshOptions& of_points);
    /// What `check` says, the first time that the key is wanted. Its buffers are FilledBuffers. A
    /// Failure of it counts as a difference, but for those of memory and of the context, which are
    /// thrown.
    const std::string& differs(Gpu& gpu, const std::string& key,
                               const std::function<std::string()>& check);
    double milliseconds() const { return m_milliseconds; }

    /// Context::tested ones are compared with the CPU by tests: they are checked only if this says
    /// so.
    bool tested_too = false;

private:
    std::map<std::string, std::string> m_differences;
    double m_milliseconds = 0;
};

} // namespace ddt::gl
