// SPDX-License-Identifier: Apache-2.0
// Which pixel each lane of a vector is of, in rows of some floats a pixel.
#pragma once

#include <cstddef>
#include <cstdint>

namespace ddt {

/// A float in a row of pixels.
struct RowPlace {
    ptrdiff_t at; ///< from the row's first
    ptrdiff_t x;  ///< its pixel,
    int c;        ///< and which of the pixel's it is
};

/// Lanes of the widest vectors, of floats or of integers of 32 bits, that are worked on by: those
/// of 512 bits. So many numbers are written or read past the end of most lists and rows.
constexpr int most_lanes = 16;
/// Floats a pixel has at most.
constexpr int most_in_pixel = 4;

/// of[count - 1][c][k]: how many pixels, of `count` floats, lane k lies after the first lane's,
/// which is float c of its pixel.
struct PixelOfLane {
    int32_t of[most_in_pixel][most_in_pixel][most_lanes] = {};
    constexpr PixelOfLane() {
        for (int count = 1; count <= most_in_pixel; ++count)
            for (int c = 0; c < count; ++c)
                for (int k = 0; k < most_lanes; ++k)
                    of[count - 1][c][k] = (c + k) / count;
    }
};
inline constexpr PixelOfLane pixel_of_lane;

} // namespace ddt
