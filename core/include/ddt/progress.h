// SPDX-License-Identifier: Apache-2.0
// How work tells how far it is, and is cancelled.
#pragma once

#include <functional>

namespace ddt {

/// Called from time to time with the share done, from 0 to 1, which never falls; returns false to
/// cancel the work, which is a failure. By one thread at a time, the caller's or another, and not
/// again after it returned false or threw. What it throws ends the work as a failure too. May be
/// empty.
using ProgressCallback = std::function<bool(float)>;

} // namespace ddt
