// SPDX-License-Identifier: Apache-2.0
// SIMD twin of Lattice::flip(): several edges at once.
#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "core/base/compress_lanes.h"
#include "core/guide/contour.h"
#include "core/lattice/lattice.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/lattice/flips.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

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
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, 16>;
using DI = hn::RebindToSigned<D>;

#include "core/base/compress-inl.h"
#include "core/base/lanes-inl.h"
#include "core/lattice/site_lanes-inl.h"

#include "core/lattice/known_lanes-inl.h"

/// The same of each edge in the lanes, on its way into records.
struct Stored {
    HWY_ALIGN int32_t at[HWY_MAX_BYTES / sizeof(int32_t)];
    HWY_ALIGN int32_t bytes[HWY_MAX_BYTES / sizeof(int32_t)];
};

/// Store the low n bytes of each lane at so many bytes from the lattice's first site.
template <size_t n>
HWY_INLINE void store_bytes(Ints at, VI bytes, size_t lanes, char* sites) {
    Stored s;
    hn::Store(at.i, DI(), s.at);
    hn::Store(bytes, DI(), s.bytes);
    for (size_t k = 0; k < lanes; ++k)
        std::memcpy(sites + s.at[k], &s.bytes[k], n);
}

HWY_ATTR void flip_edges(const Lattice& lattice, const int* edges, size_t n, char* sites,
                         LongFlips& flips) {
    const DI di;
    const SiteLanes mesh(lattice);
    const size_t lanes = hn::Lanes(di);
    const auto of_record = [](Ints m, size_t offset) HWY_ATTR -> Ints {
        return {hn::Add(hn::ShiftLeft<3>(m.i), hn::Set(DI(), int(offset)))};
    };
    KnownEdges<flips_at_once> known;
    known.find(mesh, edges, n);
    VI longest = hn::Zero(di);
    flips.steep = 0;
    for (size_t i = 0; i < n; i += lanes) {
        const size_t used = std::min(n - i, lanes);
        const Ints m = load_sites(edges + i, used);
        const KnownLanes seen = known.mesh_at(mesh, i, used);
        const FlippableLanes e = seen.flippable_edge(m);
        const QuadOf<VecLanes> q(e.v, e.left);
        const QuadSites<Ints> at(m, mesh.offset(q.w), mesh.offset(q.side[1]));
        const VecLanes c = e.left, d = -e.left;
        // Side ac loses apex b and gets d; cb: a -> d; bd: a -> c; da: b -> c.
        const VecLanes came[4] = {d, d, c, c};
        for (int k = 0; k < 4; ++k) {
            const Ints side = at.middle[k];
            const auto left = hn::Eq(seen.side(k, side).left.xy, q.inner[k].xy);
            const VI offset = hn::IfThenElse(left, hn::Set(di, int(offsetof(Edge, left))),
                                             hn::Set(di, int(offsetof(Edge, right))));
            store_bytes<2>({hn::Add(of_record(side, 0).i, offset)},
                           VecLanes(came[k] - q.middle[k]).bytes(), used, sites);
        }
        const VI v = e.v.bytes(), minus_v = VecLanes(-e.v).bytes();
        store_bytes<4>(of_record(m, offsetof(Edge, v)),
                       hn::Or(c.bytes(), hn::ShiftLeft<16>(minus_v)), used, sites);
        store_bytes<2>(of_record(m, offsetof(Edge, right)), v, used, sites);

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
        (*this, edges + i, std::min(n - i, flips_at_once), reinterpret_cast<char*>(m_sites.data()),
         flips);
        m_longest = std::max(m_longest, flips.longest);
        for (size_t k = 0; k < flips.steep; ++k)
            note_down(flips.sites[k], std::abs(int(edge(flips.sites[k]).v.y)));
    }
}

} // namespace ddt
#endif
