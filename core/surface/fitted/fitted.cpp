// SPDX-License-Identifier: Apache-2.0
#include "core/surface/fitted/fitted.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

#include "core/base/arith.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/fitted/fitted.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#include "core/base/lanes-inl.h"
#include "core/base/rsqrt-inl.h"
#include "core/surface/consistency-inl.h"
#include "core/surface/fitted/features-inl.h"

using Lanes4 = Lanes<hn::CappedTag<float, group_size>>; // a lane a channel

#include "core/base/blocks-inl.h"

/// One vertex, or as many next to one another as T has blocks: where it goes, and its index.
template <class T, class Tap>
HWY_INLINE T move_vertex(T limit, T cut, T lowest, T sum, Tap tap, float* index) {
    const FittedTable& table = fitted_table();
    VertexFeatures<T> v;
    v.find(T(0.0f) - sum * T(0.25f), cut, table, tap);
    v.index.store(index);
    T low, high;
    find_limits({-1, -1, 2, 2}, fitted_limit(limit, v.bound, table), lowest, tap, low, high);
    return fitted_vertex(tap(0, 0), low, high, v, table);
}

HWY_ATTR void move_row(const FittedSource& source, int x0, int x1, int y, const LaneLimits& limits,
                       const float* sum, float* index, Net& net) {
    const Lattice& lattice = source.lattice;
    const int width = lattice.width(), height = lattice.height(), step = blocks_in_vector();
    const ptrdiff_t row = ptrdiff_t(width) * group_size;
    const auto inside = [&](int i, int j) HWY_ATTR { return Lanes4::load(source.at(i, j)); };
    const Lanes4 limit = Lanes4::load(limits.limit), cut = Lanes4::load(limits.cut);
    const Blocks all_limits = in_every_block(limits.limit), all_cut = in_every_block(limits.cut);
    for (int x = x0; x < x1;) {
        const ptrdiff_t at = ptrdiff_t(x) * group_size;
        float* z = net.at(lattice.vertex_site(x, y));
        if (y >= 2 && y + 2 < height && x >= 2 && x + step + 2 <= width) {
            const float* here = source.at(x, y);
            const Blocks moved = move_vertex<Blocks>(
                all_limits, all_cut, Blocks(limits.lowest), Blocks::load(sum + at),
                [&](int i, int j)
                    HWY_ATTR { return Blocks::load(here + j * row + i * group_size); },
                index + at);
            store_every_second(moved, z);
            x += step;
            continue;
        }
        const Lanes4 moved = move_vertex<Lanes4>(
            limit, cut, Lanes4(limits.lowest), Lanes4::load(sum + at),
            [&](int i, int j)
                HWY_ATTR { return odd_mirror_tap<Lanes4>(x + i, y + j, width, height, inside); },
            index + at);
        if (x > 0 && y > 0 && x + 1 < width && y + 1 < height)
            moved.store(z);
        ++x;
    }
}

/// The weights of an edge's null features, node after node.
struct NullWeights {
    static constexpr int count = fitted_nodes * fitted_edge_null;
    HWY_ALIGN float w[count];

    HWY_INLINE NullWeights(const Edge& e, float gain, const FittedTable& table) {
        const auto& kinds = table.null[fitted_length(e.v.x, e.v.y)];
        if (!e.flippable()) {
            std::copy_n(&kinds[0][0][0], count, w);
            return;
        }
        const float loss = gain < 0.0f ? gain : 0.0f;
        const float t = 1.0f + loss * table.gain_scale;
        const Lanes4 near(t > 0.0f ? t : 0.0f);
        for (int k = 0; k < fitted_nodes; ++k)
            (Lanes4::load(kinds[1][k]) + near * Lanes4::load(kinds[2][k]))
                .store(w + k * fitted_edge_null);
    }
};

/// Whether all pixels that the features of the edge with midpoint (mx, my), in doubled coordinates,
/// are made of lie within the picture.
HWY_INLINE bool reaches_inside(const Edge& e, int mx, int my, int width, int height) {
    const auto fits = [](int m, int v, int left, int right, int size) {
        const int along = std::abs(v), aside = std::max(std::abs(left), std::abs(right));
        const int far = std::max(5 * along, 3 * aside + 2 * along);
        return m >= far && m + far <= 2 * (size - 1);
    };
    return fits(mx, e.v.x, e.left.x, e.right.x, width) &&
           fits(my, e.v.y, e.left.y, e.right.y, height);
}

HWY_ATTR void bend_row(const FittedSource& source, int x0, int x1, int my, const float* gain,
                       const IndexRows& index, const Net& plain_net, Net& net) {
    const FittedTable& table = fitted_table();
    const Lattice& lattice = source.lattice;
    const int width = lattice.width(), height = lattice.height();
    const ptrdiff_t row = ptrdiff_t(width) * group_size;
    const auto inside = [&](int i, int j) HWY_ATTR { return Lanes4::load(source.at(i, j)); };
    const auto mirrored = [&](Place p) HWY_ATTR {
        return odd_mirror_tap<Lanes4>(p.x, p.y, width, height, inside);
    };
    const auto plain_tap = [&](ptrdiff_t at) HWY_ATTR { return Lanes4::load(source.pixels + at); };
    const auto address = [&](int x, int y) { return y * row + ptrdiff_t(x) * group_size; };
    const Lanes4 strict = Lanes4::load(net.strict);
    for (int mx = 2 * x0 + 1 - (my & 1); mx < 2 * x1 - 1; mx += 2 - (my & 1)) {
        const int m = lattice.site(mx, my);
        const Edge& edge = lattice.edge(m);
        // A missing apex mirrors the other.
        const Vec v = edge.v, l = edge.left.zero() ? -edge.right : edge.left,
                  r = edge.right.zero() ? -edge.left : edge.right;
        const Place a{(mx - v.x) / 2, (my - v.y) / 2};
        const Lanes4 plain = Lanes4::load(plain_net.at(m));
        EdgeFeatures<Lanes4> f;
        if (reaches_inside(edge, mx, my, width, height))
            f.find(address(a.x, a.y), address(v.x, v.y), address(l.x, l.y), address(r.x, r.y),
                   plain, plain_tap);
        else
            f.find(a, {v.x, v.y}, {l.x, l.y}, {r.x, r.y}, plain, mirrored);
        const Lanes4 mean =
            (Lanes4::load(index.at(a.x, a.y)) + Lanes4::load(index.at(a.x + v.x, a.y + v.y))) *
            Lanes4(0.5f);
        const NullWeights null(edge, gain[m], table);
        fitted_bend(f, mean, strict, null.w, table).store(net.at(m));
    }
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(move_row);
HWY_EXPORT(bend_row);

void move_fitted(const FittedSource& source, int x0, int x1, int y, const LaneLimits& limits,
                 const float* sum, float* index, Net& net) {
    HWY_DYNAMIC_DISPATCH(move_row)(source, x0, x1, y, limits, sum, index, net);
}

void bend_fitted(const FittedSource& source, int x0, int x1, int y, const float* gain,
                 const IndexRows& index, const Net& plain, Net& net) {
    HWY_DYNAMIC_DISPATCH(bend_row)(source, x0, x1, y, gain, index, plain, net);
}

} // namespace ddt
#endif
