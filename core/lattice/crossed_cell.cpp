// SPDX-License-Identifier: Apache-2.0
#include "core/lattice/crossed_cell.h"

#include <algorithm>

#include "core/base/arith.h"
#include "core/base/vectors/row_lanes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/lattice/crossed_cell.cpp"
#include <hwy/foreach_target.h>

#include "core/base/vectors/vectors.h"

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
#include "core/base/vectors/vectors-inl.h"

using D = hn::CappedTag<float, most_lanes>;

#include "core/base/vectors/lanes-inl.h"
#include "core/lattice/crossed_cell-inl.h"

using Floats = Lanes<D>;

/// The positions whose weights are at least these.
HWY_ATTR uint64_t find_inside(const CellPlanes& t, const float least[3],
                              const CellPositions& positions) {
    const D d;
    const int lanes = int(hn::Lanes(d));
    uint64_t inside = 0;
    for (int i = 0; i < positions.count(); i += lanes) {
        const CrossingWeights<Floats> b(t, Floats::load(positions.x() + i),
                                        Floats::load(positions.y() + i));
        const auto holds = hn::And(
            hn::And(hn::Le(hn::Set(d, least[0]), b.b0.v), hn::Le(hn::Set(d, least[1]), b.b1.v)),
            hn::Le(hn::Set(d, least[2]), b.b2.v));
        uint8_t bits[8] = {}; // as many are written, at most
        hn::StoreMaskBits(d, holds, bits);
        inside |= uint64_t(unsigned(bits[0]) | unsigned(bits[1]) << 8) << i;
    }
    return inside;
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(find_inside);

bool CellPositions::has(const float* x, int columns, const float* y, int rows) const {
    if (columns != m_columns || rows != m_rows || !std::equal(x, x + columns, m_x))
        return false;
    for (int r = 0; r < rows; ++r)
        if (y[r] != m_y[r * columns])
            return false;
    return true;
}

void CellPositions::set(const float* x, int columns, const float* y, int rows) {
    if (has(x, columns, y, rows))
        return;
    m_columns = columns;
    m_rows = rows;
    for (int r = 0; r < rows; ++r) {
        std::copy_n(x, columns, m_x + r * columns);
        std::fill_n(m_y + r * columns, columns, y[r]);
    }
}

void find_crossing_triangles(const Lattice& lattice, int cx, int cy, const CellPositions& positions,
                             std::vector<CrossingTriangle>& triangles) {
    const auto find = HWY_DYNAMIC_DISPATCH(find_inside);
    const int site = lattice.vertex_site(cx, cy);
    uint64_t left = ~uint64_t(0) >> (CellPositions::most - positions.count());
    for (int i = 0; left; ++i) {
        if (!(left >> i & 1))
            continue;
        const auto exact = [](float x) { return int32_t(x * position_one); };
        const Corners corners =
            locate(lattice, cx, cy, {exact(positions.x()[i]), exact(positions.y()[i])});
        float least[3]; // what a weight is of positions that belong to the triangle
        for (int k = 0; k < 3; ++k)
            least[k] =
                tie_inside(corners.p[(k + 2) % 3] - corners.p[(k + 1) % 3]) ? 0.0f : position_unit;
        // On the rim, a tie may belong to a triangle that does not hold it.
        const uint64_t held =
            (find(CellPlanes(corners), least, positions) | uint64_t(1) << i) & left;
        left &= ~held;
        triangles.emplace_back(corners, site, lattice.stride(), held);
    }
}

} // namespace ddt
#endif
