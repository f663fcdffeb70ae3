// SPDX-License-Identifier: Apache-2.0
// Lines about the work, for whoever wants them (ddt/log.h).
#pragma once

#include "ddt/log.h"

namespace ddt {

/// Whether anybody wants lines.
bool verbose();

/// Tell a line, formatted as by printf, without line end. Never throws.
__attribute__((format(printf, 1, 2))) void say(const char* format, ...) noexcept;

} // namespace ddt
