// SPDX-License-Identifier: Apache-2.0
// What the library tells of its work.
#pragma once

#include <functional>

namespace ddt {

/// Takes a line, "ddt: device cpu; ...", without line end. May be called from several threads at
/// once; what it throws is dropped.
using LogCallback = std::function<void(const char* line)>;

/// Hand all lines to `callback`. With an empty one, as at first, they go to stderr where the
/// environment variable DDT_VERBOSE is set, not empty, and does not begin with 0, and nowhere else.
/// Safe to call at any time; lines under way may still go where they went before. May throw
/// std::bad_alloc; then they go where they went.
void set_log(LogCallback callback);

} // namespace ddt
