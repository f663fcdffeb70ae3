// SPDX-License-Identifier: Apache-2.0
// Included inside a SIMD target's namespace, after lanes-inl.h: vectors of blocks of group_size
// lanes, a lane a channel. A block is a vertex, an edge or a position.

using D = hn::CappedTag<float, 4 * group_size>;
using Blocks = Lanes<D>;

/// Blocks in a vector.
HWY_INLINE int blocks_in_vector() {
    return int(hn::Lanes(D())) / group_size;
}

/// Block k filled with p[k].
HWY_INLINE Blocks spread(const float* p) {
    const D d;
    const hn::RebindToSigned<D> di;
    const auto block = hn::ShiftRight<2>(hn::Iota(di, 0));
    return hn::TableLookupLanes(hn::LoadU(d, p), hn::IndicesFromVec(d, block));
}

/// Block k filled with the group_size floats at p[k].
template <class D_ = D>
HWY_INLINE hn::Vec<D_> load_each(const float* const* p) {
    if constexpr (hn::MaxLanes(D_()) <= group_size) {
        return hn::LoadU(D_(), p[0]);
    } else {
        using Part = hn::Half<D_>;
        const auto lower = load_each<Part>(p);
        return hn::Combine(D_(), load_each<Part>(p + hn::MaxLanes(Part()) / group_size), lower);
    }
}

/// Every block filled with the group_size numbers at p.
HWY_INLINE Blocks in_every_block(const float* p) {
    return Blocks(hn::LoadDup128(D(), p));
}
