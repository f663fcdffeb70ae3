// SPDX-License-Identifier: Apache-2.0
// SIMD twin of scalar::gain(): several edges at once, compiled for each instruction set.
#include "core/base/compress_lanes.h"
#include "core/triangulate/gain.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/triangulate/gain_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<float>;
using DI = hn::RebindToSigned<D>;

#include "core/base/compress-inl.h"
#include "core/base/lanes-inl.h"
#include "core/base/rsqrt-inl.h"
#include "core/cost/cost-inl.h"

#include "core/lattice/site_lanes-inl.h"

#include "core/lattice/known_lanes-inl.h"
#include "core/triangulate/gain-inl.h"

/// Gains of the flippable edges at m, one a lane; `contour` times contour_unit of the contours', if
/// any.
template <class Cost_>
HWY_INLINE hn::Vec<D> gains_of(const KnownLanes& mesh, float contour, Ints m) {
    if (contour == 0)
        return flip_gain<Cost_>(neighbourhood<Floats>(mesh, m)).v;
    return gain_with_contours<Cost_, Floats>(mesh, m, contour).v;
}

/// Store the gains of flippable edges in their records; call each(sites, gains, n) for every
/// vector, of which n lanes count.
template <class Cost_, class Each>
HWY_INLINE void each_block(Lattice& lattice, float contour, const int* sites, size_t count,
                           Each&& each) {
    /// What is known of as many leaves room in the nearest cache.
    constexpr size_t at_once = 256;
    const D d;
    const size_t lanes = hn::Lanes(d);
    const SiteLanes mesh(lattice);
    Site* const records = lattice.sites();
    HWY_ALIGN uint32_t words[HWY_MAX_BYTES / sizeof(uint32_t)];
    for (size_t done = 0; done < count; done += at_once) {
        const int* const some = sites + done;
        const size_t n = std::min(count - done, at_once);
        const KnownEdges<at_once> known(mesh, some, n);
        for (size_t i = 0; i < n; i += lanes) {
            const size_t used = std::min(n - i, lanes);
            const Ints m = load_sites(some + i, used);
            const auto found = gains_of<Cost_>(known.mesh_at(mesh, i), contour, m);
            // As Edge::set_gain().
            const auto least = hn::Set(d, least_gain);
            const auto bounded = hn::IfThenElse(hn::Lt(found, least), least, found);
            const auto gain = hn::IfThenElse(hn::Eq(bounded, bounded), bounded, hn::Abs(bounded));
            hn::Store(hn::BitCast(hn::RebindToUnsigned<D>(), gain), hn::RebindToUnsigned<D>(),
                      words);
            for (size_t k = 0; k < used; ++k)
                records[some[i + k]].edge.word = words[k];
            each(m, gain, used);
        }
    }
}

/// The same of the criterion's cost.
template <class Each>
HWY_INLINE void each_gain(Lattice& lattice, const Criterion& criterion, const int* sites,
                          size_t count, Each&& each) {
    const float contour = criterion.contour * contour_unit;
    switch (criterion.cost) {
#define DDT_CALL(name, Class, ...)                                                                 \
    case Cost::name:                                                                               \
        return each_block<Class<Floats>>(lattice, contour, sites, count, each);
        DDT_COSTS(DDT_CALL)
#undef DDT_CALL
    }
}

HWY_ATTR void find_gains(Lattice& lattice, const Criterion& criterion, const int* sites,
                         size_t count) {
    each_gain(lattice, criterion, sites, count, [](Ints, hn::Vec<D>, size_t) HWY_ATTR {});
}

HWY_ATTR size_t find_candidates(Lattice& lattice, const Criterion& criterion, float min_gain,
                                int* sites, size_t count) {
    const auto least = hn::Set(D(), min_gain);
    size_t found = 0;
    // Not behind what has been read: a vector at a time.
    each_gain(lattice, criterion, sites, count, [&](Ints m, hn::Vec<D> g, size_t used) HWY_ATTR {
        const DI di;
        const auto good = hn::RebindMask(di, hn::Gt(g, least));
        found += store_compressed(m.i, hn::And(good, hn::FirstN(di, used)), sites + found);
    });
    return found;
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(find_gains);
HWY_EXPORT(find_candidates);

void find_gains(Lattice& lattice, const Criterion& criterion, const int* sites, size_t n) {
    if (lattice.width() > widest_lanes)
        return find_gains<Lattice>(lattice, criterion, sites, n);
    HWY_DYNAMIC_DISPATCH(find_gains)(lattice, criterion, sites, n);
}

size_t find_candidates(Lattice& lattice, const Criterion& criterion, float min_gain, int* sites,
                       size_t n) {
    if (lattice.width() > widest_lanes)
        return find_candidates<Lattice>(lattice, criterion, min_gain, sites, n);
    return HWY_DYNAMIC_DISPATCH(find_candidates)(lattice, criterion, min_gain, sites, n);
}

} // namespace ddt
#endif
