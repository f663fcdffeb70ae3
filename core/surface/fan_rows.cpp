// SPDX-License-Identifier: Apache-2.0
#include "core/surface/fan_rows.h"

#include <algorithm>

#include "core/lattice/crossed_columns.h"

namespace ddt {

void FanRows::begin(const Lattice& lattice, int rows) {
    m_lattice = &lattice;
    m_rows.resize(size_t(std::min(rows, lattice.height())));
    for (Row& row : m_rows)
        row.y = -1;
}

const Fans& FanRows::row(int y, int x0, int x1) {
    Row& row = m_rows[size_t(y) % m_rows.size()];
    if (row.y != y || x0 < row.x0 || row.x1 < x1)
        find(y, x0, x1, row);
    return row.fans;
}

void FanRows::find(int y, int x0, int x1, Row& row) {
    row.y = y;
    row.x0 = x0;
    row.x1 = x1;
    m_columns.resize(size_t(std::max(x1 - x0, 0) + cells_at_once));
    const NearDivisions divisions(*m_lattice, y);
    const int n = list_crossed(
        x0, x1, [&](int x) { return divisions.crossed_beside(x); }, m_columns.data());
    find_fans(*m_lattice, y, m_columns.data(), n, m_walked, row.fans);
}

size_t FanRows::memory(int width, int rows) {
    return size_t(rows) * size_t(width) *
           (usual_spokes * sizeof(Vec) + sizeof(Fans::Group) / fans_side_by_side);
}

} // namespace ddt
