// SPDX-License-Identifier: Apache-2.0
// From floats straight to 8-bit codes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ddt {

/// The codes 0 to 255 of floats, by a curve that rises from 0 to 1 and rounding.
///
/// A float's bits, taken as an integer, order floats as the numbers do. The range between the first
/// and the last code is cut into equal pieces of such integers, so small that no piece holds more
/// than one border between codes; a piece's entry is the code at its beginning and where in it the
/// border lies. So the codes are exact, for one look-up each in some ten kilobytes.
///
/// Whoever fills one calls the first float whose code is c or more the border of c, and sees to it
/// that, of bits(x) taken as an integer and piece(x) = bits(x) >> shift,
///
/// - `shift` is 1 to 23, and piece() differs for any two of the borders of 1 to 255;
/// - `lowest` is above 0 and below the border of 1;
/// - `top` is the border of 255;
/// - `first` is piece(lowest);
/// - `entries` are piece(top) - first + 1, one for each piece from `first` on: the code of the
///   float before the piece << 24 (of `first`, 0), and below it, of the one border b in the piece,
///   bits(b) & ((1 << shift) - 1), or 0xffffff if there is none.
///
/// Nothing checks that.
struct CodeTable {
    std::vector<uint32_t> entries; ///< the code in the highest 8 bits, below it the border
    int shift = 0;                 ///< bits of a float that tell where in its piece it is
    uint32_t first = 0;            ///< bits of the first entry's first float, shifted
    float lowest = 0, top = 0;     ///< numbers are clamped to these, none below 0: codes 0 and 255

    /// Codes of n numbers, by the widest vectors this machine has, of a table that is filled. NaN
    /// and what is not above 0 give 0.
    void encode(const float* x, uint8_t* codes, size_t n) const noexcept;
};

} // namespace ddt
