// SPDX-License-Identifier: Apache-2.0
// Whether a device keeps the promise of the same bits.
#pragma once

#include <string>

#include "core/gl/context/gpu.h"

namespace ddt::gl {

/// Enlarge a small picture on the device and on the CPU and compare every bit. Empty if they are
/// the same, else what differs. On the context's thread; throws Failure. GLSL promises what is
/// needed (see core/arith), but a driver that contracts or reorders all the same must not be used.
std::string differs_from_cpu(Gpu& gpu);

} // namespace ddt::gl
