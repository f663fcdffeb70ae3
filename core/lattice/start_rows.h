// SPDX-License-Identifier: Apache-2.0
// Rows of the mesh that a lattice starts with, several cells at once: SIMD twins of the loops of
// Lattice::start(). Each returns how many cells or pixels from the first on it has done: all of
// them, or none of a few.
#pragma once

#include <cstdint>
#include <cstring>

#include "core/lattice/site.h"

namespace ddt {

/// How a cell of a row is divided: diagonal_down, or 0 for up.
using DownFlag = int32_t;
constexpr DownFlag diagonal_down = -1;

/// The record of an edge by how the two cells beside it are divided.
class RecordOfTwo {
public:
    /// up_down: where the first cell's diagonal goes up and the second's down, and so on.
    RecordOfTwo(const Site& up_up, const Site& up_down, const Site& down_up, const Site& down_down)
        : both_up(number(up_up)), first_down(both_up ^ number(down_up)),
          second_down(both_up ^ number(up_down)),
          both_down(both_up ^ first_down ^ second_down ^ number(down_down)) {}

    /// And the bits that change with the first cell, with the second, and further if both go down.
    uint64_t both_up, first_down, second_down, both_down;

private:
    static uint64_t number(const Site& site) {
        uint64_t record;
        std::memcpy(&record, &site, sizeof record);
        return record;
    }
};

/// Divide n cells between two rows of the guide: down where that diagonal differs no more than the
/// other, but where there are contour words and the cell's tells of one, as it goes along it.
int divide_flat(const float* upper, const float* lower, const uint32_t* words, int n,
                DownFlag* down);

/// Make an even row of the doubled lattice: n vertices of a row of the guide, and behind each the
/// horizontal edge between the cells above and below. No words: contours of 0.
int make_even_row(const float* guide, const uint32_t* words, const DownFlag* above,
                  const DownFlag* below, const RecordOfTwo& horizontals, int n, Site* to);

/// Make an odd row: the vertical edges on the left of n cells, and behind each the cell's diagonal.
/// There is a cell before the first, too.
int make_odd_row(const DownFlag* cells, const RecordOfTwo& verticals, const RecordOfTwo& diagonals,
                 int n, Site* to);

} // namespace ddt
