// SPDX-License-Identifier: Apache-2.0
// Failures made to happen, for tests of what follows them. Not thread-safe against running jobs.
#pragma once

#include <string>

namespace ddt::gl {

enum class Fault {
    library,    ///< a GL library cannot be loaded
    context,    ///< a context is refused
    bits,       ///< the device is found to compute otherwise than the CPU
    shader,     ///< a shader does not compile
    allocation, ///< a buffer cannot be allocated
    lost,       ///< the context is lost at a point where that is looked for
    count
};

/// Let the fault strike at the n-th chance from now (1: the next) and at `times` in a row.
/// n = 0: never.
void arm(Fault fault, int n, int times = 1);

/// Called where the fault could strike; true if it is to.
bool strikes(Fault fault);

/// Chances the fault has had since it was armed.
int chances(Fault fault);

/// Where hardware's device files are, in place of /dev.
void look_for_hardware_in(const std::string& folder);

/// Forget the devices opened so far, so that the next job opens them anew.
void forget_devices();

} // namespace ddt::gl
