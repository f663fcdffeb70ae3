// SPDX-License-Identifier: Apache-2.0
// Some rows of what belongs to a lattice, kept from where they are made to where they are last
// used.
#pragma once

#include <vector>

#include "core/surface/control_net.h"

namespace ddt {

/// Rows of pixels that are made at a time, at least.
constexpr int rows_at_once = 4;

/// Spare rows of pixels by which the kept window advances before its rows are moved to the front.
/// With more of them less is moved, but what is made leaves the cache before it is used.
constexpr int rows_to_go_on = 4;

/// Rows of vertices and of what belongs to edges that are in use at a time in most tiles, at most.
constexpr int usual_vertex_rows = 20, usual_edge_rows = 14;

/// Floats of SiteRows in a row of pixels, which is two of the doubled lattice.
constexpr size_t site_row(int width, int count) {
    return 2 * size_t(width) * size_t(count);
}

/// About the bytes that something takes.
struct MemoryNeeded {
    size_t rows = 0;  ///< of SiteRows, by take_rows(): in an arena, if there is one
    size_t other = 0; ///< on the heap
    size_t all() const { return rows + other; }
    friend MemoryNeeded operator+(MemoryNeeded a, MemoryNeeded b) {
        return {a.rows + b.rows, a.other + b.other};
    }
    friend MemoryNeeded operator*(size_t n, MemoryNeeded a) { return {n * a.rows, n * a.other}; }
};

/// Take the memory for so many floats.
void take_memory(std::vector<float>& kept, size_t floats);

/// Take the memory for so many rows of pixels, beside those to go on by, of `count` channels, and
/// begin with row `first`. In an arena, which was cleared since it was last asked for such rows; or
/// else, null, on the heap.
void take_rows(const Lattice& lattice, int count, int first, int rows, Arena* arena,
               SiteRows& kept);
/// The bytes of that.
size_t rows_memory(int width, int height, int count, int rows);

/// Make room for the rows of pixels before `end`. Of the rows before `made`, which are of use,
/// those before `keep` may go.
void make_room(const Lattice& lattice, int keep, int made, int end, SiteRows& kept);

} // namespace ddt
