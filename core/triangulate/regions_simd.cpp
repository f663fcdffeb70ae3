// SPDX-License-Identifier: Apache-2.0
// SIMD twins of what regions.h does of any mesh: several edges of a lattice at once.
#include "core/triangulate/regions.h"

#include <algorithm>

#include "core/base/vectors/compress_lanes.h"
#include "core/base/vectors/gathers.h"
#include "core/base/vectors/row_lanes.h"
#include "core/guide/contour.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/triangulate/regions_simd.cpp"
#include <hwy/foreach_target.h>

#include "core/base/vectors/vectors.h"

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

/// The best of the edges looked at, a lane.
struct Best {
    VI site;
    hn::Vec<D> gain;

    /// Twin of goes_before().
    HWY_INLINE void look_at(Ints other, Floats gains) {
        const D d;
        const auto g = gains.v;
        const auto first = hn::RebindMask(d, hn::Lt(other.i, site));
        const auto better = hn::Or(hn::Gt(g, gain), hn::And(hn::Eq(g, gain), first));
        gain = hn::IfThenElse(better, g, gain);
        site = hn::IfThenElse(hn::RebindMask(DI(), better), other.i, site);
    }
};

/// Call side(k, sites) for the sides of the quads round the edges at m, a lane, and other(sites)
/// for each other edge of their 2-regions; where there is none, with a side once more. Twin of
/// Lattice::any_of_region().
template <class Side, class Other>
HWY_INLINE void each_of_region(const KnownLanes& mesh, Ints m, Side&& side, Other&& other) {
    const FlippableLanes e = mesh.flippable_edge(m);
    const QuadOf<VecLanes> q(e.v, e.left);
    const Ints w = mesh.offset(q.w), u = mesh.offset(q.side[1]), none{hn::Zero(DI())};
    const QuadSites<Ints> at(m, w, u);
    // The third side of the triangle beyond is the one that leads to it and the side together.
    const Ints sides[4] = {w, u, none - w, none - u};
    for (int k = 0; k < 4; ++k) {
        const Ints middle = at.middle[k];
        side(k, middle);
        const VecLanes apex = apex_beyond(mesh.sides[k], q.inner[k]);
        const Ints first = middle + mesh.offset(from_first_end(apex, q.side[k]));
        other(mesh.if_present(apex, first - sides[k], middle));
        other(mesh.if_present(apex, first, middle));
    }
}

/// Of each edge its best blocker, or the edge itself.
HWY_INLINE VI best_of_region(const KnownLanes& mesh, Ints m) {
    Best best{m.i, mesh.gain(m).v};
    each_of_region(
        mesh, m, [&](int k, Ints side) HWY_ATTR { best.look_at(side, mesh.sides[k].gain()); },
        [&](Ints other) HWY_ATTR { best.look_at(other, mesh.gain(other)); });
    return best.site;
}

HWY_ATTR size_t find_settled(const Lattice& lattice, const int* sites, size_t n, int* regions) {
    const DI di;
    const size_t lanes = hn::Lanes(di);
    const SiteLanes mesh(lattice);
    const KnownEdges<regions_at_once> known(mesh, sites, n);
    size_t found = 0;
    for (size_t i = 0; i < n; i += lanes) {
        const Ints m = load_sites(sites + i, n - i);
        const auto here = hn::FirstN(di, n - i);
        const auto add = [&](Ints edge, Floats gain) HWY_ATTR {
            // Twin of Lattice::settled(): the words that are not are below as floats.
            const auto unsettled = hn::RebindMask(di, hn::Lt(gain.v, hn::Set(D(), least_gain)));
            found += store_compressed(edge.i, hn::AndNot(unsettled, here), regions + found);
        };
        const KnownLanes seen = known.mesh_at(mesh, i);
        add(m, mesh.gain(m));
        each_of_region(
            seen, m, [&](int k, Ints side) HWY_ATTR { add(side, seen.sides[k].gain()); },
            [&](Ints other) HWY_ATTR { add(other, mesh.gain(other)); });
    }
    return found;
}

HWY_ATTR void find_blockers(const Lattice& lattice, const int* sites, size_t n, int* blockers) {
    const DI di;
    const size_t lanes = hn::Lanes(di);
    const SiteLanes mesh(lattice);
    const KnownEdges<regions_at_once> known(mesh, sites, n);
    HWY_ALIGN int32_t found[most_lanes];
    for (size_t i = 0; i < n; i += lanes) {
        const Ints m = load_sites(sites + i, n - i);
        const VI best = best_of_region(known.mesh_at(mesh, i), m);
        hn::Store(hn::IfThenElse(hn::Eq(best, m.i), hn::Set(di, -1), best), di, found);
        std::copy_n(found, std::min(lanes, n - i), blockers + i);
    }
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(find_blockers);
HWY_EXPORT(find_settled);

void find_blockers(const Lattice& lattice, const int* sites, size_t n, int* blockers) {
    if (lattice.width() > widest_lanes)
        return find_blockers<Lattice>(lattice, sites, n, blockers);
    for (size_t i = 0; i < n; i += regions_at_once)
        HWY_DYNAMIC_DISPATCH(find_blockers)
    (lattice, sites + i, std::min(n - i, regions_at_once), blockers + i);
}

size_t find_settled(const Lattice& lattice, const int* sites, size_t n, int* regions) {
    if (lattice.width() > widest_lanes)
        return find_settled<Lattice>(lattice, sites, n, regions);
    size_t found = 0;
    for (size_t i = 0; i < n; i += regions_at_once)
        found += HWY_DYNAMIC_DISPATCH(find_settled)(
            lattice, sites + i, std::min(n - i, regions_at_once), regions + found);
    return found;
}

} // namespace ddt
#endif
