// SPDX-License-Identifier: Apache-2.0
// SIMD twin of scalar::gain(): several edges at once, compiled for each instruction set.
#include "core/base/vectors/compress_lanes.h"
#include "core/base/vectors/gathers.h"
#include "core/triangulate/gain.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/triangulate/gain_simd.cpp"
#include <hwy/foreach_target.h>

#include "core/base/vectors/vectors.h"

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
#include "core/base/vectors/vectors-inl.h"

using D = hn::ScalableTag<float>;
using DI = hn::RebindToSigned<D>;

#include "core/base/rsqrt-inl.h"
#include "core/base/vectors/compress-inl.h"
#include "core/base/vectors/lanes-inl.h"
#include "core/cost/cost-inl.h"

#include "core/lattice/site_lanes-inl.h"

#include "core/lattice/known_lanes-inl.h"
#include "core/triangulate/gain-inl.h"

/// What is known of as many edges leaves room in the nearest cache.
constexpr size_t at_once = 256;

/// Gains that vectors of up to at_once edges have.
constexpr size_t gains_room = KnownEdges<at_once>::room;

/// Gains of the flippable edges sites[0..n), n at most at_once, and of lanes that are left over.
/// `contour` as for gain_at().
template <class Cost_>
HWY_INLINE void gains_by(const SiteLanes& mesh, const KnownEdges<at_once>& known, float contour,
                         const int* sites, size_t n, float* gains) {
    for (size_t i = 0; i < n; i += hn::Lanes(D())) {
        const Ints m = load_sites(sites + i, n - i);
        gain_at<Cost_, Floats>(known.mesh_at(mesh, i), m, contour).store(gains + i);
    }
}

/// The same by the criterion's cost; the lattice then has them. A function of its own for all who
/// ask for gains: most of what a compiler does here.
HWY_NOINLINE HWY_ATTR void gains_of_some(Lattice& lattice, const Criterion& criterion,
                                         const int* sites, size_t n, float* gains) {
    const SiteLanes mesh(lattice);
    const KnownEdges<at_once> known(mesh, sites, n);
    const float contour = criterion.contour * contour_unit;
    switch (criterion.cost) {
#define DDT_CALL(name, Class, ...)                                                                 \
    case Cost::name:                                                                               \
        gains_by<Class<Floats>>(mesh, known, contour, sites, n, gains);                            \
        break;
        DDT_COSTS(DDT_CALL)
#undef DDT_CALL
    }
    const D d;
    // As Edge::set_gain().
    const auto least = hn::Set(d, least_gain);
    for (size_t i = 0; i < n; i += hn::Lanes(d)) {
        const auto found = hn::LoadU(d, gains + i);
        const auto bounded = hn::IfThenElse(hn::Lt(found, least), least, found);
        const auto gain = hn::IfThenElse(hn::Eq(bounded, bounded), bounded, hn::Abs(bounded));
        hn::StoreU(gain, d, gains + i);
    }
    Site* const records = lattice.sites();
    for (size_t i = 0; i < n; ++i)
        records[sites[i]].edge.word = bits_of(gains[i]);
}

HWY_ATTR void find_gains(Lattice& lattice, const Criterion& criterion, const int* sites,
                         size_t count) {
    float gains[gains_room];
    for (size_t done = 0; done < count; done += at_once)
        gains_of_some(lattice, criterion, sites + done, std::min(count - done, at_once), gains);
}

HWY_ATTR size_t find_candidates(Lattice& lattice, const Criterion& criterion, float min_gain,
                                int* sites, size_t count) {
    const D d;
    const DI di;
    const size_t lanes = hn::Lanes(d);
    const auto least = hn::Set(d, min_gain);
    float gains[gains_room];
    size_t found = 0;
    for (size_t done = 0; done < count; done += at_once) {
        const int* const some = sites + done;
        const size_t n = std::min(count - done, at_once);
        gains_of_some(lattice, criterion, some, n, gains);
        // Not behind what has been read: a vector at a time.
        for (size_t i = 0; i < n; i += lanes) {
            const auto good = hn::RebindMask(di, hn::Gt(hn::LoadU(d, gains + i), least));
            const auto there = hn::FirstN(di, std::min(n - i, lanes));
            const Ints m = load_sites(some + i, n - i);
            found += store_compressed(m.i, hn::And(good, there), sites + found);
        }
    }
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
