// SPDX-License-Identifier: Apache-2.0
// Included inside a SIMD target's namespace, after lanes-inl.h: vectors of blocks of group_size
// lanes, a lane a channel. A block is a vertex, an edge or a position.

using D = hn::CappedTag<float, 4 * group_size>;
using Blocks = Lanes<D>;

/// Blocks in a vector.
HWY_INLINE int blocks_in_vector() {
    return int(hn::Lanes(D())) / group_size;
}

/// Go through x0 .. x1 - 1: several(x) for vectors of begin .. end - 1, which lie within, of which
/// the last may repeat some, and one(x) for the rest; for all where those would not fill a vector.
template <class One, class Several>
HWY_INLINE void each_vector(int x0, int x1, int begin, int end, One one, Several several) {
    const int step = blocks_in_vector();
    if (end - begin < step)
        begin = end = x1;
    for (int x = x0; x < begin; ++x)
        one(x);
    for (int x = end; x < x1; ++x)
        one(x);
    for (int x = begin; x < end; x += step)
        several(std::min(x, end - step));
}

/// Block k filled with p[k].
HWY_INLINE Blocks spread(const float* p) {
    const D d;
    const hn::RebindToSigned<D> di;
    const auto block = hn::ShiftRight<2>(hn::Iota(di, 0));
    return hn::TableLookupLanes(hn::LoadU(d, p), hn::IndicesFromVec(d, block));
}

/// Every block filled with the group_size numbers at p.
HWY_INLINE Blocks in_every_block(const float* p) {
    return Blocks(hn::LoadDup128(D(), p));
}

/// The neighbours p, p + 2 group_size, p + 4 group_size, ..., as many as there are blocks, in the
/// order that in_order() undoes. As many floats are read as two vectors have.
HWY_INLINE Blocks load_every_second(const float* p) {
    const D d;
    const auto odd = hn::SwapAdjacentBlocks(hn::LoadU(d, p + hn::Lanes(d)));
    return hn::OddEvenBlocks(odd, hn::LoadU(d, p));
}
/// Blocks 0, 2, 1, 3, where there are four.
HWY_INLINE Blocks in_order(Blocks v) {
    const D d;
    const hn::RebindToSigned<D> di;
    if (hn::Lanes(d) < 4 * group_size)
        return v;
    const auto lane = hn::Iota(di, 0), block = hn::ShiftRight<2>(lane);
    const auto is_first = hn::And(block, hn::Set(di, 1)), is_second = hn::ShiftRight<1>(block);
    const auto from = hn::Add(hn::ShiftLeft<1>(is_first), is_second);
    const auto within = hn::And(lane, hn::Set(di, group_size - 1));
    return hn::TableLookupLanes(v.v,
                                hn::IndicesFromVec(d, hn::Add(hn::ShiftLeft<2>(from), within)));
}

/// Block k to p + 2 k group_size.
HWY_INLINE void store_every_second(Blocks v, float* p) {
    HWY_ALIGN float blocks[4 * group_size];
    v.store(blocks);
    for (int k = 0; k < blocks_in_vector(); ++k)
        Lanes<hn::CappedTag<float, group_size>>::load(blocks + k * group_size)
            .store(p + 2 * k * group_size);
}
