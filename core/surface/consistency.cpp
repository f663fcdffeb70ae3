// SPDX-License-Identifier: Apache-2.0
#include "core/surface/consistency.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/base/arith.h"
#include "core/surface/edge_scratch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/consistency.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

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

enum Quadrant : int { upper_left, upper_right, lower_left, lower_right };

/// The means of the quadrants of plain cells, T a cell's or several's, the first of which has its
/// first corner at `site`. down: 1 where the diagonal is down, else 0. at, soft_at: what the net
/// has there and at every second site on. A branch on the division could not be foretold.
template <bool quadratic, bool soft, class T, class At, class SoftAt>
HWY_INLINE void plain_means(int site, int stride, T down, At at, SoftAt soft_at, T means[4]) {
    const T z0 = at(site), z1 = at(site + 2), z2 = at(site + 2 * stride),
            z3 = at(site + 2 * stride + 2);
    enum { t, l, r, b, m };
    const int edges[5] = {site + 1, site + stride, site + stride + 2, site + 2 * stride + 1,
                          site + stride + 1};
    T e[5], q[5];
    for (int i = 0; i < 5; ++i) {
        if (quadratic)
            e[i] = at(edges[i]);
        if (soft)
            q[i] = soft_at(edges[i]);
    }
    const auto mean = [&](T v, T x, T y, T d, int vx, int vy, int xd, int yd,
                          bool from_upper_left_to_lower_right) HWY_ATTR {
        QuadrantCell<T> c;
        c.v = v, c.x = x, c.y = y, c.d = d;
        if (quadratic)
            c.vx = e[vx], c.vy = e[vy], c.xd = e[xd], c.yd = e[yd], c.diagonal = e[m];
        if (soft)
            c.qvx = q[vx], c.qvy = q[vy], c.qxd = q[xd], c.qyd = q[yd], c.q_diagonal = q[m];
        const T through = c.template through<quadratic, soft>(),
                across = c.template across<quadratic, soft>();
        return from_upper_left_to_lower_right ? if_less(T(0.0f), down, through, across)
                                              : if_less(T(0.0f), down, across, through);
    };
    means[upper_left] = mean(z0, z1, z2, z3, t, l, r, b, true);
    means[upper_right] = mean(z1, z0, z3, z2, t, r, l, b, false);
    means[lower_left] = mean(z2, z3, z0, z1, b, l, r, t, false);
    means[lower_right] = mean(z3, z2, z1, z0, b, r, l, t, true);
}

/// The same of a cell that other edges cross, by the scratch's triangles.
template <bool quadratic, bool soft>
HWY_INLINE void crossed_means(const Net& net, int site, const MeanScratch& scratch,
                              Lanes4 means[4]) {
    HWY_ALIGN float f[quadrant_side * quadrant_side * group_size]; // whole vectors
    evaluate_crossing<quadratic, soft>(net, in_every_block(net.strict), false,
                                       scratch.triangles.data(), scratch.triangles.size(),
                                       scratch.positions, f);
    for (int corner = 0; corner < 4; ++corner) {
        const int right = corner & 1, below = corner >> 1;
        const Lanes4 z = Lanes4::load(net.at(site + 2 * right + 2 * below * net.stride));
        const int i = 2 * right + 2 * below * quadrant_side;
        // In the order back and forth through all positions.
        Lanes4 mean(0.0f);
        for (const int at : {i, i + 1, i + quadrant_side + 1, i + quadrant_side})
            mean = mean + (Lanes4::load(f + at * group_size) - z);
        means[corner] = mean * Lanes4(0.25f);
    }
}

/// Add to the sums of vertices x0 .. x1 the means on either side of each, of cells x0 .. x1 - 1:
/// those of the cell to the left first.
HWY_INLINE void add_quadrants(const float* left, const float* right, int x0, int x1, float* sums) {
    const auto add = [&](auto sum, ptrdiff_t at) HWY_ATTR {
        using T = decltype(sum);
        ((T::load(sums + at) + T::load(right + at - group_size)) + T::load(left + at))
            .store(sums + at);
    };
    const auto add_one = [&](const float* mean, int of, int to) HWY_ATTR {
        float* sum = sums + ptrdiff_t(to) * group_size;
        (Lanes4::load(sum) + Lanes4::load(mean + ptrdiff_t(of) * group_size)).store(sum);
    };
    add_one(left, x0, x0);
    int x = x0 + 1;
    for (const int step = blocks_in_vector(); x + step <= x1; x += step)
        add(Blocks(), ptrdiff_t(x) * group_size);
    for (; x < x1; ++x)
        add(Lanes4(), ptrdiff_t(x) * group_size);
    add_one(right, x1 - 1, x1);
}

template <bool quadratic, bool soft>
HWY_INLINE void add_cells(const Lattice& lattice, const Net& net, int x0, int x1, int y,
                          MeanScratch& scratch, float* upper, float* lower) {
    const Division* divisions = lattice.divisions(y);
    const size_t row = size_t(lattice.width()) * group_size;
    scratch.means.resize(4 * row);
    const auto store = [&](int x, const auto* means) HWY_ATTR {
        for (int k = 0; k < 4; ++k)
            means[k].store(scratch.means.data() + size_t(k) * row + ptrdiff_t(x) * group_size);
    };
    scratch.down.resize(size_t(lattice.width()) + edge_padding);
    float* down = scratch.down.data();
    flag_down(divisions, x0, x1, down);

    const auto one = [&](int x) HWY_ATTR {
        const auto at = [&](int s) HWY_ATTR { return Lanes4::load(net.at(s)); };
        const auto soft_at = [&](int s) HWY_ATTR { return Lanes4::load(net.soft_at(s)); };
        Lanes4 means[4];
        plain_means<quadratic, soft>(lattice.vertex_site(x, y), net.stride, Lanes4(down[x]), at,
                                     soft_at, means);
        store(x, means);
    };
    const auto several = [&](int x) HWY_ATTR {
        const auto at = [&](int s) HWY_ATTR { return load_every_second(net.at(s)); };
        const auto soft_at = [&](int s) HWY_ATTR { return load_every_second(net.soft_at(s)); };
        Blocks means[4];
        plain_means<quadratic, soft>(lattice.vertex_site(x, y), net.stride,
                                     in_order(spread(down + x)), at, soft_at, means);
        for (Blocks& mean : means)
            mean = in_order(mean);
        store(x, means);
    };
    each_vector(x0, x1, x0, x1, one, several);
    for (int x = x0; x < x1; ++x) {
        if (divisions[x] != Division::other)
            continue;
        scratch.triangles.clear();
        find_crossing_triangles(lattice, x, y, scratch.positions, scratch.triangles);
        Lanes4 means[4];
        crossed_means<quadratic, soft>(net, lattice.vertex_site(x, y), scratch, means);
        store(x, means);
    }
    const auto quadrants = [&](Quadrant k) { return scratch.means.data() + size_t(k) * row; };
    add_quadrants(quadrants(upper_left), quadrants(upper_right), x0, x1, upper);
    add_quadrants(quadrants(lower_left), quadrants(lower_right), x0, x1, lower);
}

HWY_ATTR void add_means(const Lattice& lattice, Surface surface, const Net& net, int x0, int x1,
                        int y, MeanScratch& scratch, float* upper, float* lower) {
    const bool soft = !net.soft.empty();
    if (surface == Surface::linear && soft)
        add_cells<false, true>(lattice, net, x0, x1, y, scratch, upper, lower);
    else if (surface == Surface::linear)
        add_cells<false, false>(lattice, net, x0, x1, y, scratch, upper, lower);
    else if (soft)
        add_cells<true, true>(lattice, net, x0, x1, y, scratch, upper, lower);
    else
        add_cells<true, false>(lattice, net, x0, x1, y, scratch, upper, lower);
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

MeanScratch::MeanScratch() {
    constexpr float at[quadrant_side] = {0.125f, 0.375f, 0.625f, 0.875f};
    positions.set(at, quadrant_side, at, quadrant_side);
}

void add_means(const Lattice& lattice, Surface surface, const Net& net, const Rect& part, int y,
               MeanScratch& scratch, float* upper, float* lower) {
    const int x0 = std::max(part.x0 - 1, 0), x1 = std::min(part.x1, lattice.width() - 1);
    if (x0 < x1)
        HWY_DYNAMIC_DISPATCH(add_means)(lattice, surface, net, x0, x1, y, scratch, upper, lower);
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
        add_means(lattice, surface, net, lattice.all(), y, m_scratch, upper, upper + row);
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
