// SPDX-License-Identifier: Apache-2.0
#include "core/lattice/crossed_rows.h"

#include <algorithm>

#include "core/lattice/crossed_columns.h"
#include "core/lattice/crossed_search.h"

namespace ddt {

void CrossedRows::begin(const Lattice& lattice, const CellPositions& positions, int rows) {
    m_lattice = &lattice;
    m_positions = &positions;
    m_rows.begin(rows);
}

const CrossedRows::Row& CrossedRows::row(int y, int x0, int x1) {
    return m_rows.row(y, x0, x1,
                      [&](Row& row) { find_crossed(*m_lattice, *m_positions, y, x0, x1, row); });
}

void find_crossed(const Lattice& lattice, const CellPositions& positions, int y, int x0, int x1,
                  CrossedRows::Row& row) {
    row.cells.clear();
    row.triangles.clear();
    const Division* divisions = lattice.divisions(y);
    CrossedSearch search;
    constexpr int listed_at_once = 512;
    int columns[listed_at_once + cells_at_once];
    const int at_once = CrossedSearch::most_cells_with(positions.count());
    for (int begin = x0; begin < x1; begin += listed_at_once) {
        const int all = list_crossed(
            begin, std::min(begin + listed_at_once, x1),
            [&](int at) { return crossed_cells(divisions + at); }, columns);
        for (int done = 0; done < all; done += at_once) {
            const int n = std::min(at_once, all - done);
            search.find(lattice, y, columns + done, n, positions);
            const auto first = int(row.triangles.size());
            for (int i = 0; i < n; ++i)
                row.cells.push_back({columns[done + i], first + search.first(i), search.count(i)});
            row.triangles.insert(row.triangles.end(), search.begin(0), search.end(n - 1));
        }
    }
}

size_t CrossedRows::memory(int width, int rows) {
    return size_t(rows) * size_t(width) *
           (sizeof(Cell) + usual_crossing_triangles * sizeof(CellTriangle));
}

} // namespace ddt
