// SPDX-License-Identifier: Apache-2.0
// The triangles of crossed cells, kept for whoever asks for the same positions next.
#pragma once

#include <vector>

#include "core/lattice/crossed_cell.h"
#include "core/lattice/row_ring.h"

namespace ddt {

/// Of the rows of cells that were asked for last. Rounds of corrections are some rows apart, and
/// ask for the same.
class CrossedRows {
public:
    /// Start on a lattice, whose divisions have been found. rows: to be kept, one at least.
    void begin(const Lattice& lattice, const CellPositions& positions, int rows);

    /// A crossed cell and its triangles.
    struct Cell {
        int x;
        int first, count; ///< in Row::triangles
    };
    struct Row {
        std::vector<Cell> cells; ///< from left to right
        std::vector<CellTriangle> triangles;
    };
    /// Cells x0 .. x1 - 1, or more, of row y; until another row is asked for.
    const Row& row(int y, int x0, int x1);

    /// About the bytes that so many rows of cells take where all are crossed.
    static size_t memory(int width, int rows);

private:
    const Lattice* m_lattice = nullptr;
    const CellPositions* m_positions = nullptr;
    RowRing<Row> m_rows;
};

/// Find the crossed ones of cells x0 .. x1 - 1 of row y, and their triangles; with no more
/// positions than CrossedSearch::most_positions.
void find_crossed(const Lattice& lattice, const CellPositions& positions, int y, int x0, int x1,
                  CrossedRows::Row& row);

} // namespace ddt
