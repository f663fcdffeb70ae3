// SPDX-License-Identifier: Apache-2.0
// Positions in a crossed cell (Division::crossed).
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/vectors/row_lanes.h"
#include "core/lattice/locate.h"

namespace ddt {

/// Positions in a cell, row by row: those of a grid.
class CellPositions {
public:
    static constexpr int most = 64;

    /// columns * rows <= most of them, at x[0] ... x[columns - 1] and y[0] ... y[rows - 1]: from 0
    /// to less than 1, or in the lattice's last cells to 1, multiples of 2^-16, in pixels from the
    /// cell's first corner. Nothing is done where it has these already.
    void set(const float* x, int columns, const float* y, int rows);

    int columns() const { return m_columns; }
    int rows() const { return m_rows; }
    int count() const { return m_columns * m_rows; }
    // Padded to whole vectors.
    const float* x() const { return m_x; }
    const float* y() const { return m_y; }

private:
    bool has(const float* x, int columns, const float* y, int rows) const;

    static constexpr int padding = most_lanes;
    int m_columns = 0, m_rows = 0;
    float m_x[most + padding] = {}, m_y[most + padding] = {};
};

/// What a triangle's weights are at positions in a cell. Weight k < 2 at (x, y) is
/// (across[k][0] * y - across[k][1] * x) + offset[k]; see crossed_cell-inl.h. Where no weight is
/// negative they are multiples of 2^-16 up to 1, so that float32 makes no error; elsewhere none
/// that changes which are.
struct CellPlanes {
    float across[2][2], offset[2];

    explicit CellPlanes(const Corners& corners) {
        const Corner* p = corners.p;
        for (int k = 0; k < 2; ++k) {
            const Corner from = p[k + 1], to = p[(k + 2) % 3];
            const int x = to.x - from.x, y = to.y - from.y;
            across[k][0] = float(x);
            across[k][1] = float(y);
            offset[k] = float(y * from.x - x * from.y);
        }
    }
};

/// As many triangles as a crossed cell's positions belong to, at most unless edges are very long.
constexpr size_t usual_crossing_triangles = 5;

/// A triangle that some of a crossed cell's positions belong to.
struct CrossingTriangle {
    int vertex[3]; ///< as in Triangle
    CellPlanes planes;
    uint64_t positions; ///< bit i: position i belongs to it

    /// site: of the cell's first corner.
    CrossingTriangle(const Corners& corners, int site, int stride, uint64_t positions_)
        : planes(corners), positions(positions_) {
        for (int k = 0; k < 3; ++k)
            vertex[k] = site + 2 * (corners.p[k].y * stride + corners.p[k].x);
    }
    /// As in Triangle: a midpoint is the mean of the ends.
    int edge(int k) const { return (vertex[k] + vertex[(k + 1) % 3]) / 2; }
};

/// The same as it is kept: vertices in Triangle's order relative to the cell's first corner, in
/// pixels. No edge is longer than longest_edge.
struct CellTriangle {
    struct {
        int8_t x, y;
    } p[3];
    uint16_t positions; ///< of 16 at most

    Corners corners() const { return {{{p[0].x, p[0].y}, {p[1].x, p[1].y}, {p[2].x, p[2].y}}}; }
};
static_assert(longest_edge < 127, "corners are within 8 bits");

/// Find which triangles the positions in the cell with first corner (cx, cy) belong to, each to
/// one, and add these to `triangles`.
void find_crossing_triangles(const Lattice& lattice, int cx, int cy, const CellPositions& positions,
                             std::vector<CrossingTriangle>& triangles);

} // namespace ddt
