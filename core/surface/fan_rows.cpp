// SPDX-License-Identifier: Apache-2.0
#include "core/surface/fan_rows.h"

#include <algorithm>

#include "core/lattice/crossed_columns.h"

namespace ddt {

void FanRows::begin(const Lattice& lattice, int rows) {
    m_lattice = &lattice;
    m_rows.begin(std::min(rows, lattice.height()));
}

const Fans& FanRows::row(int y, int x0, int x1) {
    return m_rows.row(y, x0, x1, [&](Fans& fans) { find(y, x0, x1, fans); });
}

void FanRows::find(int y, int x0, int x1, Fans& fans) {
    m_columns.resize(size_t(std::max(x1 - x0, 0) + cells_at_once));
    const NearDivisions divisions(*m_lattice, y);
    const int n = list_crossed(
        x0, x1, [&](int x) { return divisions.crossed_beside(x); }, m_columns.data());
    find_fans(*m_lattice, y, m_columns.data(), n, m_walked, fans);
}

size_t FanRows::memory(int width, int rows) {
    return size_t(rows) * size_t(width) *
           (usual_spokes * sizeof(Vec) + sizeof(Fans::Group) / fans_side_by_side);
}

} // namespace ddt
