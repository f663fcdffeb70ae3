// SPDX-License-Identifier: Apache-2.0
// Pixels that a file keeps together. Files may claim tiles larger than any image, up to the largest
// int: their sides are not to be computed with as they are.
#pragma once

#include <algorithm>
#include <climits>
#include <cstdint>

namespace ddt {

/// A side of a file's tiles as far as its image goes; 1 where the file has none.
inline int tile_side(int tile, int image) {
    return std::clamp(tile, 1, std::max(image, 1));
}

/// The least multiple of `together` that is `rows` or more, or the largest int.
inline int rounded_up(int rows, int together) {
    const int64_t pieces = (int64_t(rows) + together - 1) / together;
    return int(std::min<int64_t>(pieces * together, INT_MAX));
}

} // namespace ddt
