// SPDX-License-Identifier: Apache-2.0
// Included inside a SIMD target's namespace: a lattice's sites and vectors, one a lane.
// Needs: contour.h, gathers.h, lattice.h, lanes-inl.h, tags D of float and DI of int32_t.

#include "core/base/vectors/places-inl.h"

using VI = hn::Vec<DI>;
using Floats = Lanes<D>;

/// Sites, one a lane, or what differs between them.
struct Ints {
    VI i;
    friend HWY_INLINE Ints operator+(Ints a, Ints b) { return {hn::Add(a.i, b.i)}; }
    friend HWY_INLINE Ints operator-(Ints a, Ints b) { return {hn::Sub(a.i, b.i)}; }
};

/// Bytes k and k + 1 of each lane as the upper ones of its two 16 bits; what is below goes.
template <int k>
HWY_INLINE VI upper_bytes(VI word) {
#if DDT_PLAIN_VECTORS
    // Nothing puts bytes in any order there.
    static_assert(k == 0 || k == 2, "one shift or another");
    const VI x = k == 0 ? hn::ShiftLeft<8>(word) : hn::ShiftRight<8>(word),
             y = k == 0 ? hn::ShiftLeft<16>(word) : word;
    return hn::Or(hn::And(x, hn::Set(DI(), 0xff00)), hn::AndNot(hn::Set(DI(), 0xffffff), y));
#else
    const hn::Repartition<uint8_t, DI> d8;
    HWY_ALIGN static constexpr uint8_t from[16] = {k,      k,      k,      k + 1, k + 4, k + 4,
                                                   k + 4,  k + 5,  k + 8,  k + 8, k + 8, k + 9,
                                                   k + 12, k + 12, k + 12, k + 13};
    return hn::BitCast(DI(), hn::TableLookupBytes(hn::BitCast(d8, word), hn::LoadDup128(d8, from)));
#endif
}

/// Twin of Vec: x in the lower, y in the upper 16 bits of a lane, which leave room for sums, so
/// that both are added at once.
struct VecLanes {
    using D16 = hn::Repartition<int16_t, DI>;
    VI xy;

    HWY_INLINE hn::Vec<D16> halves() const { return hn::BitCast(D16(), xy); }
    static HWY_INLINE VecLanes of(hn::Vec<D16> halves) { return {hn::BitCast(DI(), halves)}; }

    friend HWY_INLINE VecLanes operator+(VecLanes a, VecLanes b) {
        return of(hn::Add(a.halves(), b.halves()));
    }
    friend HWY_INLINE VecLanes operator-(VecLanes a, VecLanes b) {
        return of(hn::Sub(a.halves(), b.halves()));
    }
    friend HWY_INLINE VecLanes operator-(VecLanes a) {
        return of(hn::Sub(hn::Zero(D16()), a.halves()));
    }
    static HWY_INLINE VecLanes ones() { return {hn::Set(DI(), 0x00010001)}; }
    friend HWY_INLINE VecLanes half(VecLanes a) { return of(hn::ShiftRight<1>(a.halves())); }
    friend HWY_INLINE VecLanes odd(VecLanes a) { return {hn::And(a.xy, ones().xy)}; }
    friend HWY_INLINE VecLanes even(VecLanes a) { return {hn::AndNot(a.xy, ones().xy)}; }
    /// Bytes k and k + 1 of each lane, which are a vector's.
    template <int k>
    static HWY_INLINE VecLanes of_bytes(VI word) {
        return of(hn::ShiftRight<8>(hn::BitCast(D16(), upper_bytes<k>(word))));
    }

    HWY_INLINE VI x() const { return hn::ShiftRight<16>(hn::ShiftLeft<16>(xy)); }
    HWY_INLINE VI y() const { return hn::ShiftRight<16>(xy); }
    /// As two signed bytes, x in the lowest; those above are 0.
    HWY_INLINE VI bytes() const {
        const VI byte = hn::Set(DI(), 255);
        return hn::Or(hn::And(xy, byte), hn::And(hn::ShiftRight<8>(xy), hn::ShiftLeft<8>(byte)));
    }
    HWY_INLINE hn::Mask<DI> zero() const { return hn::Eq(xy, hn::Zero(DI())); }
};

/// A vector of n sites, or what is known of each, or, where there are fewer, n > 0, as many: lanes
/// that are left over repeat the first.
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

/// Of an edge that can be flipped: the right apex is opposite to the left.
struct FlippableLanes {
    VecLanes v, left;
    /// From SiteLanes::first_word().
    static HWY_INLINE FlippableLanes of(VI first) {
        return {VecLanes::of_bytes<0>(first), VecLanes::of_bytes<2>(first)};
    }
};
/// Twin of Edge.
struct EdgeLanes {
    VecLanes v, left, right;
};
/// The two words of edges' records.
struct RecordLanes {
    VI first, second;

    static HWY_INLINE RecordLanes of(const TwoWords& records) {
        return {records.first(), records.second()};
    }

    HWY_INLINE hn::Mask<DI> rigid() const {
        return hn::Eq(hn::ShiftRight<16>(second), hn::Set(DI(), int16_t(rigid_mark)));
    }
    HWY_INLINE VecLanes left() const { return VecLanes::of_bytes<2>(first); }
    HWY_INLINE EdgeLanes edge() const {
        const VecLanes l = left();
        return {VecLanes::of_bytes<0>(first),
                l,
                {hn::IfThenElse(rigid(), VecLanes::of_bytes<0>(second).xy, VecLanes(-l).xy)}};
    }
    HWY_INLINE VecLanes apexes() const {
        return {hn::IfThenElseZero(rigid(), VecLanes(left() + VecLanes::of_bytes<0>(second)).xy)};
    }
    /// Of flippable edges the gains; of others less.
    HWY_INLINE Floats gain() const { return hn::BitCast(D(), second); }
};

/// A lattice, no wider than widest_lanes, as neighbourhood() (core/triangulate/gain-inl.h) sees it,
/// a site a lane.
struct SiteLanes {
    using Sites = Ints;
    using V = VecLanes;

    explicit HWY_INLINE SiteLanes(const Lattice& lattice)
        : m_sites(lattice.sites()), m_weights{hn::Set(DI(), lattice.stride() << 16 | 1)} {}

    HWY_INLINE FlippableLanes flippable_edge(Ints m) const {
        return FlippableLanes::of(first_word(m));
    }
    HWY_INLINE VI first_word(Ints m) const {
        static_assert(offsetof(Edge, v) == 0 && offsetof(Edge, left) == 2, "the word's bytes");
        return word(m, 0);
    }
    /// Of flippable edges the gains; of others less.
    HWY_INLINE Floats gain(Ints m) const { return hn::BitCast(D(), word(m, offsetof(Edge, word))); }
    /// Of the quads' sides k, whose midpoints are these.
    HWY_INLINE RecordLanes side(int, Ints middle) const { return record(middle); }
    HWY_INLINE EdgeLanes edge(Ints m) const { return record(m).edge(); }
    HWY_INLINE RecordLanes record(Ints m) const {
        static_assert(offsetof(Edge, v) == 0 && offsetof(Edge, left) == 2 &&
                          offsetof(Edge, word) == 4,
                      "the words' bytes");
        // Whole records, since a gather takes as long as it has lanes.
        return RecordLanes::of(m_sites.records(m.i));
    }
    /// Of n sites, whole vectors, for RecordLanes::of(load_copied()).
    HWY_INLINE void copy_records(const int* sites, size_t n, uint64_t* to) const {
        m_sites.copy_records(sites, n, to);
    }
    HWY_INLINE Ints offset(VecLanes v) const {
#if HWY_ARCH_X86 && !DDT_PLAIN_VECTORS
        // One instruction, but on x86 alone it adds products that are beside one another.
        const VI zero = hn::Zero(DI());
        VI none = zero;
        return {hn::ReorderWidenMulAccumulate(DI(), v.halves(), m_weights.halves(), zero, none)};
#else
        return {hn::Add(hn::Mul(v.y(), m_weights.y()), v.x())};
#endif
    }
    HWY_INLINE Floats guide(Ints m) const {
        return hn::BitCast(D(), word(m, 0));
    }
    HWY_INLINE Floats x(VecLanes v) const {
        return hn::ConvertTo(D(), v.x());
    }
    HWY_INLINE Floats y(VecLanes v) const {
        return hn::ConvertTo(D(), v.y());
    }
    HWY_INLINE Floats present(VecLanes apex) const {
        return hn::IfThenElse(absent(apex), hn::Zero(D()), hn::Set(D(), 1.0f));
    }
    HWY_INLINE Floats guide_beyond(Ints middle, VecLanes apex, Floats otherwise) const {
        return hn::IfThenElse(absent(apex), otherwise.v, guide(middle + offset(apex)).v);
    }
    /// `there`, or `otherwise` where the apex is absent.
    HWY_INLINE Ints if_present(VecLanes apex, Ints there, Ints otherwise) const {
        return {hn::IfThenElse(apex.zero(), otherwise.i, there.i)};
    }
    /// Vertex::first.
    HWY_INLINE VecLanes first(Ints vertex) const {
        return VecLanes::of_bytes<0>(word(vertex, 4));
    }
    HWY_INLINE Ints contour(Ints corner) const {
        return {word(corner, 4)};
    }
    /// Integer k of contour words or their sums.
    template <int k>
    HWY_INLINE Floats steps(Ints contours) const {
        const VI mask = hn::Set(DI(), contour_mask);
        return hn::ConvertTo(D(), hn::And(hn::ShiftRight<k * contour_bits>(contours.i), mask));
    }

private:
    /// The four bytes from `byte` on of each site.
    HWY_INLINE VI word(Ints m, int byte) const {
        static_assert(sizeof(Site) == 8, "the shift");
        return m_sites.words(byte, m.i);
    }
    static HWY_INLINE hn::Mask<D> absent(VecLanes apex) {
        return hn::RebindMask(D(), apex.zero());
    }

    Places m_sites;
    VecLanes m_weights; ///< of a vector's coordinates in its offset
};
