// SPDX-License-Identifier: Apache-2.0
// Whether a device keeps the promise of the same bits on jobs.
#pragma once

#include <string>

#include "ddt/core.h"

namespace ddt::gl {

struct Gpu;

/// Do a job that uses the programs of `job`, those of their branches that it takes, on a small
/// picture, on the device and on the CPU; compare meshes, gains and results bit for bit, each
/// before what needs it is begun. Empty if they are the same, else what differs first. On the
/// context's thread; throws Failure. GLSL promises what is needed (see core/base/arith.h), but a
/// driver that contracts or reorders all the same must not be used.
std::string job_differs_from_cpu(Gpu& gpu, const Job& job);

/// Two jobs of one key use the same programs, and the same branches of those that make or choose
/// edges or correct vertices.
std::string job_key_of(const Job& job);

} // namespace ddt::gl
