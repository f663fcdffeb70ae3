// SPDX-License-Identifier: Apache-2.0
// How large a picture may be asked for.
#pragma once

namespace ddt {

/// A side that a command, a file name or a stream's header may ask for: more than any image has.
constexpr int largest_side = 1 << 24;

} // namespace ddt
