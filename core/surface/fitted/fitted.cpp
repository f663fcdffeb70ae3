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

#include "core/base/row_lanes-inl.h"

/// Where vertices go, and their index.
template <class T, class Tap>
HWY_INLINE T move_vertex(T limit, T cut, float lowest, T sum, Tap tap, T& index) {
    const FittedTable& table = fitted_table();
    VertexFeatures<T> v;
    v.find(T(0.0f) - sum * T(0.25f), cut, table, tap);
    index = v.index;
    T low, high;
    find_limits({-1, -1, 2, 2}, fitted_limit(limit, v.bound, table), T(lowest), tap, low, high);
    return fitted_vertex(tap(0, 0), low, high, v, table);
}

HWY_ATTR void move_row(const FittedSource& source, int x0, int x1, int y, const LaneLimits& limits,
                       const float* sum, float* index, Net& net) {
    const Lattice& lattice = source.lattice;
    const int width = lattice.width(), height = lattice.height(), count = source.count;
    const ptrdiff_t row = ptrdiff_t(width) * count;
    float* const z = net.vertex(lattice.vertex_site(0, y));
    const float* const here = source.at(0, y);
    // Where all taps are pixels.
    const bool inner = y >= 2 && y + 2 < height;
    const int begin = inner ? std::max(x0, 2) : x1, end = std::max(std::min(x1, width - 2), begin);
    const ChannelLanes limit(limits.limit, count), cut(limits.cut, count);
    each_vector(begin, end, count, [&](auto vector, const RowPlace& place) HWY_ATTR {
        using T = decltype(vector);
        const auto tap = [&](int i, int j)
                             HWY_ATTR { return T::load(here + place.at + j * row + i * count); };
        T at;
        move_vertex(limit.at<T>(place), cut.at<T>(place), limits.lowest, T::load(sum + place.at),
                    tap, at)
            .store(z + place.at);
        at.store(index + place.at);
    });
    const auto inside = [&](int i, int j) HWY_ATTR { return PixelLanes::load(source.at(i, j)); };
    const auto one = [&](int x) HWY_ATTR {
        const auto tap = [&](int i, int j) HWY_ATTR {
            return odd_mirror_tap<PixelLanes>(x + i, y + j, width, height, inside);
        };
        const ptrdiff_t at = ptrdiff_t(x) * count;
        PixelLanes found;
        const PixelLanes moved =
            move_vertex(PixelLanes::load(limits.limit), PixelLanes::load(limits.cut), limits.lowest,
                        PixelLanes::load(sum + at), tap, found);
        if (x > 0 && y > 0 && x + 1 < width && y + 1 < height)
            store_pixel(moved, count, z + at);
        store_pixel(found, count, index + at);
    };
    for (int x = x0; x < x1; ++x)
        if (x < begin || x >= end)
            one(x);
}

/// The weights of an edge's null features, node after node.
struct NullWeights {
    static constexpr int count = fitted_nodes * fitted_edge_null;
    HWY_ALIGN float w[count];

    HWY_INLINE NullWeights(const Edge& e, const FittedTable& table) {
        const auto& kinds = table.null[fitted_length(e.v.x, e.v.y)];
        if (!e.flippable()) {
            std::copy_n(&kinds[0][0][0], count, w);
            return;
        }
        const float gain = e.gain(), loss = gain < 0.0f ? gain : 0.0f;
        const float t = 1.0f + loss * table.gain_scale;
        const PixelLanes near(t > 0.0f ? t : 0.0f);
        for (int k = 0; k < fitted_nodes; ++k)
            (PixelLanes::load(kinds[1][k]) + near * PixelLanes::load(kinds[2][k]))
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
    const Vec right = e.right();
    return fits(mx, e.v.x, e.left.x, right.x, width) && fits(my, e.v.y, e.left.y, right.y, height);
}

HWY_ATTR void bend_row(const FittedSource& source, int x0, int x1, int my, const IndexRows& index,
                       const Net& plain_net, Net& net) {
    const FittedTable& table = fitted_table();
    const Lattice& lattice = source.lattice;
    const int width = lattice.width(), height = lattice.height();
    const int count = source.count;
    const ptrdiff_t row = ptrdiff_t(width) * count;
    const auto inside = [&](int i, int j) HWY_ATTR { return PixelLanes::load(source.at(i, j)); };
    const auto mirrored = [&](Place p) HWY_ATTR {
        return odd_mirror_tap<PixelLanes>(p.x, p.y, width, height, inside);
    };
    const auto plain_tap = [&](ptrdiff_t at)
                               HWY_ATTR { return PixelLanes::load(source.pixels + at); };
    const auto address = [&](int x, int y) { return y * row + ptrdiff_t(x) * count; };
    const PixelLanes strict = PixelLanes::load(net.strict);
    for (int mx = 2 * x0 + 1 - (my & 1); mx < 2 * x1 - 1; mx += 2 - (my & 1)) {
        const int m = lattice.site(mx, my);
        const Edge& edge = lattice.edge(m);
        // A missing apex mirrors the other.
        const Vec right = edge.right(), v = edge.v, l = edge.left.zero() ? -right : edge.left,
                  r = right.zero() ? -edge.left : right;
        const Place a{(mx - v.x) / 2, (my - v.y) / 2};
        const PixelLanes plain = PixelLanes::load(plain_net.at(m));
        EdgeFeatures<PixelLanes> f;
        if (reaches_inside(edge, mx, my, width, height))
            f.find(address(a.x, a.y), address(v.x, v.y), address(l.x, l.y), address(r.x, r.y),
                   plain, plain_tap);
        else
            f.find(a, {v.x, v.y}, {l.x, l.y}, {r.x, r.y}, plain, mirrored);
        const PixelLanes mean = (PixelLanes::load(index.at(a.x, a.y)) +
                                 PixelLanes::load(index.at(a.x + v.x, a.y + v.y))) *
                                PixelLanes(0.5f);
        const NullWeights null(edge, table);
        store_pixel(fitted_bend(f, mean, strict, null.w, table), count, net.at(m));
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

void bend_fitted(const FittedSource& source, int x0, int x1, int y, const IndexRows& index,
                 const Net& plain, Net& net) {
    HWY_DYNAMIC_DISPATCH(bend_row)(source, x0, x1, y, index, plain, net);
}

} // namespace ddt
#endif
