// SPDX-License-Identifier: Apache-2.0
// Vectors of four lanes, which are the compiler's own (vector_size; GCC 11 and clang 14 have them
// on any processor): what the project uses of Highway, by its names. For processors of which
// Highway knows no instruction set (core/base/vectors/vectors-inl.h), and for builds without
// Highway (core/base/vectors/without_highway). The bits are the same, since each operation rounds
// once; functions do what Highway promises of them, for the types and in the ranges they are called
// with here.
//
// A group of channels (four) fits a vector. Lanes come from a list, never one by one into a vector,
// which compilers then keep in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#include "core/base/arith.h"

namespace ddt::plain_vectors {

/// A tag: vectors of n numbers of type T_.
template <class T_, size_t n>
struct Tag {
    using T = T_;
    static constexpr size_t lanes = n;
    typedef T V __attribute__((vector_size(n * sizeof(T))));
};
template <class T>
using ScalableTag = Tag<T, 4>;
template <class T, size_t most>
using CappedTag = Tag<T, (most < 4 ? most : 4)>;
template <class T, class D>
using Rebind = Tag<T, D::lanes>;
template <class D>
using RebindToSigned = Rebind<std::conditional_t<sizeof(typename D::T) == 8, int64_t, int32_t>, D>;
template <class D>
using RebindToUnsigned = Rebind<uint32_t, D>;
/// As many bytes, of another type; half as many numbers.
template <class T, class D>
using Repartition = Tag<T, D::lanes * sizeof(typename D::T) / sizeof(T)>;
template <class D>
using Half = Tag<typename D::T, D::lanes / 2>;

template <class D>
using Vec = typename D::V;
/// -1 in lanes that are true, 0 in others.
template <class D>
using Mask = typename RebindToSigned<D>::V;

template <class D>
DDT_INLINE constexpr size_t Lanes(D) {
    return D::lanes;
}
template <class D>
DDT_INLINE constexpr size_t MaxLanes(D) {
    return D::lanes;
}

/// The vector of f(0), f(1), ...
template <class V, class F, size_t... lane>
DDT_INLINE V of_lanes(F&& f, std::index_sequence<lane...>) {
    return V{f(lane)...};
}
template <class V, class F>
DDT_INLINE V of_lanes(F&& f) {
    return of_lanes<V>(f, std::make_index_sequence<sizeof(V) / sizeof(V{}[0])>());
}

// In and out of memory.

template <class D>
DDT_INLINE Vec<D> LoadU(D, const typename D::T* p) {
    Vec<D> v{};
    std::memcpy(&v, p, sizeof v);
    return v;
}
template <class D>
DDT_INLINE Vec<D> Load(D d, const typename D::T* p) {
    return LoadU(d, p);
}
template <class D>
DDT_INLINE Vec<D> LoadDup128(D d, const typename D::T* p) {
    static_assert(sizeof(Vec<D>) == 16, "one block of 128 bits");
    return LoadU(d, p);
}
template <class D>
DDT_INLINE void StoreU(Vec<D> v, D, typename D::T* p) {
    std::memcpy(p, &v, sizeof v);
}
template <class D>
DDT_INLINE void Store(Vec<D> v, D d, typename D::T* p) {
    StoreU(v, d, p);
}
/// An ordinary store: nothing is promised of caches.
template <class D>
DDT_INLINE void Stream(Vec<D> v, D d, typename D::T* p) {
    StoreU(v, d, p);
}
template <class D>
DDT_INLINE void BlendedStore(Vec<D> v, Mask<D> mask, D d, typename D::T* p) {
    StoreU(mask ? v : LoadU(d, p), d, p);
}
template <class D>
DDT_INLINE void StoreInterleaved2(Vec<D> a, Vec<D> b, D, typename D::T* p) {
    for (size_t i = 0; i < D::lanes; ++i) {
        p[2 * i] = a[i];
        p[2 * i + 1] = b[i];
    }
}
template <class D>
DDT_INLINE void LoadInterleaved2(D, const typename D::T* p, Vec<D>& a, Vec<D>& b) {
    a = of_lanes<Vec<D>>([&](size_t i) DDT_INLINED { return p[2 * i]; });
    b = of_lanes<Vec<D>>([&](size_t i) DDT_INLINED { return p[2 * i + 1]; });
}
template <class D>
DDT_INLINE void StoreInterleaved4(Vec<D> a, Vec<D> b, Vec<D> c, Vec<D> e, D, typename D::T* p) {
    for (size_t i = 0; i < D::lanes; ++i) {
        p[4 * i] = a[i];
        p[4 * i + 1] = b[i];
        p[4 * i + 2] = c[i];
        p[4 * i + 3] = e[i];
    }
}
template <class D, class I>
DDT_INLINE Vec<D> GatherIndex(D, const typename D::T* p, I index) {
    return of_lanes<Vec<D>>([&](size_t i) DDT_INLINED { return p[index[i]]; });
}
/// The lanes of the mask side by side, then any.
template <class V, class M>
DDT_INLINE V Compress(V v, M mask) {
    constexpr size_t lanes = sizeof(V) / sizeof(v[0]);
    std::decay_t<decltype(v[0])> all[lanes];
    size_t count = 0;
    for (size_t i = 0; i < lanes; ++i) {
        all[count] = v[i]; // in the place of any that is not of the mask
        count += mask[i] & 1;
    }
    std::memcpy(&v, all, sizeof v);
    return v;
}
/// Bit i of the first bytes: lane i.
template <class D>
DDT_INLINE size_t StoreMaskBits(D, Mask<D> mask, uint8_t* bits) {
    static_assert(D::lanes <= 8, "one byte");
    const auto bit = mask & of_lanes<Mask<D>>([](size_t i) DDT_INLINED { return 1 << i; });
    int all = 0;
    for (size_t i = 0; i < D::lanes; ++i)
        all |= int(bit[i]);
    bits[0] = uint8_t(all);
    return 1;
}

// The same in every lane, or by the lane's number.

template <class D>
DDT_INLINE Vec<D> Zero(D) {
    return Vec<D>{};
}
template <class D>
DDT_INLINE Vec<D> Set(D, typename D::T x) {
    return x - Vec<D>{}; // -0 too is itself then
}
template <class D>
DDT_INLINE Vec<D> Iota(D, typename D::T first) {
    return of_lanes<Vec<D>>([&](size_t i) DDT_INLINED { return first + typename D::T(i); });
}
template <class D>
DDT_INLINE Mask<D> FirstN(D, size_t n) {
    return Iota(RebindToSigned<D>(), 0) < int(n < D::lanes ? n : D::lanes);
}

// Lane by lane.

template <class V>
DDT_INLINE V Add(V a, V b) {
    return a + b;
}
template <class V>
DDT_INLINE V Sub(V a, V b) {
    return a - b;
}
template <class V>
DDT_INLINE V Mul(V a, V b) {
    return a * b;
}
template <class V>
DDT_INLINE V And(V a, V b) {
    return a & b;
}
template <class V>
DDT_INLINE V AndNot(V a, V b) {
    return ~a & b;
}
template <class V>
DDT_INLINE V Or(V a, V b) {
    return a | b;
}
template <class V>
DDT_INLINE V Xor(V a, V b) {
    return a ^ b;
}
template <int bits, class V>
DDT_INLINE V ShiftLeft(V a) {
    return a << bits;
}
template <int bits, class V>
DDT_INLINE V ShiftRight(V a) {
    return a >> bits;
}
template <class V>
DDT_INLINE V Shl(V a, V bits) {
    return a << bits;
}
template <class V>
DDT_INLINE V ShiftRightSame(V a, int bits) {
    return a >> bits;
}
template <class V>
DDT_INLINE V BroadcastSignBit(V a) {
    return a >> 31;
}
template <class V>
DDT_INLINE auto Lt(V a, V b) {
    return a < b;
}
template <class V>
DDT_INLINE auto Le(V a, V b) {
    return a <= b;
}
template <class V>
DDT_INLINE auto Gt(V a, V b) {
    return a > b;
}
template <class V>
DDT_INLINE auto Eq(V a, V b) {
    return a == b;
}
template <class V>
DDT_INLINE auto TestBit(V a, V bit) {
    return (a & bit) != 0;
}
template <class M, class V>
DDT_INLINE V IfThenElse(M mask, V yes, V no) {
    return mask ? yes : no;
}
template <class M, class V>
DDT_INLINE V IfThenElseZero(M mask, V yes) {
    return mask ? yes : V{};
}
template <class M, class V>
DDT_INLINE V IfThenZeroElse(M mask, V no) {
    return mask ? V{} : no;
}
template <class V>
DDT_INLINE V Min(V a, V b) {
    return a < b ? a : b;
}
template <class V>
DDT_INLINE V Max(V a, V b) {
    return a > b ? a : b;
}
template <class V>
DDT_INLINE V Abs(V a) {
    if constexpr (std::is_integral<std::decay_t<decltype(a[0])>>::value)
        return a < 0 ? -a : a;
    else
        return (V)((decltype(a < a))a & 0x7fffffff);
}
/// Of floats, to the nearest, of two the even one: adding 2^23 leaves no room for a fraction.
template <class V>
DDT_INLINE V Round(V a) {
    using I = decltype(a < a);
    const V size = Abs(a), whole = (size + 8388608.0f) - 8388608.0f;
    const V with_sign = (V)((I)whole | ((I)a & ~0x7fffffff));
    return size < 8388608.0f ? with_sign : a;
}

// From one type to another.

template <class D, class V>
DDT_INLINE Vec<D> BitCast(D, V v) {
    return (Vec<D>)v;
}
template <class D, class V>
DDT_INLINE Vec<D> ConvertTo(D, V v) {
    return __builtin_convertvector(v, Vec<D>);
}
template <class D, class M>
DDT_INLINE Mask<D> RebindMask(D, M mask) {
    return mask;
}
template <class D, class V>
DDT_INLINE Vec<D> PromoteTo(D, V v) {
    return __builtin_convertvector(v, Vec<D>);
}
/// Signed numbers of 32 bits to the nearest ones of D, which has fewer and no signs.
template <class D, class V>
DDT_INLINE Vec<D> DemoteTo(D, V v) {
    using T = typename D::T;
    static_assert(T(-1) > 0 && sizeof(T) < 4, "");
    return __builtin_convertvector(Min(Max(v, V{}), Set(Rebind<int32_t, D>(), T(-1))), Vec<D>);
}

// Across lanes.

template <class V>
DDT_INLINE auto GetLane(V v) {
    return v[0];
}
template <class V>
DDT_INLINE auto ExtractLane(V v, size_t i) {
    return v[i];
}
template <class H, class V>
DDT_INLINE Vec<H> LowerHalf(H, V v) {
    return of_lanes<Vec<H>>([&](size_t i) DDT_INLINED { return v[i]; });
}
template <class H, class V>
DDT_INLINE Vec<H> UpperHalf(H, V v) {
    return of_lanes<Vec<H>>([&](size_t i) DDT_INLINED { return v[H::lanes + i]; });
}
/// Twice as many lanes: those of `lower`, then those of `upper`.
template <class D, class V>
DDT_INLINE Vec<D> Combine(D, V upper, V lower) {
    constexpr size_t half = D::lanes / 2;
    return of_lanes<Vec<D>>([&](size_t i)
                                DDT_INLINED { return i < half ? lower[i] : upper[i - half]; });
}
/// The first, or last, two of four lanes of each, by turns.
template <class D>
DDT_INLINE Vec<D> InterleaveLower(D, Vec<D> a, Vec<D> b) {
    static_assert(D::lanes == 4, "one block of 128 bits");
    return Vec<D>{a[0], b[0], a[1], b[1]};
}
template <class D>
DDT_INLINE Vec<D> InterleaveUpper(D, Vec<D> a, Vec<D> b) {
    static_assert(D::lanes == 4, "one block of 128 bits");
    return Vec<D>{a[2], b[2], a[3], b[3]};
}
/// The even, or odd, lanes of `lower`, then those of `upper`.
template <class D>
DDT_INLINE Vec<D> ConcatEven(D, Vec<D> upper, Vec<D> lower) {
    return of_lanes<Vec<D>>([&](size_t i) DDT_INLINED {
        return 2 * i < D::lanes ? lower[2 * i] : upper[2 * i - D::lanes];
    });
}
template <class D>
DDT_INLINE Vec<D> ConcatOdd(D, Vec<D> upper, Vec<D> lower) {
    return of_lanes<Vec<D>>([&](size_t i) DDT_INLINED {
        return 2 * i < D::lanes ? lower[2 * i + 1] : upper[2 * i + 1 - D::lanes];
    });
}
/// The odd lanes of one, the even ones of the other.
template <class V>
DDT_INLINE V OddEven(V odd, V even) {
    return of_lanes<V>([&](size_t i) DDT_INLINED { return i % 2 ? odd[i] : even[i]; });
}
template <class D, class I>
DDT_INLINE I IndicesFromVec(D, I index) {
    return index;
}
template <class V, class I>
DDT_INLINE V TableLookupLanes(V v, I index) {
    return of_lanes<V>([&](size_t i) DDT_INLINED { return v[index[i]]; });
}
template <class D>
DDT_INLINE size_t CountTrue(D, Mask<D> mask) {
    int count = 0;
    for (size_t i = 0; i < D::lanes; ++i)
        count -= int(mask[i]);
    return size_t(count);
}
template <class D>
DDT_INLINE bool AllTrue(D d, Mask<D> mask) {
    return CountTrue(d, mask) == D::lanes;
}
template <class D>
DDT_INLINE bool AllFalse(D d, Mask<D> mask) {
    return CountTrue(d, mask) == 0;
}

} // namespace ddt::plain_vectors
