// SPDX-License-Identifier: Apache-2.0
// Work that a fork() shall not cut in two.
#pragma once

#include <mutex>

namespace ddt {

/// The lock under which configs are read and spaces analysed, and whatever that leaves behind is
/// looked up. fork() waits until it is free: no child inherits it locked, nor OpenColorIO's own
/// locks or half-made statics, since nothing but conversions by finished processors, which lock
/// nothing, happens outside.
std::mutex& colour_lock();

} // namespace ddt
