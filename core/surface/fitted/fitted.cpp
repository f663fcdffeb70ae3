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
#include "core/surface/fitted/features-inl.h"

using Lanes4 = Lanes<hn::CappedTag<float, group_size>>; // a lane a channel

#include "core/base/blocks-inl.h"

/// One vertex, or as many next to one another as T has blocks: where it goes, and its index.
template <class T, class Tap>
HWY_INLINE T move_vertex(const Consistency& c, size_t at, Tap tap, float* index) {
    const FittedTable& table = fitted_table();
    VertexFeatures<T> v;
    v.find(T(0.0f) - T::load(&c.sum[at]) * T(0.25f), table, tap);
    v.index.store(index);
    return fitted_vertex(T::load(&c.source[at]), T::load(&c.low[at]), T::load(&c.high[at]), v,
                         table);
}

HWY_ATTR void move_vertices(const Lattice& lattice, const Rect& part, const Consistency& c,
                            float* index, Net& net) {
    const int width = lattice.width(), height = lattice.height(), step = blocks_in_vector();
    const ptrdiff_t row = ptrdiff_t(width) * group_size;
    const float* source = c.source.data();
    const auto inside = [&](int x, int y)
                            HWY_ATTR { return Lanes4::load(source + y * row + x * group_size); };
    for (int y = part.y0; y < part.y1; ++y)
        for (int x = part.x0; x < part.x1;) {
            const size_t at = size_t(y * row) + size_t(x) * group_size;
            float* z = net.at(lattice.vertex_site(x, y));
            if (y >= 2 && y + 2 < height && x >= 2 && x + step + 2 <= width) {
                const Blocks moved = move_vertex<Blocks>(
                    c, at,
                    [&](int i, int j)
                        HWY_ATTR { return Blocks::load(source + at + j * row + i * group_size); },
                    index + at);
                store_every_second(moved, z);
                x += step;
                continue;
            }
            const Lanes4 moved = move_vertex<Lanes4>(
                c, at,
                [&](int i, int j) HWY_ATTR {
                    return odd_mirror_tap<Lanes4>(x + i, y + j, width, height, inside);
                },
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

HWY_ATTR void bend_edges(const Lattice& lattice, const Rect& part, const float* gain,
                         const Consistency& c, const float* index, Net& net) {
    const FittedTable& table = fitted_table();
    const int width = lattice.width(), height = lattice.height();
    const ptrdiff_t row = ptrdiff_t(width) * group_size;
    const float* source = c.source.data();
    const auto inside = [&](int x, int y)
                            HWY_ATTR { return Lanes4::load(source + y * row + x * group_size); };
    const auto mirrored = [&](Place p) HWY_ATTR {
        return odd_mirror_tap<Lanes4>(p.x, p.y, width, height, inside);
    };
    const auto plain_tap = [&](ptrdiff_t at) HWY_ATTR { return Lanes4::load(source + at); };
    const auto address = [&](int x, int y) { return y * row + ptrdiff_t(x) * group_size; };
    const Lanes4 strict = Lanes4::load(net.strict);
    for (int my = 2 * part.y0; my < 2 * part.y1 - 1; ++my)
        for (int mx = 2 * part.x0 + 1 - (my & 1); mx < 2 * part.x1 - 1; mx += 2 - (my & 1)) {
            const int m = lattice.site(mx, my);
            const Edge& edge = lattice.edge(m);
            // A missing apex mirrors the other.
            const Vec v = edge.v, l = edge.left.zero() ? -edge.right : edge.left,
                      r = edge.right.zero() ? -edge.left : edge.right;
            const Place a{(mx - v.x) / 2, (my - v.y) / 2};
            const ptrdiff_t at_a = address(a.x, a.y), to_b = address(v.x, v.y);
            const Lanes4 plain = Lanes4::load(net.at(m));
            EdgeFeatures<Lanes4> f;
            if (reaches_inside(edge, mx, my, width, height))
                f.find(at_a, to_b, address(l.x, l.y), address(r.x, r.y), plain, plain_tap);
            else
                f.find(a, {v.x, v.y}, {l.x, l.y}, {r.x, r.y}, plain, mirrored);
            const Lanes4 mean =
                (Lanes4::load(index + at_a) + Lanes4::load(index + at_a + to_b)) * Lanes4(0.5f);
            const NullWeights null(edge, gain[m], table);
            fitted_bend(f, mean, strict, null.w, table).store(net.at(m));
        }
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(move_vertices);
HWY_EXPORT(bend_edges);

void Fitted::move_vertices(const Lattice& lattice, const Consistency& consistency, Net& net) {
    move_vertices(lattice, {0, 0, lattice.width(), lattice.height()}, consistency, net);
}

void Fitted::move_vertices(const Lattice& lattice, const Rect& part, const Consistency& consistency,
                           Net& net) {
    index.resize(consistency.source.size());
    HWY_DYNAMIC_DISPATCH(move_vertices)(lattice, part, consistency, index.data(), net);
}

void Fitted::bend_edges(const Lattice& lattice, const Rect& part, const float* gain,
                        const Consistency& consistency, Net& net) const {
    HWY_DYNAMIC_DISPATCH(bend_edges)(lattice, part, gain, consistency, index.data(), net);
}

} // namespace ddt
#endif
