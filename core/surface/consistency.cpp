// SPDX-License-Identifier: Apache-2.0
#include "core/surface/consistency.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/base/arith.h"

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
#include "core/surface/consistency-inl.h"
#include "core/surface/patch-inl.h"

using Lanes4 = Lanes<hn::CappedTag<float, group_size>>; // a lane a channel

#include "core/base/blocks-inl.h"

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

constexpr int quadrant_side = 4, quadrant_positions = quadrant_side * quadrant_side;

/// The barycentric weights of a cell's 16 positions, row by row, in a triangle that crosses it.
struct CellWeights {
    static constexpr int padding = 4 * group_size; // a vector is read from each position on
    float b0[quadrant_positions], b1[quadrant_positions], b2[quadrant_positions + padding];
    unsigned inside; ///< bit i: position i belongs to the triangle

    HWY_INLINE CellWeights(const Triangle& t, int cx, int cy) : inside(0) {
        constexpr float unit = 1.0f / float(position_one);
        const Point first = quadrant_position(cx, cy, 0);
        int32_t w[3];
        t.weights(first, w);
        // All at once: a branch a position, none of which can be foretold, takes longer.
        for (int i = 0; i < quadrant_positions; ++i) {
            constexpr int32_t step = position_one / quadrant_side;
            const int32_t x = (i % quadrant_side) * step, y = (i / quadrant_side) * step;
            const int32_t w0 = w[0] + t.e12.x * y - t.e12.y * x,
                          w1 = w[1] + t.e20.x * y - t.e20.y * x, w2 = position_one - w0 - w1;
            const int32_t outside = (w0 + t.bias[0]) | (w1 + t.bias[1]) | (w2 + t.bias[2]);
            inside |= (~unsigned(outside) >> 31) << i;
            b0[i] = float(w0) * unit;
            b1[i] = float(w1) * unit;
            b2[i] = float(w2) * unit;
        }
    }

    static HWY_INLINE Point quadrant_position(int cx, int cy, int i) {
        return {cx * position_one + (2 * (i % quadrant_side) + 1) * (position_one / 8),
                cy * position_one + (2 * (i / quadrant_side) + 1) * (position_one / 8)};
    }
};

/// The blocks whose bits are set.
HWY_INLINE hn::Mask<D> blocks_of(unsigned bits) {
    const hn::RebindToSigned<D> di;
    const auto block = hn::ShiftRight<2>(hn::Iota(di, 0));
    const auto bit = hn::Shl(hn::Set(di, 1), block);
    return hn::RebindMask(D(), hn::TestBit(hn::Set(di, int32_t(bits)), bit));
}

/// The surface over a triangle at those of a cell's positions whose bits are set, group_size lanes
/// of f each.
template <bool quadratic, bool soft, bool tame>
HWY_INLINE void evaluate_positions(Patch<Blocks>& patch, Blocks strict, const CellWeights& weights,
                                   unsigned wanted, float* f) {
    patch.template find_range<soft, tame>(strict, false);
    const int step = blocks_in_vector();
    for (int i = 0; i < quadrant_positions; i += step) {
        const unsigned bits = wanted >> i & ((1u << step) - 1);
        if (bits)
            hn::BlendedStore(patch
                                 .template at<quadratic, soft, tame>(spread(weights.b0 + i),
                                                                     spread(weights.b1 + i),
                                                                     spread(weights.b2 + i))
                                 .v,
                             blocks_of(bits), D(), f + i * group_size);
    }
}

/// The same where other edges cross the cell: by locating the positions.
template <bool quadratic, bool soft>
HWY_INLINE void add_other_cell(const Lattice& lattice, const Net& net, int cx, int cy, float* upper,
                               float* lower) {
    const Blocks strict = in_every_block(net.strict);
    HWY_ALIGN float f[quadrant_positions * group_size];
    unsigned known = 0;
    for (int i = 0; i < quadrant_positions; ++i) {
        if (known >> i & 1)
            continue;
        const Triangle triangle = locate(lattice, CellWeights::quadrant_position(cx, cy, i));
        const CellWeights weights(triangle, cx, cy);
        const unsigned found = weights.inside | 1u << i;
        Patch<Blocks> patch;
        patch.template load<quadratic, soft>(
            triangle.vertex, triangle.edge,
            [&](int s) HWY_ATTR { return in_every_block(net.at(s)); },
            [&](int s) HWY_ATTR { return in_every_block(net.soft_at(s)); });
        if (patch.is_tame())
            evaluate_positions<quadratic, soft, true>(patch, strict, weights, found, f);
        else
            evaluate_positions<quadratic, soft, false>(patch, strict, weights, found, f);
        known |= found;
    }
    for (int corner = 0; corner < 4; ++corner) {
        const int right = corner & 1, below = corner >> 1;
        const Lanes4 z = Lanes4::load(net.at(lattice.vertex_site(cx + right, cy + below)));
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
            add_other_cell<quadratic, soft>(lattice, net, x, y, above, below);
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
