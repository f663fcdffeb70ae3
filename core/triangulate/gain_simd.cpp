// SPDX-License-Identifier: Apache-2.0
// SIMD twin of scalar::gain(): several edges at once, compiled for each instruction set.
#include "core/triangulate/gain.h"

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
#include "core/triangulate/gain-inl.h"

/// Gains of the edges at `m`, one a lane; `contour` times contour_unit of the contours', if any.
template <class Cost_>
HWY_INLINE hn::Vec<D> gains_of(const Lattice& lattice, float contour, Ints m) {
    const SiteLanes mesh(lattice);
    if (contour == 0)
        return flip_gain<Cost_>(neighbourhood<Floats>(mesh, m)).v;
    return gain_with_contours<Cost_, Floats>(mesh, m, contour).v;
}

/// Store the gains of flippable edges at their sites; call each(sites, gains, n) for every vector,
/// of which n lanes count.
template <class Cost_, class Each>
HWY_INLINE void each_block(const Lattice& lattice, float contour, const int* sites, size_t count,
                           float* out, Each&& each) {
    const D d;
    const size_t lanes = hn::Lanes(d);
    HWY_ALIGN float gain[HWY_MAX_BYTES / sizeof(float)];
    for (size_t i = 0; i < count; i += lanes) {
        const size_t used = count - i < lanes ? count - i : lanes;
        const Ints m = load_sites(sites + i, used);
        const auto g = gains_of<Cost_>(lattice, contour, m);
        hn::Store(g, d, gain);
        for (size_t k = 0; k < used; ++k)
            out[sites[i + k]] = gain[k];
        each(m, g, used);
    }
}

/// The same of the criterion's cost.
template <class Each>
HWY_INLINE void each_gain(const Lattice& lattice, const Criterion& criterion, const int* sites,
                          size_t count, float* out, Each&& each) {
    const float contour = criterion.contour * contour_unit;
    switch (criterion.cost) {
#define DDT_CALL(name, Class, ...)                                                                 \
    case Cost::name:                                                                               \
        return each_block<Class<Floats>>(lattice, contour, sites, count, out, each);
        DDT_COSTS(DDT_CALL)
#undef DDT_CALL
    }
}

HWY_ATTR void gains(const Lattice& lattice, const Criterion& criterion, const int* sites,
                    size_t count, float* out) {
    each_gain(lattice, criterion, sites, count, out, [](Ints, hn::Vec<D>, size_t) HWY_ATTR {});
}

/// Those of the edges that can be flipped, in their order; whole vectors are written. Twin of
/// Edge::flippable().
HWY_INLINE size_t flippable_of(const Lattice& lattice, const int* sites, size_t count, int* found) {
    const DI di;
    const SiteLanes mesh(lattice);
    static_assert((longest_edge & (longest_edge + 1)) == 0, "longer ones have other bits");
    const VI none = hn::Zero(di),
             beyond_longest = hn::Set(di, ~(longest_edge << 16 | longest_edge));
    const size_t lanes = hn::Lanes(di);
    size_t n = 0;
    for (size_t i = 0; i < count; i += lanes) {
        const size_t used = count - i < lanes ? count - i : lanes;
        const Ints m = load_sites(sites + i, used);
        const ApexLanes apex = mesh.apexes(m);
        const VI far = hn::And(hn::BitCast(di, hn::Abs(apex.left.halves())), beyond_longest);
        const auto can =
            hn::AndNot(apex.left.zero(), hn::Eq(hn::Or((apex.left + apex.right).xy, far), none));
        n += store_compressed(m.i, hn::And(can, hn::FirstN(di, used)), found + n);
    }
    return n;
}

HWY_ATTR void find_candidates(const Lattice& lattice, const Criterion& criterion, float min_gain,
                              const int* sites, size_t count, float* out, int* candidates,
                              Evaluated& found) {
    constexpr size_t at_once = 1024;
    int flippable[at_once + HWY_MAX_BYTES / sizeof(int)];
    const auto least = hn::Set(D(), min_gain);
    for (size_t i = 0; i < count; i += at_once) {
        const size_t some = count - i < at_once ? count - i : at_once;
        for (size_t k = 0; k < some; ++k)
            out[sites[i + k]] = no_gain;
        const size_t n = flippable_of(lattice, sites + i, some, flippable);
        found.flippable += n;
        each_gain(lattice, criterion, flippable, n, out,
                  [&](Ints m, hn::Vec<D> g, size_t used) HWY_ATTR {
                      const DI di;
                      const auto good = hn::RebindMask(di, hn::Gt(g, least));
                      found.candidates += store_compressed(m.i, hn::And(good, hn::FirstN(di, used)),
                                                           candidates + found.candidates);
                  });
    }
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(gains);
HWY_EXPORT(find_candidates);

void gains(const Lattice& lattice, const Criterion& criterion, const int* sites, size_t n,
           float* out) {
    if (lattice.width() > widest_lanes)
        return dispatch(criterion.cost, [&](auto cost) {
            for (size_t i = 0; i < n; ++i)
                out[sites[i]] = gain_of<decltype(cost)>(lattice, sites[i], criterion.contour);
        });
    HWY_DYNAMIC_DISPATCH(gains)(lattice, criterion, sites, n, out);
}

Evaluated find_candidates(const Lattice& lattice, const Criterion& criterion, float min_gain,
                          const int* sites, size_t n, std::vector<float>& gain, int* candidates) {
    if (lattice.width() > widest_lanes)
        return find_candidates<Lattice>(lattice, criterion, min_gain, sites, n, gain, candidates);
    Evaluated found;
    HWY_DYNAMIC_DISPATCH(find_candidates)
    (lattice, criterion, min_gain, sites, n, gain.data(), candidates, found);
    return found;
}

} // namespace ddt
#endif
