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
using VI = hn::Vec<DI>;

#include "core/base/lanes-inl.h"
#include "core/base/rsqrt-inl.h"
#include "core/cost/cost-inl.h"
#include "core/triangulate/gain-inl.h"

using Floats = Lanes<D>;

/// Byte k of each lane as a signed number.
template <int k>
HWY_INLINE VI byte(VI x) {
    return hn::ShiftRight<24>(hn::ShiftLeft<24 - 8 * k>(x));
}
HWY_INLINE Floats to_float(VI x) {
    return hn::ConvertTo(D(), x);
}

/// Gains of the edges at `m`, one a lane.
template <class Cost_>
HWY_INLINE hn::Vec<D> gains_of(const Lattice& lattice, VI m) {
    const DI di;
    const int32_t* words = reinterpret_cast<const int32_t*>(lattice.sites());
    const float* floats = reinterpret_cast<const float*>(lattice.sites());
    const VI stride = hn::Set(di, lattice.stride());
    // A site is two words; an edge's are (v, left), (right, stamp), a vertex's first is its guide.
    const auto word = [&](VI site, int k) HWY_ATTR {
        return hn::GatherIndex(di, words + k, hn::ShiftLeft<1>(site));
    };
    const auto guide = [&](VI site) HWY_ATTR {
        return Floats(hn::GatherIndex(D(), floats, hn::ShiftLeft<1>(site)));
    };
    const auto offset = [&](VI x, VI y) HWY_ATTR { return hn::Add(hn::Mul(y, stride), x); };

    const VI record = word(m, 0);
    const VI vx = byte<0>(record), vy = byte<1>(record);
    const VI lx = byte<2>(record), ly = byte<3>(record);
    const VI wx = hn::ShiftRight<1>(hn::Add(vx, lx)), wy = hn::ShiftRight<1>(hn::Add(vy, ly));
    const VI ux = hn::Sub(vx, wx), uy = hn::Sub(vy, wy);
    const VI dv = offset(vx, vy), dl = offset(lx, ly), dw = offset(wx, wy), du = hn::Sub(dv, dw);

    Neighbourhood<Floats> n;
    n.vx = to_float(vx);
    n.vy = to_float(vy);
    n.wx = to_float(wx);
    n.wy = to_float(wy);
    n.za = guide(hn::Sub(m, dv));
    n.zb = guide(hn::Add(m, dv));
    n.zc = guide(hn::Add(m, dl));
    n.zd = guide(hn::Sub(m, dl));

    // Quad::middle, inner, side of one side, as vectors.
    const auto outer = [&](VI middle, VI inner_x, VI inner_y, VI side_x, VI side_y,
                           Floats first_end) HWY_ATTR {
        const VI r0 = word(middle, 0), r1 = word(middle, 1);
        const VI ax = hn::Sub(hn::Add(byte<2>(r0), byte<0>(r1)), inner_x);
        const VI ay = hn::Sub(hn::Add(byte<3>(r0), byte<1>(r1)), inner_y);
        const auto absent = hn::Eq(hn::Or(ax, ay), hn::Zero(di));
        Neighbourhood<Floats>::Outer o;
        o.ox = to_float(hn::ShiftRight<1>(hn::Add(ax, side_x)));
        o.oy = to_float(hn::ShiftRight<1>(hn::Add(ay, side_y)));
        const auto absent_float = hn::RebindMask(D(), absent);
        o.z = hn::IfThenElse(absent_float, first_end.v, guide(hn::Add(middle, offset(ax, ay))).v);
        o.present = hn::IfThenElse(absent_float, hn::Zero(D()), hn::Set(D(), 1.0f));
        return o;
    };
    const VI zero = hn::Zero(di);
    n.outer[0] = outer(hn::Sub(m, du), hn::Add(vx, ux), hn::Add(vy, uy), wx, wy, n.za);
    n.outer[1] = outer(hn::Add(m, dw), hn::Sub(zero, hn::Add(vx, wx)),
                       hn::Sub(zero, hn::Add(vy, wy)), ux, uy, n.zc);
    n.outer[2] = outer(hn::Add(m, du), hn::Sub(zero, hn::Add(vx, ux)),
                       hn::Sub(zero, hn::Add(vy, uy)), hn::Sub(zero, wx), hn::Sub(zero, wy), n.zb);
    n.outer[3] = outer(hn::Sub(m, dw), hn::Add(vx, wx), hn::Add(vy, wy), hn::Sub(zero, ux),
                       hn::Sub(zero, uy), n.zd);
    return flip_gain<Cost_>(n).v;
}

template <class Cost_>
HWY_INLINE void each_block(const Lattice& lattice, const int* sites, size_t count, float* out) {
    const D d;
    const DI di;
    const size_t lanes = hn::Lanes(d);
    HWY_ALIGN int32_t site[HWY_MAX_BYTES / sizeof(int32_t)];
    HWY_ALIGN float gain[HWY_MAX_BYTES / sizeof(float)];
    for (size_t i = 0; i < count; i += lanes) {
        // The last block repeats its first edge to fill the lanes.
        const size_t used = count - i < lanes ? count - i : lanes;
        for (size_t k = 0; k < lanes; ++k)
            site[k] = sites[i + (k < used ? k : 0)];
        hn::Store(gains_of<Cost_>(lattice, hn::Load(di, site)), d, gain);
        for (size_t k = 0; k < used; ++k)
            out[site[k]] = gain[k];
    }
}

HWY_ATTR void gains(const Lattice& lattice, Cost cost, const int* sites, size_t count, float* out) {
    switch (cost) {
#define DDT_CALL(name, Class, ...)                                                                 \
    case Cost::name:                                                                               \
        return each_block<Class<Floats>>(lattice, sites, count, out);
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

void gains(const Lattice& lattice, Cost cost, const int* sites, size_t n, float* out) {
    HWY_DYNAMIC_DISPATCH(gains)(lattice, cost, sites, n, out);
}

} // namespace ddt
#endif
