// SPDX-License-Identifier: Apache-2.0
// Where a walk round a vertex begins: Lattice::find_first_edges() and its kin.
#include <algorithm>

#include "core/lattice/lattice.h"

namespace ddt {

namespace {

/// Tells which cells have a corner in common with one that is not plain, row by row of cells from
/// below.
class CellsWalkedRound {
public:
    /// Of `known` cells the divisions have been found; others are taken for what is not plain, and
    /// those at the lattice's rim too.
    CellsWalkedRound(const Lattice& lattice, const Rect& known)
        : m_lattice(lattice), m_known(known), m_columns(lattice.width() - 1),
          m_column(size_t(m_columns) + 2) {
        for (auto& row : m_rows)
            row.resize(size_t(m_columns));
    }

    /// A flag for each cell of the row; one after the other, or the same again.
    const uint8_t* row(int y) {
        std::vector<uint8_t>& found = m_rows[y & 1];
        if (m_y[y & 1] == y)
            return found.data();
        m_y[y & 1] = y;
        uint8_t* any = m_column.data() + 1; // of the cell and those above and below it
        std::fill(m_column.begin(), m_column.end(), uint8_t(0));
        for (int k = std::max(y - 1, 0); k <= std::min(y + 1, m_lattice.height() - 2); ++k)
            add_row(k, any);
        uint8_t* flags = found.data();
        for (int x = 0; x < m_columns; ++x)
            flags[x] = any[x - 1] | any[x] | any[x + 1];
        return flags;
    }

private:
    void add_row(int y, uint8_t* any) const {
        const bool rim = y == 0 || y == m_lattice.height() - 2;
        if (rim || y < m_known.y0 || y >= m_known.y1) {
            std::fill_n(any, m_columns, uint8_t(1));
            return;
        }
        const int x0 = std::max(m_known.x0, 1), x1 = std::min(m_known.x1, m_columns - 1);
        const Division* divisions = m_lattice.divisions(y);
        std::fill_n(any, std::min(x0, m_columns), uint8_t(1));
        for (int x = x0; x < x1; ++x)
            any[x] |= divisions[x] == Division::other;
        for (int x = std::max(x1, 0); x < m_columns; ++x)
            any[x] = 1;
    }

    const Lattice& m_lattice;
    const Rect m_known;
    const int m_columns;
    std::vector<uint8_t> m_column;
    std::vector<uint8_t> m_rows[2]; ///< row y at [y & 1]
    int m_y[2] = {-1, -1};
};

} // namespace

/// wanted(y): a flag for each column of cells, whether edges with midpoints there in row y of the
/// doubled lattice are looked at; null: all are.
template <class Wanted>
void Lattice::find_first_edges(const Rect& part, Wanted wanted) {
    // No midpoint is further from its edge's ends, in doubled coordinates.
    const int x0 = std::max(2 * part.x0 - m_longest, 0), y0 = std::max(2 * part.y0 - m_longest, 0);
    const int x1 = std::min(2 * (part.x1 - 1) + m_longest, 2 * (m_width - 1)),
              y1 = std::min(2 * (part.y1 - 1) + m_longest, 2 * (m_height - 1));
    const auto look_at = [&](int m) {
        const Vec v = edge(m).v;
        const int to_b = offset(v);
        vertex(m - to_b).first = v;
        vertex(m + to_b).first = -v;
    };
    // Backwards: the smallest address is written last.
    for (int y = y1; y >= y0; --y) {
        const int odd = y & 1;
        const uint8_t* flags = wanted(y);
        for (int column = x1 / 2; column >= x0 / 2; --column) {
            if (flags && !flags[column])
                continue;
            const int m = site(2 * column, y);
            if (column < m_width - 1)
                look_at(m + 1);
            if (odd) // on even rows there is a vertex
                look_at(m);
        }
    }
}

void Lattice::find_first_edges(const Rect& part) {
    find_first_edges(part, [](int) { return nullptr; });
}

void Lattice::find_walked_first_edges(const Rect& part) {
    CellsWalkedRound cells(*this, {part.x0 - 1, part.y0 - 1, part.x1, part.y1});
    std::vector<uint8_t> flags(static_cast<size_t>(m_width));
    find_first_edges(part, [&](int y) {
        // The rows of cells on either side of a row of level edges; else one.
        const uint8_t* below = cells.row(std::min(y / 2, m_height - 2));
        const uint8_t* above = y & 1 ? below : cells.row(std::max(y / 2 - 1, 0));
        // An upright edge lies between two cells.
        uint8_t* of_column = flags.data();
        const int last = m_width - 2;
        of_column[0] = of_column[last + 1] = 1; // the rim
        for (int x = 1; x <= last; ++x)
            of_column[x] = below[x - 1] | below[x] | above[x - 1] | above[x];
        return of_column;
    });
}

} // namespace ddt
