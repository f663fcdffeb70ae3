// SPDX-License-Identifier: Apache-2.0
#include "core/surface/crossed_rows.h"

#include "core/lattice/crossed_columns.h"
#include "core/lattice/crossed_search.h"

namespace ddt {

void CrossedRows::begin(const Lattice& lattice, const CellPositions& positions, int rows) {
    m_lattice = &lattice;
    m_positions = &positions;
    m_rows.resize(size_t(rows));
    for (Row& row : m_rows)
        row.y = -1;
}

const CrossedRows::Row& CrossedRows::row(int y, int x0, int x1) {
    Row& row = m_rows[size_t(y) % m_rows.size()];
    if (row.y != y || x0 < row.x0 || row.x1 < x1)
        find_crossed(*m_lattice, *m_positions, y, x0, x1, row);
    return row;
}

void find_crossed(const Lattice& lattice, const CellPositions& positions, int y, int x0, int x1,
                  CrossedRows::Row& row) {
    row.y = y;
    row.x0 = x0;
    row.x1 = x1;
    row.cells.clear();
    row.triangles.clear();
    const Division* divisions = lattice.divisions(y);
    const auto next = [&](int x) {
        return next_crossed(x, x0, x1, [&](int at) { return crossed_cells(divisions + at); });
    };
    CrossedSearch search;
    int cells[CrossedSearch::most_cells];
    const int at_once = CrossedSearch::most_cells_with(positions.count());
    for (int x = next(x0); x < x1;) {
        int n = 0;
        for (; n < at_once && x < x1; x = next(x + 1))
            cells[n++] = x;
        search.find(lattice, y, cells, n, positions);
        const auto first = int(row.triangles.size());
        for (int i = 0; i < n; ++i)
            row.cells.push_back({cells[i], first + search.first(i), search.count(i)});
        row.triangles.insert(row.triangles.end(), search.begin(0), search.end(n - 1));
    }
}

size_t CrossedRows::memory(int width, int rows) {
    return size_t(rows) * size_t(width) *
           (sizeof(Cell) + usual_crossing_triangles * sizeof(CellTriangle));
}

} // namespace ddt
