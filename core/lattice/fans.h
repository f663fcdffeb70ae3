// SPDX-License-Identifier: Apache-2.0
// The edges round vertices, found for many vertices at once: a walk round one is a chain of loads
// that each wait for the one before, so that one after the other they would take as long as all of
// their loads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/arith.h"
#include "core/base/vectors/row_lanes.h"
#include "core/lattice/lattice.h"

namespace ddt {

/// Vertices whose fans lie side by side, so that they can be worked on at once.
constexpr int fans_side_by_side = 4;

/// Spokes of such vertices, each: the most of them has eight or nine edges in noise, and its first
/// is there twice.
constexpr size_t usual_spokes = 10;

/// The fans of some vertices of a row, in the order in which these were given.
struct Fans {
    struct Group {
        int x[fans_side_by_side];           ///< columns; the last vertex fills up the last group
        uint16_t degree[fans_side_by_side]; ///< edges of each
        uint16_t least, most;               ///< of these
        uint32_t first;                     ///< in `spokes`
    };
    std::vector<Group> groups;
    /// The neighbours relative to their vertex in pixels, which is where the edge's midpoint is in
    /// doubled coordinates: spoke k of vertex i of a group at [first + k * fans_side_by_side + i].
    /// Spoke 0 is Vertex::first, the next is to its left, and spoke `degree` is spoke 0 again; from
    /// there to spoke `most` they go on round.
    std::vector<Vec> spokes;

    /// Vectors of spokes may be read as far as this beyond the last.
    static constexpr size_t padding = most_lanes;
};

/// From the spoke of a vertex to the neighbour at x, y (relative to it, in pixels) to the next one
/// to the left or right; false on the rim. Twin: Walks::step() in fans.cpp.
DDT_INLINE bool next_spoke(const Site* vertex, int stride, bool left, int& x, int& y) {
    const Edge& e = vertex[ptrdiff_t(y) * stride + x].edge;
    const bool outwards = e.v == Vec(x, y);
    const Vec apex = outwards == left ? e.left : e.right();
    x = (x + apex.x) >> 1;
    y = (y + apex.y) >> 1;
    return !apex.zero();
}

/// Find the fans of the vertices in n columns of row y, none of them on the hull's rim, whose
/// Vertex::first has been found. walked: memory that is kept from one use to the next.
void find_fans(const Lattice& lattice, int y, const int* columns, int n, std::vector<Vec>& walked,
               Fans& fans);

} // namespace ddt
