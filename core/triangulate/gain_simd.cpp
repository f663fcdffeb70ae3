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

using Floats = Lanes<D>;

/// Sites, or coordinates of vectors, one a lane.
struct Ints {
    VI i;
    friend HWY_INLINE Ints operator+(Ints a, Ints b) { return {hn::Add(a.i, b.i)}; }
    friend HWY_INLINE Ints operator-(Ints a, Ints b) { return {hn::Sub(a.i, b.i)}; }
};
/// Twin of Vec.
struct VecLanes {
    Ints x, y;
    friend HWY_INLINE VecLanes operator+(VecLanes a, VecLanes b) { return {a.x + b.x, a.y + b.y}; }
    friend HWY_INLINE VecLanes operator-(VecLanes a, VecLanes b) { return {a.x - b.x, a.y - b.y}; }
    friend HWY_INLINE VecLanes operator-(VecLanes a) {
        const Ints zero{hn::Zero(DI())};
        return {zero - a.x, zero - a.y};
    }
    friend HWY_INLINE VecLanes half(VecLanes a) {
        return {{hn::ShiftRight<1>(a.x.i)}, {hn::ShiftRight<1>(a.y.i)}};
    }
    friend HWY_INLINE VecLanes odd(VecLanes a) {
        const VI one = hn::Set(DI(), 1);
        return {{hn::And(a.x.i, one)}, {hn::And(a.y.i, one)}};
    }
    friend HWY_INLINE VecLanes even(VecLanes a) {
        const VI one = hn::Set(DI(), 1);
        return {{hn::AndNot(a.x.i, one)}, {hn::AndNot(a.y.i, one)}};
    }
};
struct EdgeLanes {
    VecLanes v, left, right;
};

#include "core/lattice/quad-inl.h"
#include "core/triangulate/gain-inl.h"

/// A lattice as neighbourhood() sees it, a site a lane. A site is two words; an edge's are (v,
/// left), (right, stamp), a vertex's its guide and its contour.
struct SiteLanes {
    using Sites = Ints;
    using V = VecLanes;
    const int32_t* words;
    VI stride;

    explicit HWY_INLINE SiteLanes(const Lattice& lattice)
        : words(reinterpret_cast<const int32_t*>(lattice.sites())),
          stride(hn::Set(DI(), lattice.stride())) {}

    HWY_INLINE EdgeLanes edge(Ints m) const {
        const VI first = word(m, 0), second = word(m, 1);
        return {{byte<0>(first), byte<1>(first)},
                {byte<2>(first), byte<3>(first)},
                {byte<0>(second), byte<1>(second)}};
    }
    HWY_INLINE Ints offset(VecLanes v) const { return {hn::Add(hn::Mul(v.y.i, stride), v.x.i)}; }
    HWY_INLINE Floats guide(Ints m) const { return hn::BitCast(D(), word(m, 0)); }
    HWY_INLINE Floats number(Ints coordinate) const { return hn::ConvertTo(D(), coordinate.i); }
    HWY_INLINE Floats present(VecLanes apex) const {
        return hn::IfThenElse(absent(apex), hn::Zero(D()), hn::Set(D(), 1.0f));
    }
    HWY_INLINE Floats guide_beyond(Ints middle, VecLanes apex, Floats otherwise) const {
        return hn::IfThenElse(absent(apex), otherwise.v, guide(middle + offset(apex)).v);
    }
    HWY_INLINE Ints contour(Ints corner) const { return {word(corner, 1)}; }
    template <int k>
    HWY_INLINE Ints steps(Ints contours) const {
        const VI mask = hn::Set(DI(), contour_mask);
        return {hn::And(hn::ShiftRight<k * contour_bits>(contours.i), mask)};
    }

private:
    HWY_INLINE VI word(Ints m, int k) const {
        return hn::GatherIndex(DI(), words + k, hn::ShiftLeft<1>(m.i));
    }
    /// Byte k of each lane as a signed number.
    template <int k>
    static HWY_INLINE Ints byte(VI x) {
        return {hn::ShiftRight<24>(hn::ShiftLeft<24 - 8 * k>(x))};
    }
    static HWY_INLINE hn::Mask<D> absent(VecLanes apex) {
        return hn::RebindMask(D(), hn::Eq(hn::Or(apex.x.i, apex.y.i), hn::Zero(DI())));
    }
};

/// Gains of the edges at `m`, one a lane; `contour` times contour_unit of the contours', if any.
template <class Cost_>
HWY_INLINE hn::Vec<D> gains_of(const Lattice& lattice, float contour, VI m) {
    const SiteLanes mesh(lattice);
    if (contour == 0)
        return flip_gain<Cost_>(neighbourhood<Floats>(mesh, {m})).v;
    return gain_with_contours<Cost_, Floats>(mesh, {m}, contour).v;
}

template <class Cost_>
HWY_INLINE void each_block(const Lattice& lattice, float contour, const int* sites, size_t count,
                           float* out) {
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
        hn::Store(gains_of<Cost_>(lattice, contour, hn::Load(di, site)), d, gain);
        for (size_t k = 0; k < used; ++k)
            out[site[k]] = gain[k];
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
