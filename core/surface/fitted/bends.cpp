// SPDX-License-Identifier: Apache-2.0
// Fitted bends: those of regular edges in vectors, of irregular ones one at a time (edge_kinds.h).
#include <algorithm>
#include <cstddef>
#include <cstdlib>

#include "core/base/arith.h"
#include "core/surface/edge_kinds.h"
#include "core/surface/fitted/fitted.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/fitted/bends.cpp"
#include <hwy/foreach_target.h>

#include "core/base/vectors/vectors.h"

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
#include "core/base/vectors/vectors-inl.h"

#include "core/base/rsqrt-inl.h"
#include "core/base/vectors/lanes-inl.h"
#include "core/surface/consistency/consistency-inl.h"
#include "core/surface/fitted/features-inl.h"

#include "core/base/vectors/row_lanes-inl.h"

#include "core/surface/fitted/irregular_bends-inl.h"
#include "core/surface/fitted/regular_bends-inl.h"

/// Edges of a kind at or beside the vertices in columns x0 .. x1 - 1 of row y of pixels. A function
/// each: compilers take far longer over one of all.
template <EdgeKind kind>
HWY_NOINLINE void bend_kind(const FittedSource& source, int x0, int x1, int y,
                            const IrregularBends& irregular, const RegularBends& regular,
                            BendScratch& scratch, ControlNet& net) {
    const Lattice& lattice = source.lattice;
    constexpr int margin = RegularBends::margin;
    const bool inner = y >= margin && y + margin < lattice.height();
    const int begin = inner ? std::max(x0, margin) : x1,
              end = std::max(std::min(x1, lattice.width() - margin), begin);
    const int first = lattice.vertex_site(0, y) + to_first<kind>(lattice);
    float* const e = net.at(first);
    each_vector(begin, end, source.count, [&](auto vector, const RowPlace& place) HWY_ATTR {
        regular.at<kind, decltype(vector)>(place, first).store(e + place.at);
    });
    int* const columns = scratch.columns.data();
    const int n = list_irregular<kind>(lattice, x0, x1, begin, end, y, columns);
    for (int i = 0; i < n; ++i)
        irregular.bend(2 * columns[i] + in_odd_column(kind), 2 * y + in_odd_row(kind));
}

/// What BendScratch has of the edges of row y of the doubled lattice.
HWY_INLINE void load_edges(const Lattice& lattice, const Rect& part, int y, BendScratch& scratch) {
    const FittedTable& table = fitted_table();
    for (int odd = 1 - (y & 1); odd < 2; ++odd)
        for (int x = part.x0; x < part.x1 - odd; ++x) {
            const Edge& e = lattice.edge(lattice.site(2 * x + odd, y));
            scratch.near[odd][size_t(x)] = nearness(e, table);
            scratch.flippable[odd][size_t(x)] = e.flippable() ? 1.0f : 0.0f;
        }
}

HWY_ATTR void bend_fitted(const FittedSource& source, const Rect& part, int my,
                          const IndexRows& index, const ControlNet& plain_net, BendScratch& scratch,
                          ControlNet& net) {
    const int x0 = part.x0, x1 = part.x1, y = my / 2;
    load_edges(source.lattice, part, my, scratch);
    const IrregularBends irregular(source, index, plain_net, net);
    const RegularBends regular(source, index, plain_net, scratch, y);
    if (my & 1) {
        bend_kind<EdgeKind::vertical>(source, x0, x1, y, irregular, regular, scratch, net);
        bend_kind<EdgeKind::diagonal>(source, x0, x1 - 1, y, irregular, regular, scratch, net);
    } else {
        bend_kind<EdgeKind::horizontal>(source, x0, x1 - 1, y, irregular, regular, scratch, net);
    }
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(bend_fitted);

void bend_fitted(const FittedSource& source, const Rect& part, int y, const IndexRows& index,
                 const ControlNet& plain, BendScratch& scratch, ControlNet& net) {
    const Lattice& lattice = source.lattice;
    if (y == 2 * part.y0) {
        const size_t padded = size_t(lattice.width()) + edge_padding;
        scratch.cells.resize(lattice.width());
        for (auto* rows : {scratch.near, scratch.flippable})
            for (int odd = 0; odd < 2; ++odd)
                rows[odd].resize(padded);
        scratch.columns.resize(padded + cells_at_once);
        scratch.cells.begin(lattice, part, part.y0);
    }
    if (y % 2 == 0)
        scratch.cells.load_below(lattice, part, y / 2);
    HWY_DYNAMIC_DISPATCH(bend_fitted)(source, part, y, index, plain, scratch, net);
}

} // namespace ddt
#endif
