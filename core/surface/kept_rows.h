// SPDX-License-Identifier: Apache-2.0
// Some rows of what belongs to a lattice, kept from where they are made to where they are last
// used.
#pragma once

#include <algorithm>
#include <vector>

#include "core/surface/edge_scratch.h"

namespace ddt {

/// Edges of most tiles are no longer than this.
constexpr int usual_longest = 10;

/// Rows of pixels that are made at a time, at least.
constexpr int rows_at_once = 4;

/// Rows of pixels by which what is kept of an array goes on at a time, beside those in use. With
/// more of them less is moved, but what is made leaves the cache before it is used.
constexpr int rows_to_go_on = 4;

/// Rows in use, where edges are this long, of vertices and of what belongs to edges. Most tiles
/// have some edge that is not short.
constexpr int vertex_rows(int longest) {
    return rows_at_once + 4 * std::max(longest, 5) + 4;
}
constexpr int edge_rows(int longest) {
    return rows_at_once + 2 * std::max(longest, 5) + 4;
}

/// Floats of a net in a row of pixels.
inline size_t net_row(const Lattice& lattice) {
    return 2 * size_t(lattice.stride()) * group_size;
}

/// Take the memory for so many rows of `row` floats.
void take_memory(std::vector<float>& kept, size_t row, int rows);

/// Make room in `kept`, `row` floats for each row of pixels from row `first` on, for the rows
/// before `end`. Of the rows before `made`, which are of use, those before `keep` may go. `more`:
/// rows to make room for beside; there are no more than `height`.
void make_room(std::vector<float>& kept, size_t row, int more, int height, int& first, int keep,
               int made, int end);

} // namespace ddt
