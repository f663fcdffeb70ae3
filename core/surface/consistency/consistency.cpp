// SPDX-License-Identifier: Apache-2.0
#include "core/surface/consistency/consistency.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "core/base/arith.h"
#include "core/surface/near_cells.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/consistency/consistency.cpp"
#include <hwy/foreach_target.h>

#include "core/base/vectors/vectors.h"

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
#include "core/base/vectors/vectors-inl.h"

#include "core/base/vectors/lanes-inl.h"
#include "core/lattice/crossed_cell-inl.h"
#include "core/surface/consistency/consistency-inl.h"
#include "core/surface/patch-inl.h"

#include "core/base/vectors/blocks-inl.h"
#include "core/base/vectors/row_lanes-inl.h"

#include "core/surface/triangle_numbers-inl.h"

#include "core/surface/crossed_cells-inl.h"

#include "core/surface/consistency/crossed_means-inl.h"
#include "core/surface/for_surface-inl.h"

enum Quadrant : int { upper_left, upper_right, lower_left, lower_right };

/// The means of the quadrants of plain cells, `at` floats from the first. down: 1 where the
/// diagonal is down, else 0. Branch-free: a branch on the division would be mispredicted.
template <bool quadratic, bool soft, class T>
HWY_INLINE void plain_means(const CellNumbers& values, const CellNumbers& softness, ptrdiff_t at,
                            T down, T means[4]) {
    const T z0 = T::load(values.corner(at, 0, 0)), z1 = T::load(values.corner(at, 1, 0)),
            z2 = T::load(values.corner(at, 0, 1)), z3 = T::load(values.corner(at, 1, 1));
    enum { t, l, r, b, m };
    T e[5], q[5];
    if (quadratic) {
        e[t] = T::load(values.top(at)), e[l] = T::load(values.left(at));
        e[r] = T::load(values.right(at)), e[b] = T::load(values.bottom(at));
        e[m] = T::load(values.centre(at));
    }
    if (soft) {
        q[t] = T::load(softness.top(at)), q[l] = T::load(softness.left(at));
        q[r] = T::load(softness.right(at)), q[b] = T::load(softness.bottom(at));
        q[m] = T::load(softness.centre(at));
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
        return from_upper_left_to_lower_right ? either(down, through, across)
                                              : either(down, across, through);
    };
    means[upper_left] = mean(z0, z1, z2, z3, t, l, r, b, true);
    means[upper_right] = mean(z1, z0, z3, z2, t, r, l, b, false);
    means[lower_left] = mean(z2, z3, z0, z1, b, l, r, t, false);
    means[lower_right] = mean(z3, z2, z1, z0, b, r, l, t, true);
}

/// Add to the sums of vertices x0 .. x1 the means on either side of each, of cells x0 .. x1 - 1:
/// those of the cell to the left first. begin: to sums that are 0, whatever is there.
template <bool begin>
HWY_INLINE void add_quadrants(const float* left, const float* right, int x0, int x1, int count,
                              float* sums) {
    const ptrdiff_t first = ptrdiff_t(x0) * count, last = ptrdiff_t(x1) * count;
    const auto sum = [&](auto vector, ptrdiff_t at) HWY_ATTR {
        using T = decltype(vector);
        return begin ? T(0.0f) : T::load(sums + at);
    };
    for (ptrdiff_t at = first; at < first + count; ++at)
        (sum(OneLane(), at) + OneLane::load(left + at)).store(sums + at);
    each_float_once(first + count, last, [&](auto vector, ptrdiff_t at) HWY_ATTR {
        using T = decltype(vector);
        ((sum(vector, at) + T::load(right + at - count)) + T::load(left + at)).store(sums + at);
    });
    for (ptrdiff_t at = last; at < last + count; ++at)
        (sum(OneLane(), at) + OneLane::load(right + at - count)).store(sums + at);
}

template <bool quadratic, bool soft>
HWY_INLINE void add_cells(const Lattice& lattice, const ControlNet& net, int x0, int x1, int y,
                          const CrossedRows::Row& crossed, MeanScratch& scratch, float* upper,
                          float* lower) {
    const Division* divisions = lattice.divisions(y);
    const int count = net.count(), first = lattice.vertex_site(0, y);
    const size_t row = size_t(lattice.width()) * size_t(count);
    scratch.means.resize(4 * row);
    scratch.down.resize(size_t(lattice.width()) + edge_padding);
    float *means = scratch.means.data(), *down = scratch.down.data();
    flag_down(divisions, x0, x1, down);

    const NetView view(net);
    const CellNumbers values(view, view.values, first);
    CellNumbers softness;
    if (soft)
        softness = CellNumbers(view, view.soft, first);
    each_vector(x0, x1, count, [&](auto vector, const RowPlace& place) HWY_ATTR {
        using T = decltype(vector);
        T quadrants[4];
        plain_means<quadratic, soft>(values, softness, place.at, spread<T>(down, place, count),
                                     quadrants);
        for (int k = 0; k < 4; ++k)
            quadrants[k].store(means + size_t(k) * row + place.at);
    });
    const auto begin =
        std::lower_bound(crossed.cells.begin(), crossed.cells.end(), x0,
                         [](const CrossedRows::Cell& cell, int x) { return cell.x < x; });
    auto end = begin;
    while (end != crossed.cells.end() && end->x < x1)
        ++end;
    if (begin != end)
        CrossedMeans<quadratic, soft>(lattice, net, y, means, row)
            .find(&*begin, &*begin + (end - begin), crossed.triangles.data());
    add_quadrants<false>(means + size_t(upper_left) * row, means + size_t(upper_right) * row, x0,
                         x1, count, upper);
    add_quadrants<true>(means + size_t(lower_left) * row, means + size_t(lower_right) * row, x0, x1,
                        count, lower);
}

HWY_ATTR void add_means(const Lattice& lattice, Surface surface, const ControlNet& net, int x0,
                        int x1, int y, const CrossedRows::Row& crossed, MeanScratch& scratch,
                        float* upper, float* lower) {
    for_surface(net, surface, [&](auto quadratic, auto soft) HWY_ATTR {
        add_cells<decltype(quadratic)::value, decltype(soft)::value>(
            lattice, net, x0, x1, y, crossed, scratch, upper, lower);
    });
}

HWY_ATTR void move_row(const float* z, int x0, int x1, int count, const NearRows& source,
                       const float* sum, const Correction& correction, float* moved) {
    const float* const rows[3] = {source.above, source.here, source.below};
    const float limit = correction.limit, share = 0.25f * correction.strength;
    each_vector(x0, x1, count, [&](auto vector, const RowPlace& place) HWY_ATTR {
        using T = decltype(vector);
        const auto tap = [&](int i, int j)
                             HWY_ATTR { return T::load(rows[j + 1] + place.at + i * count); };
        T low, high;
        find_limits({-1, -1, 2, 2}, T(limit), correction.clipped, tap, low, high);
        corrected(T::load(z + place.at), tap(0, 0), T::load(sum + place.at), T(share), low, high)
            .store(moved + place.at);
    });
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(add_means);
HWY_EXPORT(move_row);

const CellPositions& mean_positions() {
    static const CellPositions positions = [] {
        constexpr float at[quadrant_side] = {0.125f, 0.375f, 0.625f, 0.875f};
        CellPositions all;
        all.set(at, quadrant_side, at, quadrant_side);
        return all;
    }();
    return positions;
}

void add_means(const Lattice& lattice, Surface surface, const ControlNet& net, const Rect& part,
               int y, CrossedRows& crossed, MeanScratch& scratch, float* upper, float* lower) {
    const int x0 = std::max(part.x0 - 1, 0), x1 = std::min(part.x1, lattice.width() - 1);
    if (x0 < x1)
        HWY_DYNAMIC_DISPATCH(add_means)
    (lattice, surface, net, x0, x1, y, crossed.row(y, x0, x1), scratch, upper, lower);
}

void move_row(const Lattice& lattice, const ControlNet& net, int x0, int x1, int y,
              const NearRows& source, const float* sum, const Correction& correction,
              float* moved) {
    HWY_DYNAMIC_DISPATCH(move_row)
    (net.vertex(lattice.vertex_site(0, y)), x0, x1, net.count(), source, sum, correction, moved);
}

} // namespace ddt
#endif
