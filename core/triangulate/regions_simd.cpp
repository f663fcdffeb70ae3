// SPDX-License-Identifier: Apache-2.0
// SIMD twins of what regions.h does of any mesh: several edges of a lattice at once.
#include "core/triangulate/regions.h"

#include <algorithm>

#include "core/guide/contour.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/triangulate/regions_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr size_t most_lanes = 16;
using D = hn::CappedTag<float, most_lanes>;
using DI = hn::RebindToSigned<D>;

#include "core/base/lanes-inl.h"
#include "core/lattice/site_lanes-inl.h"

#include "core/lattice/known_lanes-inl.h"

/// The best of the edges looked at, a lane.
struct Best {
    const float* all_gains;
    VI site;
    hn::Vec<D> gain;

    HWY_INLINE Best(const float* gains, Ints m)
        : all_gains(gains), site(m.i), gain(hn::GatherIndex(D(), gains, m.i)) {}

    /// Twin of goes_before().
    HWY_INLINE void look_at(Ints other) {
        const D d;
        const auto g = hn::GatherIndex(d, all_gains, other.i);
        const auto first = hn::RebindMask(d, hn::Lt(other.i, site));
        const auto better = hn::Or(hn::Gt(g, gain), hn::And(hn::Eq(g, gain), first));
        gain = hn::IfThenElse(better, g, gain);
        site = hn::IfThenElse(hn::RebindMask(DI(), better), other.i, site);
    }
};

/// Call f(sites) for each edge of the 2-regions of the edges at m, a lane; where there is none f is
/// called with another of them once more. Twin of Lattice::any_of_region().
template <class F>
HWY_INLINE void each_of_region(const KnownLanes& mesh, Ints m, F&& f) {
    const FlippableLanes e = mesh.flippable_edge(m);
    const QuadOf<VecLanes> q(e.v, e.left);
    const Ints w = mesh.offset(q.w), u = mesh.offset(q.side[1]), none{hn::Zero(DI())};
    const QuadSites<Ints> at(m, w, u);
    // The third side of the triangle beyond is the one that leads to it and the side together.
    const Ints sides[4] = {w, u, none - w, none - u};
    for (int k = 0; k < 4; ++k) {
        const Ints middle = at.middle[k];
        f(middle);
        const VecLanes apex = apex_beyond(mesh.side(k, middle), q.inner[k]);
        const Ints first = middle + mesh.offset(from_first_end(apex, q.side[k]));
        f(mesh.if_present(apex, first - sides[k], middle));
        f(mesh.if_present(apex, first, middle));
    }
}

/// Of each edge its best blocker, or the edge itself.
HWY_INLINE VI best_of_region(const KnownLanes& mesh, const float* gains, Ints m) {
    Best best(gains, m);
    each_of_region(mesh, m, [&](Ints other) HWY_ATTR { best.look_at(other); });
    return best.site;
}

HWY_ATTR void find_regions(const Lattice& lattice, const int* sites, size_t n, int* regions) {
    const DI di;
    const size_t lanes = hn::Lanes(di);
    const SiteLanes mesh(lattice);
    KnownEdges<regions_at_once> known;
    known.find(mesh, sites, n);
    HWY_ALIGN int32_t found[most_in_region][most_lanes];
    for (size_t i = 0; i < n; i += lanes) {
        const Ints m = load_sites(sites + i, n - i);
        hn::Store(m.i, di, found[0]);
        int in_region = 0;
        each_of_region(known.mesh_at(mesh, i, n - i), m,
                       [&](Ints other) HWY_ATTR { hn::Store(other.i, di, found[++in_region]); });
        for (size_t k = 0; k < std::min(lanes, n - i); ++k)
            for (size_t j = 0; j < most_in_region; ++j)
                *regions++ = found[j][k];
    }
}

HWY_ATTR void find_blockers(const Lattice& lattice, const float* gain, const int* sites, size_t n,
                            int* blockers) {
    const DI di;
    const size_t lanes = hn::Lanes(di);
    const SiteLanes mesh(lattice);
    KnownEdges<regions_at_once> known;
    known.find(mesh, sites, n);
    HWY_ALIGN int32_t found[most_lanes];
    for (size_t i = 0; i < n; i += lanes) {
        const Ints m = load_sites(sites + i, n - i);
        const VI best = best_of_region(known.mesh_at(mesh, i, n - i), gain, m);
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
HWY_EXPORT(find_regions);

void find_blockers(const Lattice& lattice, const std::vector<float>& gain, const int* sites,
                   size_t n, int* blockers) {
    if (lattice.width() > widest_lanes)
        return find_blockers<Lattice>(lattice, gain, sites, n, blockers);
    for (size_t i = 0; i < n; i += regions_at_once)
        HWY_DYNAMIC_DISPATCH(find_blockers)
    (lattice, gain.data(), sites + i, std::min(n - i, regions_at_once), blockers + i);
}

void find_regions(const Lattice& lattice, const int* sites, size_t n, int* regions) {
    if (lattice.width() > widest_lanes)
        return find_regions<Lattice>(lattice, sites, n, regions);
    for (size_t i = 0; i < n; i += regions_at_once)
        HWY_DYNAMIC_DISPATCH(find_regions)
    (lattice, sites + i, std::min(n - i, regions_at_once), regions + i * most_in_region);
}

} // namespace ddt
#endif
