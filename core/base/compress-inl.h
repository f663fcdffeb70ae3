// SPDX-License-Identifier: Apache-2.0
// Included inside a SIMD target's namespace, where hn is Highway's, with tag DI of int32_t.

/// Store the lanes of `mask` side by side and whatever else fills a vector; returns how many they
/// are. In place of hn::CompressStore(): with AVX-512 on Zen 4 the instruction that compresses into
/// memory takes 80 cycles, far longer than one into a register and a store.
HWY_INLINE size_t store_compressed(hn::Vec<DI> lanes, hn::Mask<DI> mask, int32_t* to) {
    const DI di;
    hn::StoreU(hn::Compress(lanes, mask), di, to);
    return hn::CountTrue(di, mask);
}
