// SPDX-License-Identifier: Apache-2.0
// SIMD twin of Lattice::flip(): several edges at once.
#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "core/base/vectors/compress_lanes.h"
#include "core/base/vectors/gathers.h"
#include "core/base/vectors/row_lanes.h"
#include "core/guide/contour.h"
#include "core/lattice/lattice.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/lattice/flips.cpp"
#include <hwy/foreach_target.h>

#include "core/base/vectors/vectors.h"

#ifndef DDT_FLIPS_ONCE
#define DDT_FLIPS_ONCE
namespace ddt {
/// Edges that are flipped by one call, at most.
constexpr size_t flips_at_once = 256;

/// Of edges that were flipped.
struct LongFlips {
    int longest;              ///< coordinate of any
    size_t steep;             ///< how many go over more than one row,
    int sites[flips_at_once]; ///< and which
};
} // namespace ddt
#endif

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
#include "core/base/vectors/vectors-inl.h"

using D = hn::CappedTag<float, most_lanes>;
using DI = hn::RebindToSigned<D>;

#include "core/base/vectors/compress-inl.h"
#include "core/base/vectors/lanes-inl.h"
#include "core/lattice/site_lanes-inl.h"

#include "core/lattice/known_lanes-inl.h"

/// Store the records of n edges, a lane each.
HWY_INLINE void store_records(Ints m, VI first, VI second, size_t n, Site* sites) {
    HWY_ALIGN int32_t at[most_lanes], records[2 * most_lanes];
    hn::Store(m.i, DI(), at);
    hn::StoreInterleaved2(first, second, DI(), records);
    for (size_t k = 0; k < n; ++k)
        std::memcpy(static_cast<void*>(sites + at[k]), records + 2 * k, sizeof(Site));
}

/// The second word of an edge that can be flipped.
HWY_INLINE VI unknown_gain() {
    return hn::BitCast(DI(), hn::Set(D(), no_gain));
}

/// Twin of Edge's constructor: the second words of edges with these apexes.
HWY_INLINE VI second_words(VecLanes left, VecLanes right) {
    const DI di;
    static_assert((longest_edge & (longest_edge + 1)) == 0, "longer ones have other bits");
    const VI none = hn::Zero(di),
             beyond_longest = hn::Set(di, ~(longest_edge << 16 | longest_edge));
    const VI far = hn::And(hn::BitCast(di, hn::Abs(left.halves())), beyond_longest);
    const auto can = hn::AndNot(left.zero(), hn::Eq(hn::Or((left + right).xy, far), none));
    const VI rigid = hn::Or(hn::Set(di, int32_t(rigid_mark << 16)), right.bytes());
    return hn::IfThenElse(can, unknown_gain(), rigid);
}

HWY_ATTR void flip_edges(Lattice& lattice, const int* edges, size_t n, LongFlips& flips) {
    const DI di;
    const SiteLanes mesh(lattice);
    const size_t lanes = hn::Lanes(di);
    const VI v_bytes = hn::Set(di, 0xffff);
    const KnownEdges<flips_at_once> known(mesh, edges, n);
    VI longest = hn::Zero(di);
    flips.steep = 0;
    for (size_t i = 0; i < n; i += lanes) {
        const size_t used = std::min(n - i, lanes);
        const Ints m = load_sites(edges + i, used);
        const KnownLanes seen = known.mesh_at(mesh, i);
        const FlippableLanes e = seen.flippable_edge(m);
        const QuadOf<VecLanes> q(e.v, e.left);
        const QuadSites<Ints> at(m, mesh.offset(q.w), mesh.offset(q.side[1]));
        const VecLanes c = e.left, d = -e.left;
        // Side ac loses apex b and gets d; cb: a -> d; bd: a -> c; da: b -> c.
        const VecLanes came[4] = {d, d, c, c};
        for (int k = 0; k < 4; ++k) {
            const RecordLanes& side = seen.sides[k];
            const VecLanes inner = came[k] - q.middle[k], beyond = apex_beyond(side, q.inner[k]);
            const auto on_left = hn::Eq(side.left().xy, q.inner[k].xy);
            const VecLanes left{hn::IfThenElse(on_left, inner.xy, beyond.xy)},
                right{hn::IfThenElse(on_left, beyond.xy, inner.xy)};
            const VI first = hn::Or(hn::And(side.first, v_bytes), hn::ShiftLeft<16>(left.bytes()));
            store_records(at.middle[k], first, second_words(left, right), used, lattice.sites());
        }
        const VI first = hn::Or(c.bytes(), hn::ShiftLeft<16>(VecLanes(-e.v).bytes()));
        store_records(m, first, unknown_gain(), used, lattice.sites()); // it can be flipped back

        const auto size = hn::Abs(c.halves());
        const VI down = hn::ShiftRight<16>(hn::BitCast(di, size));
        longest = hn::Max(longest, hn::Max(down, VecLanes::of(size).x()));
        const auto steep = hn::And(hn::Gt(down, hn::Set(di, 1)), hn::FirstN(di, used));
        HWY_ALIGN int32_t found[HWY_MAX_BYTES / sizeof(int32_t)];
        const size_t more = store_compressed(m.i, steep, found);
        std::copy_n(found, more, flips.sites + flips.steep);
        flips.steep += more;
    }
    HWY_ALIGN int32_t each[HWY_MAX_BYTES / sizeof(int32_t)];
    hn::Store(longest, di, each);
    flips.longest = *std::max_element(each, each + lanes);
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(flip_edges);

void Lattice::flip_all(const int* edges, size_t n) {
    if (m_width > widest_lanes) {
        std::for_each_n(edges, n, [&](int m) { flip(m); });
        return;
    }
    m_fresh = m_fresh && n == 0;
    LongFlips flips;
    for (size_t i = 0; i < n; i += flips_at_once) {
        HWY_DYNAMIC_DISPATCH(flip_edges)
        (*this, edges + i, std::min(n - i, flips_at_once), flips);
        m_longest = std::max(m_longest, flips.longest);
        for (size_t k = 0; k < flips.steep; ++k)
            note_down(flips.sites[k], std::abs(int(edge(flips.sites[k]).v.y)));
    }
}

} // namespace ddt
#endif
