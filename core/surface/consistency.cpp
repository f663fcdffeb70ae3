// SPDX-License-Identifier: Apache-2.0
#include "core/surface/consistency.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/base/arith.h"
#include "core/lattice/crossed_cell.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/consistency.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef DDT_CONSISTENCY_ONCE
#define DDT_CONSISTENCY_ONCE
namespace ddt {

/// Positions along an axis at which quadrants' means are taken (consistency-inl.h).
constexpr int quadrant_side = 4;

/// A cell that edges cross which are not its own, and these positions in it.
struct CrossedCell {
    CellPositions positions;
    std::vector<CrossingTriangle> triangles;

    CrossedCell() {
        constexpr float at[quadrant_side] = {0.125f, 0.375f, 0.625f, 0.875f};
        positions.set(at, quadrant_side, at, quadrant_side);
    }
    void find_triangles(const Lattice& lattice, int cx, int cy) {
        triangles.clear();
        find_crossing_triangles(lattice, cx, cy, positions, triangles);
    }
};

} // namespace ddt
#endif

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr float quiet_nan = std::numeric_limits<float>::quiet_NaN();

#include "core/base/lanes-inl.h"
#include "core/lattice/crossed_cell-inl.h"
#include "core/surface/consistency-inl.h"
#include "core/surface/patch-inl.h"

using Lanes4 = Lanes<hn::CappedTag<float, group_size>>; // a lane a channel

#include "core/base/blocks-inl.h"

#include "core/surface/crossing-inl.h"

/// Those of a vector of pixels, or one, from `source` on: a row `row` floats long. near: what is
/// there beside them.
template <class T>
HWY_INLINE void limits_at(const Rect& near, ptrdiff_t row, const float* source, T margin, T lowest,
                          float* low_row, float* high_row) {
    const auto tap = [&](int i, int j)
                         HWY_ATTR { return T::load(source + j * row + i * group_size); };
    T low, high;
    find_limits(near, margin, lowest, tap, low, high);
    low.store(low_row);
    high.store(high_row);
}

HWY_ATTR void limits_in_row(int width, int height, const float* source, int x0, int x1, int y,
                            const float* limit, float lowest, float* low_row, float* high_row) {
    const ptrdiff_t row = ptrdiff_t(width) * group_size;
    const int above = y > 0 ? -1 : 0, below = y + 1 < height ? 2 : 1;
    const auto one = [&](int x) HWY_ATTR {
        const Rect near{x > 0 ? -1 : 0, above, x + 1 < width ? 2 : 1, below};
        const ptrdiff_t at = ptrdiff_t(x) * group_size;
        limits_at(near, row, source + y * row + at, Lanes4::load(limit), Lanes4(lowest),
                  low_row + at, high_row + at);
    };
    const Blocks margin = in_every_block(limit), least(lowest);
    const auto several = [&](int x) HWY_ATTR {
        const ptrdiff_t at = ptrdiff_t(x) * group_size;
        limits_at({-1, above, 2, below}, row, source + y * row + at, margin, least, low_row + at,
                  high_row + at);
    };
    each_vector(x0, x1, std::max(x0, 1), std::min(x1, width - 1), one, several);
}

/// The means of a plain cell's quadrants, added to its corners' sums.
template <bool quadratic, bool soft>
HWY_INLINE void add_plain_cell(const Net& net, int site, bool down, float* upper, float* lower) {
    const int stride = net.stride;
    const auto load = [&](int s) HWY_ATTR { return Lanes4::load(net.at(s)); };
    const auto load_soft = [&](int s) HWY_ATTR { return Lanes4::load(net.soft_at(s)); };
    const Lanes4 z0 = load(site), z1 = load(site + 2), z2 = load(site + 2 * stride),
                 z3 = load(site + 2 * stride + 2);
    const int top = site + 1, left = site + stride, middle = left + 1, right = left + 2,
              bottom = top + 2 * stride;
    Lanes4 e[5], q[5];
    const int edges[5] = {top, left, right, bottom, middle};
    for (int i = 0; i < 5; ++i) {
        if (quadratic)
            e[i] = load(edges[i]);
        if (soft)
            q[i] = load_soft(edges[i]);
    }
    enum { t, l, r, b, m };
    const auto add = [&](float* to, const QuadrantCell<Lanes4>& c, bool through) HWY_ATTR {
        const Lanes4 mean =
            through ? c.template through<quadratic, soft>() : c.template across<quadratic, soft>();
        (Lanes4::load(to) + mean).store(to);
    };
    const auto cell = [&](Lanes4 v, Lanes4 x, Lanes4 y, Lanes4 d, int vx, int vy, int xd,
                          int yd) HWY_ATTR {
        QuadrantCell<Lanes4> c;
        c.v = v, c.x = x, c.y = y, c.d = d;
        if (quadratic)
            c.vx = e[vx], c.vy = e[vy], c.xd = e[xd], c.yd = e[yd], c.diagonal = e[m];
        if (soft)
            c.qvx = q[vx], c.qvy = q[vy], c.qxd = q[xd], c.qyd = q[yd], c.q_diagonal = q[m];
        return c;
    };
    add(upper, cell(z0, z1, z2, z3, t, l, r, b), down);
    add(upper + group_size, cell(z1, z0, z3, z2, t, r, l, b), !down);
    add(lower, cell(z2, z3, z0, z1, b, l, r, t), !down);
    add(lower + group_size, cell(z3, z2, z1, z0, b, r, l, t), down);
}

/// The same where other edges cross the cell.
template <bool quadratic, bool soft>
HWY_INLINE void add_crossed_cell(const Net& net, int site, const CrossedCell& cell, float* upper,
                                 float* lower) {
    HWY_ALIGN float f[(CellPositions::most + 4) * group_size];
    evaluate_crossing<quadratic, soft>(net, in_every_block(net.strict), false,
                                       cell.triangles.data(), cell.triangles.size(), cell.positions,
                                       f);
    for (int corner = 0; corner < 4; ++corner) {
        const int right = corner & 1, below = corner >> 1;
        const Lanes4 z = Lanes4::load(net.at(site + 2 * right + 2 * below * net.stride));
        const int i = 2 * right + 2 * below * quadrant_side;
        // In the order back and forth through all positions.
        Lanes4 mean(0.0f);
        for (const int at : {i, i + 1, i + quadrant_side + 1, i + quadrant_side})
            mean = mean + (Lanes4::load(f + at * group_size) - z);
        float* to = (below ? lower : upper) + right * group_size;
        (Lanes4::load(to) + mean * Lanes4(0.25f)).store(to);
    }
}

template <bool quadratic, bool soft>
HWY_INLINE void add_cells(const Lattice& lattice, const Net& net, int x0, int x1, int y,
                          float* upper, float* lower) {
    CrossedCell crossed;
    for (int x = x0; x < x1; ++x) {
        float *above = upper + ptrdiff_t(x) * group_size,
              *below = lower + ptrdiff_t(x) * group_size;
        const int site = lattice.vertex_site(x, y);
        switch (lattice.divisions(y)[x]) {
        case Division::down:
            add_plain_cell<quadratic, soft>(net, site, true, above, below);
            break;
        case Division::up:
            add_plain_cell<quadratic, soft>(net, site, false, above, below);
            break;
        case Division::other:
            crossed.find_triangles(lattice, x, y);
            add_crossed_cell<quadratic, soft>(net, site, crossed, above, below);
            break;
        }
    }
}

HWY_ATTR void add_means(const Lattice& lattice, Surface surface, const Net& net, int x0, int x1,
                        int y, float* upper, float* lower) {
    const bool soft = !net.soft.empty();
    if (surface == Surface::linear && soft)
        add_cells<false, true>(lattice, net, x0, x1, y, upper, lower);
    else if (surface == Surface::linear)
        add_cells<false, false>(lattice, net, x0, x1, y, upper, lower);
    else if (soft)
        add_cells<true, true>(lattice, net, x0, x1, y, upper, lower);
    else
        add_cells<true, false>(lattice, net, x0, x1, y, upper, lower);
}

HWY_ATTR void move_in_row(const float* z, int x0, int x1, const float* source, const float* sum,
                          const float* low, const float* high, float* moved, int step) {
    for (int x = x0; x < x1; ++x, z += 2 * group_size, moved += step) {
        const ptrdiff_t at = ptrdiff_t(x) * group_size;
        corrected(Lanes4::load(z), Lanes4::load(source + at), Lanes4::load(sum + at),
                  Lanes4::load(low + at), Lanes4::load(high + at))
            .store(moved);
    }
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(limits_in_row);
HWY_EXPORT(add_means);
HWY_EXPORT(move_in_row);

void add_means(const Lattice& lattice, Surface surface, const Net& net, const Rect& part, int y,
               float* upper, float* lower) {
    const int x0 = std::max(part.x0 - 1, 0), x1 = std::min(part.x1, lattice.width() - 1);
    HWY_DYNAMIC_DISPATCH(add_means)(lattice, surface, net, x0, x1, y, upper, lower);
}

LaneLimits::LaneLimits(const float* strict, float share, bool clipped)
    : lowest(clipped ? -FLT_MAX : 0.0f) {
    for (int c = 0; c < group_size; ++c) {
        limit[c] = strict[c] > 0 ? 0.0f : share;
        cut[c] = clipped && !(strict[c] > 0) ? 1.0f : 0.0f;
    }
}

void find_limits(int width, int height, const float* source, int x0, int x1, int y,
                 const LaneLimits& limits, LimitRow& row) {
    const size_t floats = size_t(width) * group_size;
    row.low.resize(floats);
    row.high.resize(floats);
    HWY_DYNAMIC_DISPATCH(limits_in_row)
    (width, height, source, x0, x1, y, limits.limit, limits.lowest, row.low.data(),
     row.high.data());
}

void move_row(const Lattice& lattice, const Net& net, int x0, int x1, int y, const float* source,
              const float* sum, const LimitRow& limits, float* moved, int step) {
    HWY_DYNAMIC_DISPATCH(move_in_row)
    (net.at(lattice.vertex_site(x0, y)), x0, x1, source, sum, limits.low.data(), limits.high.data(),
     moved, step);
}

void Consistency::begin(const Lattice& lattice, const Net& net, float limit, bool clipped) {
    source.resize(lattice.vertices() * group_size);
    float* to = source.data();
    for (int y = 0; y < lattice.height(); ++y)
        for (int x = 0; x < lattice.width(); ++x, to += group_size)
            std::memcpy(to, net.at(lattice.vertex_site(x, y)), group_size * sizeof(float));
    m_limits = {net.strict, limit, clipped};
}

const LimitRow& Consistency::limits(const Lattice& lattice, int y) {
    find_limits(lattice.width(), lattice.height(), source.data(), 0, lattice.width(), y, m_limits,
                m_row);
    return m_row;
}

void Consistency::measure(const Lattice& lattice, Surface surface, const Net& net) {
    const size_t row = size_t(lattice.width()) * group_size;
    sum.assign(source.size(), 0.0f);
    for (int y = 0; y + 1 < lattice.height(); ++y) {
        float* upper = sum.data() + size_t(y) * row;
        add_means(lattice, surface, net, lattice.all(), y, upper, upper + row);
    }
}

void Consistency::correct(const Lattice& lattice, Surface surface, Net& net) {
    const size_t row = size_t(lattice.width()) * group_size;
    measure(lattice, surface, net);
    for (int y = 1; y + 1 < lattice.height(); ++y)
        move_row(lattice, net, 1, lattice.width() - 1, y, source.data() + size_t(y) * row,
                 sum.data() + size_t(y) * row, limits(lattice, y),
                 net.at(lattice.vertex_site(1, y)), 2 * group_size);
}

} // namespace ddt
#endif
