// SPDX-License-Identifier: Apache-2.0
// The triangles of many crossed cells in which positions lie alike.
#pragma once

#include <algorithm>

#include "core/base/vectors/row_lanes.h"
#include "core/lattice/crossed_cell.h"

namespace ddt {

/// Goes from the edge at each cell's centre to the triangles that positions belong to, as locate()
/// does for one of them: all positions that cross the same edges on their way go together, and
/// those of all cells are on their way at once, a lane for each such group.
class CrossedSearch {
public:
    /// Positions in a cell, at most.
    static constexpr int most_positions = 16;
    /// Cells that are searched together, at most; and those of so many positions.
    static constexpr int most_cells = 128;
    static int most_cells_with(int positions) {
        return std::min(most_groups / positions, most_cells);
    }

    /// Find which triangles the positions belong to in n cells of row cy, those with first corners
    /// at x[0] ... x[n - 1].
    void find(const Lattice& lattice, int cy, const int* x, int n, const CellPositions& positions);

    /// Those of cell i, each of its positions in one of them; they follow those of cell i - 1.
    const CellTriangle* begin(int i) const { return m_triangles + m_first[i]; }
    const CellTriangle* end(int i) const { return m_triangles + m_first[i + 1]; }
    int first(int i) const { return m_first[i]; }
    int count(int i) const { return m_first[i + 1] - m_first[i]; }

    /// Groups have a position each at least, so there are never more.
    static constexpr int most_groups = 512;

    /// Triangles in the order in which they are found; padded to whole vectors.
    struct Found {
        static constexpr int room = most_groups + most_lanes;
        int count = 0;
        int32_t corners_01[room];             ///< bytes x, y, x, y
        int32_t corner_2_and_positions[room]; ///< bytes x, y, and a bit a position
        int32_t cell[room];                   ///< its number
    };

private:
    void sort(const Found& found, int cells);

    CellTriangle m_triangles[most_groups];
    int m_first[most_cells + 1];
};

} // namespace ddt
