// SPDX-License-Identifier: Apache-2.0
// Which triangle a position lies in, and its barycentric weights, in exact integer arithmetic.
#pragma once

#include <cstdint>

#include "core/lattice/lattice.h"

namespace ddt {

/// A position within a lattice, in 2^-16 pixel: 0 <= x <= (width - 1) * 2^16, y alike.
struct Point {
    int32_t x, y;
};

/// A triangle; vertices with det(p1 - p0, p2 - p0) = 1, the one with the smallest address first, so
/// that one triangle is always described in one way.
///
/// Ties: a position on an edge or vertex belongs to the triangle that holds position + (d, d^2) for
/// tiny d > 0; so every position belongs to one triangle, however that is searched for. (On the
/// hull's rim, where that point may be outside: to the one that locate() ends in.)
struct Triangle {
    int vertex[3];   ///< sites
    int edge[3];     ///< sites of the edges 01, 12, 20
    Point at[2];     ///< positions of vertices 1 and 2
    Vec e12, e20;    ///< edges as vectors in pixels
    int32_t bias[3]; ///< 0 where weight k = 0 counts as inside, else -1

    /// Weights of the vertices at a position at most 128 pixels away (near()), in 2^-16; they sum
    /// to 2^16.
    void weights(Point p, int32_t w[3]) const {
        w[0] = e12.x * (p.y - at[0].y) - e12.y * (p.x - at[0].x);
        w[1] = e20.x * (p.y - at[1].y) - e20.y * (p.x - at[1].x);
        w[2] = position_one - w[0] - w[1];
    }
    /// Whether weights() may be asked at p.
    bool near(Point p) const {
        constexpr int32_t limit = 128 * position_one;
        const int32_t dx = p.x - at[0].x, dy = p.y - at[0].y;
        return dx < limit && -dx < limit && dy < limit && -dy < limit;
    }
    /// Whether weights are those of a position that belongs to this triangle.
    bool holds(const int32_t w[3]) const {
        return ((w[0] + bias[0]) | (w[1] + bias[1]) | (w[2] + bias[2])) >= 0;
    }
};

/// A cell's coordinate along an axis of `size` pixels: the last pixel belongs to the cell before
/// it.
inline int cell_of(int32_t position, int size) {
    const int cell = position >> position_bits;
    return cell < size - 1 ? cell : size - 2;
}

/// A vertex relative to the first corner of a cell, in pixels.
struct Corner {
    int x, y;
};
inline Vec operator-(Corner a, Corner b) {
    return {a.x - b.x, a.y - b.y};
}

/// A triangle's vertices in Triangle's order, relative to the first corner of a cell.
struct Corners {
    Corner p[3];
};

/// The triangle that a position belongs to, by its place in the cell with first corner (cx, cy), 0
/// to 2^16. Starts at the cell's diagonal edge and walks along the straight line from the cell's
/// centre, which crosses every triangle at most once.
Corners locate(const Lattice& lattice, int cx, int cy, Point in_cell);

/// The triangle that p belongs to.
Triangle locate(const Lattice& lattice, Point p);

/// Whether weight 0 with respect to an edge along d counts as inside: the sign of
/// det(d, (t, t^2)) for tiny t > 0.
inline bool tie_inside(Vec d) {
    // d.y < 0 or, where it is 0, d.x > 0. Branch-free: the branch would be mispredicted.
    return 256 * d.y < d.x;
}

} // namespace ddt
