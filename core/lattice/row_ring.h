// SPDX-License-Identifier: Apache-2.0
// What was found in rows, kept for whoever asks for the same row next.
#pragma once

#include <cstddef>
#include <vector>

namespace ddt {

/// Of the rows that were asked for last, what was found in each.
template <class Found>
class RowRing {
public:
    /// Forget all. rows: to be kept, one at least.
    void begin(int rows) {
        m_rows.resize(size_t(rows));
        for (Row& row : m_rows)
            row.y = -1;
    }

    /// What there is in columns x0 .. x1 - 1, or more, of row y: where it is not kept, what
    /// find(found) puts in the place of another row's. Until another row is asked for.
    template <class Find>
    const Found& row(int y, int x0, int x1, Find&& find) {
        Row& row = m_rows[size_t(y) % m_rows.size()];
        if (row.y != y || x0 < row.x0 || row.x1 < x1) {
            row.y = y;
            row.x0 = x0;
            row.x1 = x1;
            find(row.found);
        }
        return row.found;
    }

private:
    struct Row {
        int y = -1, x0 = 0, x1 = 0;
        Found found;
    };
    std::vector<Row> m_rows; ///< row y at [y % size]
};

} // namespace ddt
