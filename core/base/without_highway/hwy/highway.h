// SPDX-License-Identifier: Apache-2.0
// Stands in for Highway where that is not installed or not wanted (DDT_HIGHWAY=OFF): what the
// project uses of it, by its names, for one target with vectors of four lanes, which are the
// compiler's own (vector_size; GCC 11 and clang 14 have them on any processor). The bits are the
// same, since each operation rounds once; functions do what Highway promises of them, for the types
// and in the ranges they are called with here.
//
// In the include path instead of Highway, never beside it. A group of channels (four) fits a
// vector.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#define HWY_NAMESPACE N_PLAIN
#define HWY_BEFORE_NAMESPACE() static_assert(true, "")
#define HWY_AFTER_NAMESPACE() static_assert(true, "")
#define HWY_ONCE 1
#define HWY_ATTR
#define HWY_INLINE inline __attribute__((always_inline))
#define HWY_NOINLINE __attribute__((noinline))
#define HWY_ALIGN alignas(16)
#define HWY_MAX_BYTES 16
#define HWY_EXPORT(function) static_assert(true, "")
#define HWY_DYNAMIC_DISPATCH(function) N_PLAIN::function
#define HWY_STATIC_TARGET 1

namespace hwy {

// For tests, which run on each target.
static inline int64_t SupportedTargets() {
    return HWY_STATIC_TARGET;
}
static inline std::vector<int64_t> SupportedAndGeneratedTargets() {
    return {HWY_STATIC_TARGET};
}
static inline void SetSupportedTargetsForTest(int64_t) {}
static inline const char* TargetName(int64_t) {
    return "without Highway";
}
namespace {
struct ChosenTarget {
    void Update(int64_t) {}
};
} // namespace
static inline ChosenTarget GetChosenTarget() {
    return {};
}

namespace HWY_NAMESPACE {

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
HWY_INLINE constexpr size_t Lanes(D) {
    return D::lanes;
}
template <class D>
HWY_INLINE constexpr size_t MaxLanes(D) {
    return D::lanes;
}

// In and out of memory.

template <class D>
HWY_INLINE Vec<D> LoadU(D, const typename D::T* p) {
    Vec<D> v{};
    std::memcpy(&v, p, sizeof v);
    return v;
}
template <class D>
HWY_INLINE Vec<D> Load(D d, const typename D::T* p) {
    return LoadU(d, p);
}
template <class D>
HWY_INLINE Vec<D> LoadDup128(D d, const typename D::T* p) {
    static_assert(sizeof(Vec<D>) == 16, "one block of 128 bits");
    return LoadU(d, p);
}
template <class D>
HWY_INLINE void StoreU(Vec<D> v, D, typename D::T* p) {
    std::memcpy(p, &v, sizeof v);
}
template <class D>
HWY_INLINE void Store(Vec<D> v, D d, typename D::T* p) {
    StoreU(v, d, p);
}
/// An ordinary store: nothing is promised of caches.
template <class D>
HWY_INLINE void Stream(Vec<D> v, D d, typename D::T* p) {
    StoreU(v, d, p);
}
template <class D>
HWY_INLINE void BlendedStore(Vec<D> v, Mask<D> mask, D d, typename D::T* p) {
    StoreU(mask ? v : LoadU(d, p), d, p);
}
template <class D>
HWY_INLINE void StoreInterleaved2(Vec<D> a, Vec<D> b, D, typename D::T* p) {
    for (size_t i = 0; i < D::lanes; ++i) {
        p[2 * i] = a[i];
        p[2 * i + 1] = b[i];
    }
}
template <class D>
HWY_INLINE void LoadInterleaved2(D, const typename D::T* p, Vec<D>& a, Vec<D>& b) {
    for (size_t i = 0; i < D::lanes; ++i) {
        a[i] = p[2 * i];
        b[i] = p[2 * i + 1];
    }
}
template <class D>
HWY_INLINE void StoreInterleaved4(Vec<D> a, Vec<D> b, Vec<D> c, Vec<D> e, D, typename D::T* p) {
    for (size_t i = 0; i < D::lanes; ++i) {
        p[4 * i] = a[i];
        p[4 * i + 1] = b[i];
        p[4 * i + 2] = c[i];
        p[4 * i + 3] = e[i];
    }
}
template <class D, class I>
HWY_INLINE Vec<D> GatherIndex(D, const typename D::T* p, I index) {
    Vec<D> v{};
    for (size_t i = 0; i < D::lanes; ++i)
        v[i] = p[index[i]];
    return v;
}
/// Offsets are bytes.
template <class D, class I>
HWY_INLINE Vec<D> GatherOffset(D, const typename D::T* p, I offset) {
    Vec<D> v{};
    for (size_t i = 0; i < D::lanes; ++i) {
        typename D::T x;
        std::memcpy(&x, reinterpret_cast<const char*>(p) + offset[i], sizeof x);
        v[i] = x;
    }
    return v;
}
/// The lanes of the mask side by side, then any.
template <class V, class M>
HWY_INLINE V Compress(V v, M mask) {
    size_t count = 0;
    for (size_t i = 0; i < sizeof v / sizeof v[0]; ++i)
        if (mask[i])
            v[count++] = v[i];
    return v;
}
/// Bit i of the first bytes: lane i.
template <class D>
HWY_INLINE size_t StoreMaskBits(D, Mask<D> mask, uint8_t* bits) {
    static_assert(D::lanes <= 8, "one byte");
    bits[0] = 0;
    for (size_t i = 0; i < D::lanes; ++i)
        bits[0] = uint8_t(bits[0] | (mask[i] ? 1 << i : 0));
    return 1;
}

// The same in every lane, or by the lane's number.

template <class D>
HWY_INLINE Vec<D> Zero(D) {
    return Vec<D>{};
}
template <class D>
HWY_INLINE Vec<D> Set(D, typename D::T x) {
    return x - Vec<D>{}; // -0 too is itself then
}
template <class D>
HWY_INLINE Vec<D> Iota(D, typename D::T first) {
    Vec<D> v{};
    for (size_t i = 0; i < D::lanes; ++i)
        v[i] = first + typename D::T(i);
    return v;
}
template <class D>
HWY_INLINE Mask<D> FirstN(D, size_t n) {
    Mask<D> mask{};
    for (size_t i = 0; i < D::lanes; ++i)
        mask[i] = i < n ? -1 : 0;
    return mask;
}

// Lane by lane.

template <class V>
HWY_INLINE V Add(V a, V b) {
    return a + b;
}
template <class V>
HWY_INLINE V Sub(V a, V b) {
    return a - b;
}
template <class V>
HWY_INLINE V Mul(V a, V b) {
    return a * b;
}
template <class V>
HWY_INLINE V And(V a, V b) {
    return a & b;
}
template <class V>
HWY_INLINE V AndNot(V a, V b) {
    return ~a & b;
}
template <class V>
HWY_INLINE V Or(V a, V b) {
    return a | b;
}
template <class V>
HWY_INLINE V Xor(V a, V b) {
    return a ^ b;
}
template <int bits, class V>
HWY_INLINE V ShiftLeft(V a) {
    return a << bits;
}
template <int bits, class V>
HWY_INLINE V ShiftRight(V a) {
    return a >> bits;
}
template <class V>
HWY_INLINE V Shl(V a, V bits) {
    return a << bits;
}
template <class V>
HWY_INLINE V ShiftRightSame(V a, int bits) {
    return a >> bits;
}
template <class V>
HWY_INLINE V BroadcastSignBit(V a) {
    return a >> 31;
}
template <class V>
HWY_INLINE auto Lt(V a, V b) {
    return a < b;
}
template <class V>
HWY_INLINE auto Le(V a, V b) {
    return a <= b;
}
template <class V>
HWY_INLINE auto Gt(V a, V b) {
    return a > b;
}
template <class V>
HWY_INLINE auto Eq(V a, V b) {
    return a == b;
}
template <class V>
HWY_INLINE auto TestBit(V a, V bit) {
    return (a & bit) != 0;
}
template <class M, class V>
HWY_INLINE V IfThenElse(M mask, V yes, V no) {
    return mask ? yes : no;
}
template <class M, class V>
HWY_INLINE V IfThenElseZero(M mask, V yes) {
    return mask ? yes : V{};
}
template <class M, class V>
HWY_INLINE V IfThenZeroElse(M mask, V no) {
    return mask ? V{} : no;
}
template <class V>
HWY_INLINE V Min(V a, V b) {
    return a < b ? a : b;
}
template <class V>
HWY_INLINE V Max(V a, V b) {
    return a > b ? a : b;
}
template <class V>
HWY_INLINE V Abs(V a) {
    if constexpr (std::is_integral<std::decay_t<decltype(a[0])>>::value)
        return a < 0 ? -a : a;
    else
        return (V)((decltype(a < a))a & 0x7fffffff);
}
/// Of floats, to the nearest, of two the even one: adding 2^23 leaves no room for a fraction.
template <class V>
HWY_INLINE V Round(V a) {
    using I = decltype(a < a);
    const V size = Abs(a), whole = (size + 8388608.0f) - 8388608.0f;
    const V with_sign = (V)((I)whole | ((I)a & ~0x7fffffff));
    return size < 8388608.0f ? with_sign : a;
}

// From one type to another.

template <class D, class V>
HWY_INLINE Vec<D> BitCast(D, V v) {
    return (Vec<D>)v;
}
template <class D, class V>
HWY_INLINE Vec<D> ConvertTo(D, V v) {
    return __builtin_convertvector(v, Vec<D>);
}
template <class D, class M>
HWY_INLINE Mask<D> RebindMask(D, M mask) {
    return mask;
}
template <class D, class V>
HWY_INLINE Vec<D> PromoteTo(D, V v) {
    return __builtin_convertvector(v, Vec<D>);
}
/// Signed numbers of 32 bits to the nearest ones of D, which has fewer and no signs.
template <class D, class V>
HWY_INLINE Vec<D> DemoteTo(D, V v) {
    using T = typename D::T;
    static_assert(T(-1) > 0 && sizeof(T) < 4, "");
    Vec<D> demoted{};
    for (size_t i = 0; i < D::lanes; ++i)
        demoted[i] = T(v[i] < 0 ? 0 : v[i] > T(-1) ? T(-1) : v[i]);
    return demoted;
}

// Across lanes.

template <class V>
HWY_INLINE auto GetLane(V v) {
    return v[0];
}
template <class V>
HWY_INLINE auto ExtractLane(V v, size_t i) {
    return v[i];
}
template <class H, class V>
HWY_INLINE Vec<H> LowerHalf(H, V v) {
    Vec<H> half{};
    for (size_t i = 0; i < H::lanes; ++i)
        half[i] = v[i];
    return half;
}
template <class H, class V>
HWY_INLINE Vec<H> UpperHalf(H, V v) {
    Vec<H> half{};
    for (size_t i = 0; i < H::lanes; ++i)
        half[i] = v[H::lanes + i];
    return half;
}
/// Twice as many lanes: those of `lower`, then those of `upper`.
template <class D, class V>
HWY_INLINE Vec<D> Combine(D, V upper, V lower) {
    Vec<D> v{};
    for (size_t i = 0; i < D::lanes / 2; ++i) {
        v[i] = lower[i];
        v[D::lanes / 2 + i] = upper[i];
    }
    return v;
}
/// The first, or last, two of four lanes of each, by turns.
template <class D>
HWY_INLINE Vec<D> InterleaveLower(D, Vec<D> a, Vec<D> b) {
    static_assert(D::lanes == 4, "one block of 128 bits");
    return Vec<D>{a[0], b[0], a[1], b[1]};
}
template <class D>
HWY_INLINE Vec<D> InterleaveUpper(D, Vec<D> a, Vec<D> b) {
    static_assert(D::lanes == 4, "one block of 128 bits");
    return Vec<D>{a[2], b[2], a[3], b[3]};
}
/// The even, or odd, lanes of `lower`, then those of `upper`.
template <class D>
HWY_INLINE Vec<D> ConcatEven(D, Vec<D> upper, Vec<D> lower) {
    Vec<D> v{};
    for (size_t i = 0; i < D::lanes; ++i)
        v[i] = 2 * i < D::lanes ? lower[2 * i] : upper[2 * i - D::lanes];
    return v;
}
template <class D>
HWY_INLINE Vec<D> ConcatOdd(D, Vec<D> upper, Vec<D> lower) {
    Vec<D> v{};
    for (size_t i = 0; i < D::lanes; ++i)
        v[i] = 2 * i < D::lanes ? lower[2 * i + 1] : upper[2 * i + 1 - D::lanes];
    return v;
}
/// The odd lanes of one, the even ones of the other.
template <class V>
HWY_INLINE V OddEven(V odd, V even) {
    for (size_t i = 1; i < sizeof(V) / sizeof(odd[0]); i += 2)
        even[i] = odd[i];
    return even;
}
template <class D, class I>
HWY_INLINE I IndicesFromVec(D, I index) {
    return index;
}
template <class V, class I>
HWY_INLINE V TableLookupLanes(V v, I index) {
    V result{};
    for (size_t i = 0; i < sizeof(V) / sizeof(v[0]); ++i)
        result[i] = v[index[i]];
    return result;
}
/// Of bytes, in a vector of one block of 128 bits.
template <class V>
HWY_INLINE V TableLookupBytes(V v, V from) {
    return TableLookupLanes(v, from);
}
template <class D>
HWY_INLINE size_t CountTrue(D, Mask<D> mask) {
    size_t count = 0;
    for (size_t i = 0; i < D::lanes; ++i)
        count += mask[i] != 0;
    return count;
}
template <class D>
HWY_INLINE bool AllTrue(D d, Mask<D> mask) {
    return CountTrue(d, mask) == D::lanes;
}
template <class D>
HWY_INLINE bool AllFalse(D d, Mask<D> mask) {
    return CountTrue(d, mask) == 0;
}

} // namespace HWY_NAMESPACE
} // namespace hwy
