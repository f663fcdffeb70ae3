// SPDX-License-Identifier: Apache-2.0
// Included inside a SIMD target's namespace, where hn is Highway's, after lanes-inl.h, and with
// tags D of float and DI of int32_t, and core/guide/contour.h: a lattice's sites and vectors, one a
// lane.

using VI = hn::Vec<DI>;
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

/// A vector of n sites or, where there are fewer, n > 0, as many: lanes that are left over repeat
/// the first.
HWY_INLINE Ints load_sites(const int* sites, size_t n) {
    const DI di;
    const size_t lanes = hn::Lanes(di);
    if (n >= lanes)
        return {hn::LoadU(di, sites)};
    HWY_ALIGN int32_t all[HWY_MAX_BYTES / sizeof(int32_t)];
    for (size_t k = 0; k < lanes; ++k)
        all[k] = sites[k < n ? k : 0];
    return {hn::Load(di, all)};
}

#include "core/lattice/quad-inl.h"

/// A lattice as neighbourhood() (core/triangulate/gain-inl.h) sees it, a site a lane. A site is two
/// words; an edge's are (v, left), (right, stamp), a vertex's its guide and its contour.
struct SiteLanes {
    using Sites = Ints;
    using V = VecLanes;
    const int32_t* words;
    VI stride;

    explicit HWY_INLINE SiteLanes(const Lattice& lattice)
        : words(reinterpret_cast<const int32_t*>(lattice.sites())),
          stride(hn::Set(DI(), lattice.stride())) {}

    HWY_INLINE EdgeLanes edge(Ints m) const {
        // Both words at once, since a gather takes as long as it has lanes.
        const hn::Repartition<int64_t, DI> d64;
        const hn::Half<DI> half;
        const auto* sites = reinterpret_cast<const int64_t*>(words);
        const auto lower = hn::BitCast(
            DI(), hn::GatherIndex(d64, sites, hn::PromoteTo(d64, hn::LowerHalf(half, m.i))));
        const auto upper = hn::BitCast(
            DI(), hn::GatherIndex(d64, sites, hn::PromoteTo(d64, hn::UpperHalf(half, m.i))));
        const VI first = hn::ConcatEven(DI(), upper, lower),
                 second = hn::ConcatOdd(DI(), upper, lower);
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
    /// middle + offset(way), or middle where the apex is absent.
    HWY_INLINE Ints beyond(Ints middle, VecLanes apex, VecLanes way) const {
        const auto none = hn::RebindMask(DI(), absent(apex));
        return {hn::IfThenElse(none, middle.i, (middle + offset(way)).i)};
    }
    /// Vertex::first.
    HWY_INLINE VecLanes first(Ints vertex) const {
        const VI w = word(vertex, 1);
        return {byte<0>(w), byte<1>(w)};
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
