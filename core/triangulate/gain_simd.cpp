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

template <class Cost_>
HWY_INLINE void each_block(const Lattice& lattice, float contour, const int* sites, size_t count,
                           float* out) {
    const D d;
    const size_t lanes = hn::Lanes(d);
    HWY_ALIGN float gain[HWY_MAX_BYTES / sizeof(float)];
    for (size_t i = 0; i < count; i += lanes) {
        const size_t used = count - i < lanes ? count - i : lanes;
        hn::Store(gains_of<Cost_>(lattice, contour, load_sites(sites + i, used)), d, gain);
        for (size_t k = 0; k < used; ++k)
            out[sites[i + k]] = gain[k];
    }
}

HWY_ATTR void gains(const Lattice& lattice, const Criterion& criterion, const int* sites,
                    size_t count, float* out) {
    const float contour = criterion.contour * contour_unit;
    switch (criterion.cost) {
#define DDT_CALL(name, Class, ...)                                                                 \
    case Cost::name:                                                                               \
        return each_block<Class<Floats>>(lattice, contour, sites, count, out);
        DDT_COSTS(DDT_CALL)
#undef DDT_CALL
    }
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(gains);

void gains(const Lattice& lattice, const Criterion& criterion, const int* sites, size_t n,
           float* out) {
    HWY_DYNAMIC_DISPATCH(gains)(lattice, criterion, sites, n, out);
}

} // namespace ddt
#endif
