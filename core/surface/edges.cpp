// SPDX-License-Identifier: Apache-2.0
// The bends and softness of a net's edges.
#include <algorithm>
#include <cstddef>

#include "core/base/arith.h"
#include "core/base/vectors/gathers.h"
#include "core/base/vectors/row_lanes.h"
#include "core/guide/contour.h"
#include "core/surface/edge_kinds.h"
#include "core/surface/edge_scratch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/edges.cpp"
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

using DI = hn::RebindToSigned<D>;

#include "core/lattice/site_lanes-inl.h"

#include "core/surface/irregular_edges-inl.h"

/// Weights of the flipped states (see control_net.h), 0 to 1/2, of edges at n pairs of sites of a
/// row: those of the first, third, ... go to even[0], even[1], ... Edges that cannot be flipped
/// have gains that are far below 0, and what vertices have is of no account.
HWY_ATTR void soft_weights(const Site* sites, int n, float reciprocal_tau, float* even,
                           float* odd) {
    const auto weigh = [&](auto gain)
                           HWY_ATTR { return soft_weight(gain, decltype(gain)(reciprocal_tau)); };
    const RowTag d;
    const int lanes = int(hn::Lanes(d));
    int i = 0;
    for (; i + lanes <= n; i += lanes) {
        static_assert(sizeof(Site) == 8 && offsetof(Edge, word) == 4, "the second of two");
        const auto* words = reinterpret_cast<const float*>(sites + 2 * i);
        const auto load = [&](int k) HWY_ATTR { return hn::LoadU(d, words + k * lanes); };
        const auto gains = hn::ConcatOdd(d, load(1), load(0)),
                   more = hn::ConcatOdd(d, load(3), load(2));
        const auto first = hn::ConcatEven(d, more, gains), second = hn::ConcatOdd(d, more, gains);
        weigh(RowLanes(first)).store(even + i);
        weigh(RowLanes(second)).store(odd + i);
    }
    for (; i < n; ++i) {
        weigh(OneLane(sites[2 * i].edge.gain())).store(even + i);
        weigh(OneLane(sites[2 * i + 1].edge.gain())).store(odd + i);
    }
}

/// Neighbouring regular edges: what belongs to their ends i and j and their apexes c and d.
template <class T>
struct RegularEdges {
    T zi, zj, zc, zd, gix, giy, gjx, gjy, vx, vy;
};

/// What regular edges at or beside the vertices of a row are made from, from column 0 on.
struct RegularRow {
    const float* vertices[3];  ///< of the rows above, at and below
    const float* down_rows[2]; ///< of the cells above and below
    const float* gradients;    ///< x of those of the row
    ptrdiff_t to_y;            ///< from a gradient's x to its y
    int count;                 ///< of channels

    /// Without bends there are no gradients.
    RegularRow(const Lattice& lattice, const ControlNet& net, const NearCells& cells, int y,
               const float* gradients_)
        : vertices{vertex_row(lattice, net, y - 1), vertex_row(lattice, net, y),
                   vertex_row(lattice, net, y + 1)},
          down_rows{cells.above(y), cells.below(y)}, gradients(gradients_),
          to_y(ptrdiff_t(lattice.width()) * net.count()), count(net.count()) {}

    /// Edges of a kind at a place, as T has.
    template <EdgeKind kind, bool bend, class T>
    HWY_INLINE RegularEdges<T> edges(const RowPlace& place) const {
        const auto z = [&](int dx, int dy)
                           HWY_ATTR { return T::load(vertices[dy + 1] + place.at + dx * count); };
        const auto gx = [&](int dx, int dy) HWY_ATTR {
            return T::load(gradients + 2 * dy * to_y + place.at + dx * count);
        };
        const auto gy = [&](int dx, int dy) HWY_ATTR {
            return T::load(gradients + (2 * dy + 1) * to_y + place.at + dx * count);
        };
        // 1 where cell (x + dx, y + dy)'s diagonal is down.
        const auto down = [&](int dx, int dy)
                              HWY_ATTR { return spread<T>(down_rows[dy + 1] + dx, place, count); };
        RegularEdges<T> e;
        if constexpr (kind == EdgeKind::horizontal) { // from (x, y) to (x + 1, y)
            e.zi = z(0, 0), e.zj = z(1, 0);
            e.zc = either(down(0, 0), z(1, 1), z(0, 1));
            e.zd = either(down(0, -1), z(0, -1), z(1, -1));
            if (bend)
                e.gix = gx(0, 0), e.giy = gy(0, 0), e.gjx = gx(1, 0), e.gjy = gy(1, 0);
            e.vx = T(1.0f), e.vy = T(0.0f);
        } else if constexpr (kind == EdgeKind::vertical) { // from (x, y) to (x, y + 1)
            e.zi = z(0, 0), e.zj = z(0, 1);
            e.zc = either(down(-1, 0), z(-1, 0), z(-1, 1));
            e.zd = either(down(0, 0), z(1, 1), z(1, 0));
            if (bend)
                e.gix = gx(0, 0), e.giy = gy(0, 0), e.gjx = gx(0, 1), e.gjy = gy(0, 1);
            e.vx = T(0.0f), e.vy = T(1.0f);
        } else { // of cell (x, y), from its upper to its lower end
            const T flag = down(0, 0);
            const T z0 = z(0, 0), z1 = z(1, 0), z2 = z(0, 1), z3 = z(1, 1);
            e.zi = either(flag, z0, z1), e.zj = either(flag, z3, z2);
            e.zc = either(flag, z2, z0), e.zd = either(flag, z1, z3);
            if (bend) {
                e.gix = either(flag, gx(0, 0), gx(1, 0)), e.giy = either(flag, gy(0, 0), gy(1, 0));
                e.gjx = either(flag, gx(1, 1), gx(0, 1)), e.gjy = either(flag, gy(1, 1), gy(0, 1));
            }
            e.vx = either(flag, T(1.0f), T(-1.0f)), e.vy = T(1.0f);
        }
        return e;
    }
};

/// Edges of a kind at or beside the vertices in columns x0 .. x1 - 1 of row y of pixels. From
/// column `begin` to `end` the regular ones are made as vectors. A function each: compilers take
/// far longer over one of all.
template <EdgeKind kind, bool bend, bool soft, bool tame>
HWY_NOINLINE void make_kind(const Lattice& lattice, int x0, int x1, int begin, int end, int y,
                            EdgeScratch& scratch, ControlNet& net) {
    const int count = net.count();
    const int row = lattice.vertex_site(0, y), first = row + to_first<kind>(lattice);
    const float* weights = scratch.weights[in_odd_column(kind)].data();
    float* const e = bend ? net.at(first) : nullptr;
    float* const q = soft ? net.soft_at(first) : nullptr;
    const RegularRow regular(lattice, net, scratch.edge_cells, y,
                             bend ? scratch.gradients.at(row) : nullptr);
    const Bounds bounds = net.bounds;
    // Bends count for bounds alone.
    const float* const given =
        !bend && bounds != Bounds::none && scratch.bent ? net.at(first) : nullptr;
    begin = std::max(begin, x0);
    end = std::max(std::min(end, x1), begin);
    each_vector(begin, end, count, [&](auto vector, const RowPlace& place) HWY_ATTR {
        using T = decltype(vector);
        const RegularEdges<T> edges = regular.edges<kind, bend, T>(place);
        T bent = T(0.0f);
        if (bend) {
            bent = edge_bend<tame>(edges.gix, edges.giy, edges.gjx, edges.gjy, edges.zi, edges.zj,
                                   edges.vx, edges.vy);
            bent.store(e + place.at);
        } else if (given) {
            bent = T::load(given + place.at);
        }
        if (soft)
            edge_softness<tame>(spread<T>(weights, place, count), edges.zi, edges.zj, edges.zc,
                                edges.zd, bent, bounds)
                .store(q + place.at);
    });
    const size_t most = size_t(x1 - x0) + cells_at_once + most_lanes;
    if (scratch.columns.size() < most)
        scratch.columns.resize(most);
    int* const columns = scratch.columns.data();
    const int n = list_irregular<kind>(lattice, x0, x1, begin, end, y, columns);
    if (n > 0)
        std::fill_n(columns + n, most_lanes, columns[n - 1]);
    const IrregularEdges irregular{net.vertex(row),
                                   regular.gradients,
                                   regular.to_y,
                                   row,
                                   first - row,
                                   weights,
                                   given,
                                   bounds,
                                   count};
    make_irregular<bend, soft>(SiteLanes(lattice), irregular, columns, n, e, q);
}

/// The edges with midpoints in row y of the doubled lattice.
template <bool bend, bool soft, bool tame>
HWY_INLINE void make_row(const Lattice& lattice, const Rect& part, int y, EdgeScratch& scratch,
                         ControlNet& net) {
    const int x0 = part.x0, x1 = part.x1, last = lattice.width() - 1, pixel_y = y / 2;
    if (y & 1) {
        make_kind<EdgeKind::vertical, bend, soft, tame>(lattice, x0, x1, 1, last, pixel_y, scratch,
                                                        net);
        make_kind<EdgeKind::diagonal, bend, soft, tame>(lattice, x0, x1 - 1, 0, last, pixel_y,
                                                        scratch, net);
    } else {
        const bool rim = y == 0 || pixel_y == lattice.height() - 1;
        make_kind<EdgeKind::horizontal, bend, soft, tame>(lattice, x0, x1 - 1, rim ? last : 0, last,
                                                          pixel_y, scratch, net);
    }
}

template <bool bend, bool soft>
HWY_INLINE void make_row(const Lattice& lattice, const Rect& part, int y, EdgeScratch& scratch,
                         ControlNet& net) {
    if (scratch.tame)
        make_row<bend, soft, true>(lattice, part, y, scratch, net);
    else
        make_row<bend, soft, false>(lattice, part, y, scratch, net);
}

HWY_ATTR void make_edges(const Lattice& lattice, const Rect& part, int y0, int y1, bool bend,
                         bool soft, float reciprocal_tau, EdgeScratch& scratch, ControlNet& net) {
    if (y0 == 2 * part.y0)
        scratch.edge_cells.begin(lattice, part, part.y0);
    for (int y = y0; y < y1; ++y) {
        if (y % 2 == 0)
            scratch.edge_cells.load_below(lattice, part, y / 2);
        if (soft)
            soft_weights(lattice.sites() + lattice.site(2 * part.x0, y), part.width(),
                         reciprocal_tau, scratch.weights[0].data() + part.x0,
                         scratch.weights[1].data() + part.x0);
        if (bend && soft)
            make_row<true, true>(lattice, part, y, scratch, net);
        else if (bend)
            make_row<true, false>(lattice, part, y, scratch, net);
        else if (soft)
            make_row<false, true>(lattice, part, y, scratch, net);
    }
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(make_edges);

void make_edges(const Lattice& lattice, const Rect& part, int y0, int y1, bool bend, bool soft,
                float reciprocal_tau, EdgeScratch& scratch, ControlNet& net) {
    HWY_DYNAMIC_DISPATCH(make_edges)
    (lattice, part, y0, y1, bend, soft, reciprocal_tau, scratch, net);
}

} // namespace ddt
#endif
