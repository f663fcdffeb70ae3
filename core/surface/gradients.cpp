// SPDX-License-Identifier: Apache-2.0
// The gradients at a net's vertices.
#include <algorithm>
#include <cfloat>
#include <cstddef>
#include <cstring>
#include <type_traits>

#include "core/base/arith.h"
#include "core/surface/edge_scratch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/gradients.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#include "core/base/lanes-inl.h"
#include "core/base/rsqrt-inl.h"
#include "core/surface/gradient-inl.h"

using Lanes4 = Lanes<hn::CappedTag<float, group_size>>; // a lane a channel

/// A neighbour of the vertex that is walked round, over the edge between them.
struct Spoke {
    int x, y;      ///< the neighbour relative to the vertex in pixels: the edge's midpoint in
                   ///< doubled coordinates
    Lanes4 fx, fy; ///< the same
    Lanes4 dz;     ///< difference of the values

    HWY_INLINE Spoke(int x_, int y_, Lanes4 z, const float* net, int stride)
        : x(x_), y(y_), fx(float(x_)), fy(float(y_)),
          dz(Lanes4::load(net + 2 * group_size * ptrdiff_t(y_ * stride + x_)) - z) {}
};

/// The next spoke to the left or right of one; false on the rim. On the record as one number: the
/// walk is a chain of such steps, and its latency is what a gradient costs.
HWY_INLINE bool next_spoke(const Site* vertex, int stride, bool left, int& x, int& y) {
    static_assert(offsetof(Edge, v) == 0 && offsetof(Edge, left) == 2 && offsetof(Edge, right) == 4,
                  "the shifts below");
    uint64_t record;
    std::memcpy(&record, vertex + (ptrdiff_t(y) * stride + x), sizeof record);
    const bool outwards = uint16_t(record) == uint16_t((x & 255) | (y & 255) << 8);
    const auto apex = uint16_t(record >> (outwards == left ? 16 : 32));
    x = (x + int8_t(apex)) >> 1;
    y = (y + int8_t(apex >> 8)) >> 1;
    return apex != 0;
}

/// The mean gradient at a vertex: over its triangles in a fixed order, from the first edge to the
/// left, and on the hull's rim from the first edge to the right.
HWY_INLINE GradientMean<Lanes4> mean_round(const Site* vertex, const float* net, int stride) {
    GradientMean<Lanes4> mean;
    const Lanes4 z = Lanes4::load(net);
    const Vec first = vertex->vertex.first;
    const Spoke start(first.x, first.y, z, net, stride);
    Spoke last = start;
    int x = first.x, y = first.y;
    while (next_spoke(vertex, stride, true, x, y)) {
        const Spoke next(x, y, z, net, stride);
        mean.add(last.fx, last.fy, next.fx, next.fy, last.dz, next.dz);
        if (x == first.x && y == first.y)
            return mean;
        last = next;
    }
    x = first.x;
    y = first.y;
    last = start;
    while (next_spoke(vertex, stride, false, x, y)) {
        const Spoke next(x, y, z, net, stride);
        mean.add(next.fx, next.fy, last.fx, last.fy, next.dz, last.dz);
        last = next;
    }
    return mean;
}

#include "core/base/blocks-inl.h"

/// p[k] in every lane of block k.
template <class T>
HWY_INLINE T flags(const float* p) {
    if constexpr (std::is_same_v<T, Blocks>)
        return spread(p);
    else
        return T(*p);
}

/// What plain vertices of a row are surrounded by, from column 0 on.
struct PlainRows {
    const float *above, *here, *below; ///< vertices
    const float *down_above, *down_below;

    PlainRows(const NearRows& rows, int y)
        : above(rows.vertex(0, y + 2)), here(rows.vertex(0, y)), below(rows.vertex(0, y + 1)),
          down_above(rows.cell_row(y + 1).down.data()), down_below(rows.cell_row(y).down.data()) {}

    /// Gradients at vertices x, x + 1, ..., as many as T has.
    template <class T>
    HWY_INLINE void make_gradients(int x, float* to, ptrdiff_t to_y) const {
        const ptrdiff_t at = ptrdiff_t(x) * group_size;
        const T z = T::load(here + at);
        const auto difference = [&](const float* row, int dx)
                                    HWY_ATTR { return T::load(row + at + dx * group_size) - z; };
        Differences<T> d;
        d.nw = difference(above, -1);
        d.n = difference(above, 0);
        d.ne = difference(above, 1);
        d.e = difference(here, 1);
        d.se = difference(below, 1);
        d.s = difference(below, 0);
        d.sw = difference(below, -1);
        d.w = difference(here, -1);
        const T one(1.0f);
        T gx, gy;
        plain_mean(d, flags<T>(down_above + x - 1), one - flags<T>(down_above + x),
                   flags<T>(down_below + x), one - flags<T>(down_below + x - 1))
            .result(gx, gy);
        gx.store(to);
        gy.store(to + to_y);
    }
};

HWY_ATTR void make_gradients(const Lattice& lattice, const Rect& part, int y0, int y1,
                             const Net& net, EdgeScratch& scratch) {
    const int stride = lattice.stride(), last_x = lattice.width() - 1,
              last_y = lattice.height() - 1;
    if (y0 == part.y0)
        scratch.gradient_rows.begin(lattice, part, y0, net);
    const int begin = std::max(part.x0, 1), end = std::min(part.x1, last_x);
    const int step = blocks_in_vector();
    for (int y = y0; y < y1; ++y) {
        scratch.gradient_rows.load_below(lattice, part, y, net);
        const auto gradients_at = [&](int x) {
            return scratch.gradients_at(lattice.vertex_site(x, y));
        };
        const auto walk_round = [&](int x) HWY_ATTR {
            const int s = lattice.vertex_site(x, y);
            Lanes4 gx, gy;
            mean_round(lattice.sites() + s, net.at(s), stride).result(gx, gy);
            gx.store(gradients_at(x));
            gy.store(gradients_at(x) + 2 * ptrdiff_t(stride));
        };
        const PlainRows plain(scratch.gradient_rows, y);
        const uint8_t *above = scratch.gradient_rows.cell_row(y + 1).other.data(),
                      *below = scratch.gradient_rows.cell_row(y).other.data();
        const auto crossed = [&](int cell) { return above[cell] | below[cell]; };
        const auto plain_and_crossed = [&](int x) HWY_ATTR {
            plain.make_gradients<Blocks>(x, gradients_at(x), 2 * ptrdiff_t(stride));
            int any = 0;
            for (int k = x - 1; k < x + step; ++k)
                any |= crossed(k);
            for (int k = x; any && k < x + step; ++k)
                if (crossed(k - 1) | crossed(k))
                    walk_round(k);
        };
        const bool rim = y == 0 || y == last_y;
        const auto one = [&](int x) HWY_ATTR {
            if (rim || x == 0 || x == last_x || (crossed(x - 1) | crossed(x)))
                walk_round(x);
            else
                plain.make_gradients<Lanes4>(x, gradients_at(x), 2 * ptrdiff_t(stride));
        };
        each_vector(part.x0, part.x1, begin, rim ? begin : end, one, plain_and_crossed);
    }
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(make_gradients);

void make_gradients(const Lattice& lattice, const Rect& part, int y0, int y1, const Net& net,
                    EdgeScratch& scratch) {
    HWY_DYNAMIC_DISPATCH(make_gradients)(lattice, part, y0, y1, net, scratch);
}

} // namespace ddt
#endif
