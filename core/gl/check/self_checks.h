// SPDX-License-Identifier: Apache-2.0
// What came of the checks of a device.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "core/gl/transfer.h"
#include "ddt/core.h"

namespace ddt::gl {

struct Gpu;

/// By the programs that were checked.
class SelfChecks {
public:
    /// job_differs_from_cpu(), the first time that its programs are wanted, and transfer_differs().
    const std::string& differs(Gpu& gpu, const Job& job, const Transfer& transfer = {});
    /// tin_differs_from_cpu() alike.
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
