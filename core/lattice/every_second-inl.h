// SPDX-License-Identifier: Apache-2.0
// Included inside a SIMD target's namespace: the records of every second site.
// Needs: site.h, vectors-inl.h, a tag DI of int32_t.

/// The two words of the record of every second site, a lane each: along an even row of the doubled
/// lattice those of vertices, along an odd row of the cells' central edges.
struct EverySecond {
    hn::Vec<DI> first, second;

    /// Twice as many sites are read as a vector has lanes.
    HWY_INLINE explicit EverySecond(const Site* sites) {
        static_assert(sizeof(Site) == 2 * sizeof(int32_t), "two words");
        const hn::Repartition<int64_t, DI> d64;
        const size_t lanes = hn::Lanes(d64);
        const auto* from = reinterpret_cast<const int64_t*>(sites);
        const auto load = [&](size_t k) HWY_ATTR { return hn::LoadU(d64, from + k * lanes); };
        const auto lower = hn::BitCast(DI(), hn::ConcatEven(d64, load(1), load(0))),
                   upper = hn::BitCast(DI(), hn::ConcatEven(d64, load(3), load(2)));
        first = hn::ConcatEven(DI(), upper, lower);
        second = hn::ConcatOdd(DI(), upper, lower);
    }
};
