// SPDX-License-Identifier: Apache-2.0
#include "core/lattice/crossed_cell.h"

#include <algorithm>

#include "core/base/arith.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/lattice/crossed_cell.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, 16>;

#include "core/base/lanes-inl.h"
#include "core/lattice/crossed_cell-inl.h"

using Floats = Lanes<D>;

HWY_ATTR uint64_t find_inside(const CrossingTriangle& t, const CellPositions& positions) {
    const D d;
    const int lanes = int(hn::Lanes(d));
    uint64_t inside = 0;
    for (int i = 0; i < positions.count(); i += lanes) {
        const CrossingWeights<Floats> b(t, Floats::load(positions.x() + i),
                                        Floats::load(positions.y() + i));
        const auto holds = hn::And(
            hn::And(hn::Le(hn::Set(d, t.least[0]), b.b0.v), hn::Le(hn::Set(d, t.least[1]), b.b1.v)),
            hn::Le(hn::Set(d, t.least[2]), b.b2.v));
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

CrossingTriangle::CrossingTriangle(const Corners& corners, int site, int stride) : positions(0) {
    const Corner* p = corners.p;
    const Vec along[3] = {p[2] - p[1], p[0] - p[2], p[1] - p[0]};
    for (int k = 0; k < 3; ++k) {
        const Corner a = p[k], b = p[(k + 1) % 3];
        vertex[k] = site + 2 * (a.y * stride + a.x);
        edge[k] = site + (a.y + b.y) * stride + a.x + b.x;
        least[k] = tie_inside(along[k]) ? 0.0f : 1.0f / float(position_one);
    }
    for (int k = 0; k < 2; ++k) {
        const Corner to = p[k + 1];
        across[k][0] = float(along[k].x);
        across[k][1] = float(along[k].y);
        offset[k] = float(along[k].y * to.x - along[k].x * to.y);
    }
}

namespace {

/// Call add(triangle, corners) for each triangle that positions belong to.
template <class Add>
void each_crossing(const Lattice& lattice, int cx, int cy, const CellPositions& positions,
                   Add add) {
    const auto find = HWY_DYNAMIC_DISPATCH(find_inside);
    const int site = lattice.vertex_site(cx, cy);
    uint64_t left = ~uint64_t(0) >> (CellPositions::most - positions.count());
    for (int i = 0; left; ++i) {
        if (!(left >> i & 1))
            continue;
        const auto exact = [](float x) { return int32_t(x * position_one); };
        const Corners corners =
            locate(lattice, cx, cy, {exact(positions.x()[i]), exact(positions.y()[i])});
        CrossingTriangle t(corners, site, lattice.stride());
        // On the rim, a tie may belong to a triangle that does not hold it.
        t.positions = (find(t, positions) | uint64_t(1) << i) & left;
        left &= ~t.positions;
        add(t, corners);
    }
}

} // namespace

void find_crossing_triangles(const Lattice& lattice, int cx, int cy, const CellPositions& positions,
                             std::vector<CrossingTriangle>& triangles) {
    each_crossing(lattice, cx, cy, positions,
                  [&](const CrossingTriangle& t, const Corners&) { triangles.push_back(t); });
}

void find_cell_triangles(const Lattice& lattice, int cx, int cy, const CellPositions& positions,
                         std::vector<CellTriangle>& triangles) {
    each_crossing(lattice, cx, cy, positions, [&](const CrossingTriangle& t, const Corners& c) {
        CellTriangle& kept = triangles.emplace_back();
        for (int k = 0; k < 3; ++k) {
            kept.x[k] = int8_t(c.p[k].x);
            kept.y[k] = int8_t(c.p[k].y);
        }
        kept.positions = uint16_t(t.positions);
    });
}

} // namespace ddt
#endif
