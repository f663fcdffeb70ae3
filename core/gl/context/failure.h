// SPDX-License-Identifier: Apache-2.0
// What can go wrong on a GPU, as exceptions that never leave core/gl.
#pragma once

#include <stdexcept>

namespace ddt::gl {

/// The work cannot go on on this device; the message names the call.
struct Failure : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Memory could not be had; less may do.
struct OutOfMemory : Failure {
    using Failure::Failure;
};

/// The context is lost: the device is of no more use to this process.
struct ContextLost : Failure {
    using Failure::Failure;
};

} // namespace ddt::gl
