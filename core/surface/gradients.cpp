// SPDX-License-Identifier: Apache-2.0
// The gradients at a net's vertices.
#include <algorithm>
#include <cstddef>

#include "core/base/arith.h"
#include "core/base/vectors/row_lanes.h"
#include "core/lattice/fans.h"
#include "core/surface/edge_scratch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/gradients.cpp"
#include <hwy/foreach_target.h>

#include "core/base/vectors/vectors.h"

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
#include "core/base/vectors/vectors-inl.h"

#include "core/base/rsqrt-inl.h"
#include "core/base/vectors/lanes-inl.h"
#include "core/surface/gradient-inl.h"

#include "core/base/vectors/blocks-inl.h"
#include "core/base/vectors/row_lanes-inl.h"

#include "core/surface/fan_means-inl.h"

/// A neighbour of the vertex that is walked round, over the edge between them.
struct Spoke {
    int x, y;          ///< the neighbour relative to the vertex in pixels: the edge's midpoint in
                       ///< doubled coordinates
    PixelLanes fx, fy; ///< the same
    PixelLanes dz;     ///< difference of the values

    HWY_INLINE Spoke(int x_, int y_, PixelLanes z, const float* net, int stride, int count)
        : x(x_), y(y_), fx(float(x_)), fy(float(y_)),
          dz(PixelLanes::load(net + count * ptrdiff_t(y_ * stride + x_)) - z) {}
};

/// The mean gradient at a vertex on the rim, or any: over its triangles in a fixed order, from the
/// first edge to the left, and on the hull's rim from the first edge to the right.
template <bool tame>
HWY_INLINE GradientMean<PixelLanes, tame> mean_round(const Site* vertex, const float* net,
                                                     int stride, int count) {
    GradientMean<PixelLanes, tame> mean;
    const PixelLanes z = PixelLanes::load(net);
    const Vec first = vertex->vertex.first;
    const Spoke start(first.x, first.y, z, net, stride, count);
    Spoke last = start;
    int x = first.x, y = first.y;
    while (next_spoke(vertex, stride, true, x, y)) {
        const Spoke next(x, y, z, net, stride, count);
        mean.add(last.fx, last.fy, next.fx, next.fy, last.dz, next.dz);
        if (x == first.x && y == first.y)
            return mean;
        last = next;
    }
    x = first.x;
    y = first.y;
    last = start;
    while (next_spoke(vertex, stride, false, x, y)) {
        const Spoke next(x, y, z, net, stride, count);
        mean.add(next.fx, next.fy, last.fx, last.fy, next.dz, last.dz);
        last = next;
    }
    return mean;
}

/// The gradients at the vertices of a group of fans; gradients, to_y: see RegularVertices.
template <bool tame>
HWY_INLINE void make_group(const Fans::Group& group, const Spokes& spokes, const float* vertices,
                           int count, float* gradients, ptrdiff_t to_y) {
    const int blocks = blocks_in_vector();
    for (int i = 0; i < fans_side_by_side; i += blocks) {
        Blocks gx, gy;
        means_of_fans<tame>(group, i, spokes, vertices, count).result(gx, gy);
        HWY_ALIGN float x[fans_side_by_side * group_size], y[fans_side_by_side * group_size];
        gx.store(x);
        gy.store(y);
        for (int b = 0; b < blocks; ++b) {
            float* to = gradients + ptrdiff_t(group.x[i + b]) * count;
            store_pixel(PixelLanes::load(x + b * group_size), count, to);
            store_pixel(PixelLanes::load(y + b * group_size), count, to + to_y);
        }
    }
}

/// What regular vertices of a row, whose four cells are plain, are surrounded by, from column 0 on.
struct RegularVertices {
    const float *above, *here, *below; ///< vertices
    const float *down_above, *down_below;
    int count; ///< of channels

    RegularVertices(const Lattice& lattice, const ControlNet& net, const NearCells& cells, int y)
        : above(vertex_row(lattice, net, y - 1)), here(vertex_row(lattice, net, y)),
          below(vertex_row(lattice, net, y + 1)), down_above(cells.above(y)),
          down_below(cells.below(y)), count(net.count()) {}

    /// Gradients of vertices at a place. gradients: those of column 0, y `to_y` floats after x.
    template <bool tame, class T>
    HWY_INLINE void make_gradients(const RowPlace& place, float* gradients, ptrdiff_t to_y) const {
        const ptrdiff_t at = place.at;
        const T z = T::load(here + at);
        const auto difference = [&](const float* row, int dx)
                                    HWY_ATTR { return T::load(row + at + dx * count) - z; };
        const auto down = [&](const float* row) HWY_ATTR { return spread<T>(row, place, count); };
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
        regular_mean<tame>(d, down(down_above - 1), one - down(down_above), down(down_below),
                           one - down(down_below - 1))
            .result(gx, gy);
        gx.store(gradients + at);
        gy.store(gradients + at + to_y);
    }
};

template <bool tame>
HWY_INLINE void make_any(const Lattice& lattice, const Rect& part, int y0, int y1,
                         const ControlNet& net, EdgeScratch& scratch) {
    const int stride = lattice.stride(), last_x = lattice.width() - 1,
              last_y = lattice.height() - 1;
    if (y0 == part.y0)
        scratch.gradient_cells.begin(lattice, part, y0);
    const int begin = std::max(part.x0, 1), end = std::min(part.x1, last_x), count = net.count();
    for (int y = y0; y < y1; ++y) {
        const NearCells& cells = scratch.gradient_cells;
        scratch.gradient_cells.load_below(lattice, part, y);
        float* gradients = scratch.gradients.at(lattice.vertex_site(0, y));
        const ptrdiff_t to_y = ptrdiff_t(lattice.width()) * count;
        const RegularVertices regular(lattice, net, cells, y);
        const bool rim = y == 0 || y == last_y;
        if (!rim && begin < end)
            each_vector(begin, end, count, [&](auto vector, const RowPlace& place) HWY_ATTR {
                regular.make_gradients<tame, decltype(vector)>(place, gradients, to_y);
            });
        const auto walk = [&](int x) HWY_ATTR {
            const int s = lattice.vertex_site(x, y);
            PixelLanes gx, gy;
            mean_round<tame>(lattice.sites() + s, net.vertex(s), stride, count).result(gx, gy);
            float* to = gradients + ptrdiff_t(x) * count;
            store_pixel(gx, count, to);
            store_pixel(gy, count, to + to_y);
        };
        if (rim || begin >= end) {
            for (int x = part.x0; x < part.x1; ++x)
                walk(x);
            continue;
        }
        const Fans& fans = scratch.fans->row(y, begin, end);
        for (const Fans::Group& group : fans.groups) {
            if (group.x[fans_side_by_side - 1] < begin || group.x[0] >= end)
                continue;
            load_spokes(fans.spokes.data() + group.first,
                        size_t(group.most + 1) * fans_side_by_side, stride * count, count,
                        scratch.spokes);
            make_group<tame>(group, scratch.spokes, net.vertex(lattice.vertex_site(0, y)), count,
                             gradients, to_y);
        }
        if (part.x0 < begin)
            walk(part.x0);
        if (end < part.x1)
            walk(end);
    }
}

HWY_ATTR void make_gradients(const Lattice& lattice, const Rect& part, int y0, int y1,
                             const ControlNet& net, EdgeScratch& scratch) {
    if (scratch.tame)
        make_any<true>(lattice, part, y0, y1, net, scratch);
    else
        make_any<false>(lattice, part, y0, y1, net, scratch);
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(make_gradients);

void make_gradients(const Lattice& lattice, const Rect& part, int y0, int y1, const ControlNet& net,
                    EdgeScratch& scratch) {
    HWY_DYNAMIC_DISPATCH(make_gradients)(lattice, part, y0, y1, net, scratch);
}

} // namespace ddt
#endif
