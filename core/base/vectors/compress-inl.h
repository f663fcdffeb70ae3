// SPDX-License-Identifier: Apache-2.0
// Included inside a SIMD target's namespace: lanes of a mask put side by side.
// Needs: compress_lanes.h, vectors-inl.h, a tag DI of int32_t.

/// The lanes of `mask`, side by side; what follows them is open.
HWY_INLINE hn::Vec<DI> compressed(hn::Vec<DI> lanes, hn::Mask<DI> mask) {
#if HWY_ARCH_X86 && HWY_TARGET == HWY_AVX2
    // Highway 1.0's table for hn::Compress() is copied to the stack by GCC each time.
    if constexpr (hn::MaxLanes(DI()) == 8) {
        const DI di;
        const hn::Rebind<uint8_t, DI> d8;
        uint8_t bits[8];
        hn::StoreMaskBits(di, mask, bits);
        const auto from = hn::PromoteTo(di, hn::LoadU(d8, compress_lanes.of[bits[0]]));
        return hn::TableLookupLanes(lanes, hn::IndicesFromVec(di, from));
    }
#endif
    return hn::Compress(lanes, mask);
}

/// Store the lanes of `mask` side by side and whatever else fills a vector; returns how many they
/// are. In place of hn::CompressStore(): with AVX-512 on Zen 4 the instruction that compresses into
/// memory takes 80 cycles, far longer than one into a register and a store.
HWY_INLINE size_t store_compressed(hn::Vec<DI> lanes, hn::Mask<DI> mask, int32_t* to) {
    const DI di;
    hn::StoreU(compressed(lanes, mask), di, to);
    return hn::CountTrue(di, mask);
}
