// SPDX-License-Identifier: Apache-2.0
// Whether lines on stderr are wanted.
#pragma once

namespace ddt {

/// The environment variable DDT_VERBOSE is set, not empty, and does not begin with 0.
bool verbose();

} // namespace ddt
