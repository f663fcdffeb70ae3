// SPDX-License-Identifier: Apache-2.0
#include "core/lattice/row_reach.h"

#include <algorithm>

namespace ddt {

int RowReach::at(const std::vector<int>& rows, int y) {
    return rows[size_t(std::clamp(y, 0, int(rows.size()) - 1))];
}

void RowReach::find(const Lattice& lattice) {
    const int height = lattice.height(), last = 2 * height - 2;
    for (std::vector<int>* rows :
         {&m_last_neighbour, &m_first_neighbour, &m_last_end, &m_first_end}) {
        rows->resize(size_t(height));
        for (int y = 0; y < height; ++y)
            (*rows)[size_t(y)] = y;
    }
    // Ends of the edges with midpoints in row m of the doubled lattice, or rows beyond them.
    const auto upper = [&](int m) { return size_t(m - lattice.longest_down(m)) / 2; };
    const auto lower = [&](int m) { return (m + lattice.longest_down(m)) / 2; };
    for (int m = 0; m <= last; ++m) {
        int& neighbour = m_last_neighbour[upper(m)];
        neighbour = std::max(neighbour, lower(m));
        int& end = m_last_end[size_t(m + 1) / 2];
        end = std::max(end, lower(m));
    }
    for (int m = last; m >= 0; --m) {
        int& neighbour = m_first_neighbour[size_t(lower(m))];
        neighbour = std::min(neighbour, int(upper(m)));
        int& end = m_first_end[size_t(m) / 2];
        end = std::min(end, int(upper(m)));
    }
    for (size_t y = 1; y < size_t(height); ++y) {
        m_last_neighbour[y] = std::max(m_last_neighbour[y], m_last_neighbour[y - 1]);
        m_last_end[y] = std::max(m_last_end[y], m_last_end[y - 1]);
    }
    for (size_t y = size_t(height) - 1; y-- > 0;) {
        m_first_neighbour[y] = std::min(m_first_neighbour[y], m_first_neighbour[y + 1]);
        m_first_end[y] = std::min(m_first_end[y], m_first_end[y + 1]);
    }
}

} // namespace ddt
