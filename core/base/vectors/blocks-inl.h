// SPDX-License-Identifier: Apache-2.0
// Included inside a SIMD target's namespace: vectors of blocks of group_size lanes, a lane a
// channel. A block is a vertex, an edge or a position.
// Needs: constants.h (group_size), lanes-inl.h.

constexpr int most_blocks = 4;
using D = hn::CappedTag<float, most_blocks * group_size>;
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

/// In each block, lane k of to[c] is lane c of from[k].
template <class D_>
HWY_INLINE void transpose(const Lanes<D_> (&from)[group_size], Lanes<D_> (&to)[group_size]) {
    static_assert(group_size == 4, "the order");
    const D_ d;
    const auto first = hn::InterleaveLower(d, from[0].v, from[2].v),
               second = hn::InterleaveLower(d, from[1].v, from[3].v),
               third = hn::InterleaveUpper(d, from[0].v, from[2].v),
               fourth = hn::InterleaveUpper(d, from[1].v, from[3].v);
    to[0] = hn::InterleaveLower(d, first, second);
    to[1] = hn::InterleaveUpper(d, first, second);
    to[2] = hn::InterleaveLower(d, third, fourth);
    to[3] = hn::InterleaveUpper(d, third, fourth);
}

/// Lane i of channel[c] filled with row[places[i] + c].
HWY_INLINE void load_channels(const float* row, const int64_t* places,
                              Blocks (&channel)[group_size]) {
    Blocks pixels[group_size];
    for (int k = 0; k < group_size; ++k) {
        const float* at[most_blocks];
        for (int b = 0; b < blocks_in_vector(); ++b)
            at[b] = row + places[b * group_size + k];
        pixels[k] = load_each(at);
    }
    transpose(pixels, channel);
}
