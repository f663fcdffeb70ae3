// SPDX-License-Identifier: Apache-2.0
// Included inside a SIMD target's namespace: rows of pixels with `count` floats each as vectors,
// which need not begin or end where a pixel does. What is done to a float is the same for all, or
// differs by the pixel (spread()).
// Needs: <type_traits>, row_lanes.h, lanes-inl.h.

using RowTag = hn::CappedTag<float, most_lanes>;
using RowLanes = Lanes<RowTag>;
using OneLane = Lanes<hn::CappedTag<float, 1>>;

/// Call f(T(), place) for vectors that cover pixels x0 .. x1 - 1 and nothing else, T being RowLanes
/// and the last of them repeating some of the one before; or, where they would not fill a vector,
/// for each float, T being OneLane.
template <class F>
HWY_INLINE void each_vector(ptrdiff_t x0, ptrdiff_t x1, int count, F f) {
    const ptrdiff_t begin = x0 * count, end = x1 * count, lanes = hn::Lanes(RowTag());
    const auto place = [count](ptrdiff_t at) {
        const ptrdiff_t x = ptrdiff_t(uint32_t(at) / uint32_t(count));
        return RowPlace{at, x, int(at - x * count)};
    };
    if (end - begin < lanes)
        for (ptrdiff_t at = begin; at < end; ++at)
            f(OneLane(), place(at));
    else
        for (ptrdiff_t at = begin; at < end; at += lanes)
            f(RowLanes(), place(at + lanes <= end ? at : end - lanes));
}

/// Call f(T(), at) for vectors of the floats at first .. last - 1, and then for each that is left:
/// for none twice, so that what f stores may be what it loads.
template <class F>
HWY_INLINE void each_float_once(ptrdiff_t first, ptrdiff_t last, F f) {
    ptrdiff_t at = first;
    for (const ptrdiff_t lanes = hn::Lanes(RowTag()); at + lanes <= last; at += lanes)
        f(RowLanes(), at);
    for (; at < last; ++at)
        f(OneLane(), at);
}

/// p[x] of each lane's pixel x. As many floats are read as a vector has.
template <class T>
HWY_INLINE T spread(const float* p, const RowPlace& place, int count) {
    if constexpr (std::is_same_v<T, RowLanes>) {
        const RowTag d;
        const hn::RebindToSigned<RowTag> di;
        const auto pixels = hn::LoadU(di, pixel_of_lane.of[count - 1][place.c]);
        return hn::TableLookupLanes(hn::LoadU(d, p + place.x), hn::IndicesFromVec(d, pixels));
    } else {
        return T(p[place.x]);
    }
}

/// A pixel, or one pixel's share of what is computed: lanes from `count` on are nothing's.
using PixelLanes = Lanes<hn::CappedTag<float, most_in_pixel>>;

HWY_INLINE void store_pixel(PixelLanes v, int count, float* p) {
    if (count == most_in_pixel) {
        v.store(p);
        return;
    }
    const hn::CappedTag<float, 2> pair;
    if (count == 1) {
        p[0] = hn::GetLane(v.v);
        return;
    }
    hn::StoreU(hn::LowerHalf(pair, v.v), pair, p);
    if (count == 3)
        p[2] = hn::GetLane(hn::UpperHalf(pair, v.v));
}
