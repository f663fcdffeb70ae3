// SPDX-License-Identifier: Apache-2.0
// Included inside a SIMD target's namespace: a vector of floats with the operators that the
// formulas are written in. D is a Highway tag of float.
// Needs: constants.h, vectors-inl.h.

/// Whether hn::Min(b, a) is b < a ? b : a, of NaN and of zeros of two signs too, and hn::Max alike:
/// x86's instructions are.
#if HWY_ARCH_X86 && !DDT_PLAIN_VECTORS
constexpr bool min_is_a_choice = true;
#else
constexpr bool min_is_a_choice = false;
#endif

/// Whether vectors are compared and blended by the compiler's operators. GCC 12 does not know that
/// what Highway's comparisons return has all bits of a lane alike, and finds its sign in a step of
/// its own before it blends; with masks (AVX-512) there is none.
#if HWY_ARCH_X86 && defined(__GNUC__) && !defined(__clang__) &&                                    \
    (HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_SSSE3)
constexpr bool choose_by_operators = true;
#else
constexpr bool choose_by_operators = false;
#endif

template <class D>
struct Lanes {
    hn::Vec<D> v;

    Lanes() = default;
    HWY_INLINE Lanes(hn::Vec<D> u) : v(u) {}
    /// x in every lane.
    HWY_INLINE explicit Lanes(float x) : v(hn::Set(D(), x)) {}

    static HWY_INLINE Lanes load(const float* p) { return hn::LoadU(D(), p); }
    HWY_INLINE void store(float* p) const { hn::StoreU(v, D(), p); }

    friend HWY_INLINE Lanes operator+(Lanes a, Lanes b) { return hn::Add(a.v, b.v); }
    friend HWY_INLINE Lanes operator-(Lanes a, Lanes b) { return hn::Sub(a.v, b.v); }
    friend HWY_INLINE Lanes operator*(Lanes a, Lanes b) { return hn::Mul(a.v, b.v); }

    friend HWY_INLINE Lanes rsqrt_seed(Lanes x) {
        const hn::RebindToSigned<D> di;
        const auto bits = hn::BitCast(di, x.v);
        return hn::BitCast(D(), hn::Sub(hn::Set(di, rsqrt_magic), hn::ShiftRight<1>(bits)));
    }
    /// a < b ? yes : no, a lane.
    friend HWY_INLINE Lanes if_less(Lanes a, Lanes b, Lanes yes, Lanes no) {
        if constexpr (choose_by_operators)
            return hn::Vec<D>{a.v.raw < b.v.raw ? yes.v.raw : no.v.raw};
        else
            return hn::IfThenElse(hn::Lt(a.v, b.v), yes.v, no.v);
    }
    /// Where the flag is more than 0 `yes`, else `no`; a lane.
    friend HWY_INLINE Lanes either(Lanes flag, Lanes yes, Lanes no) {
        return if_less(Lanes(0.0f), flag, yes, no);
    }
    /// The smaller or larger, where neither is NaN; of zeros of two signs, any.
    friend HWY_INLINE Lanes lane_min(Lanes a, Lanes b) { return hn::Min(a.v, b.v); }
    friend HWY_INLINE Lanes lane_max(Lanes a, Lanes b) { return hn::Max(a.v, b.v); }
    /// b where it is less, or more, than a, else a, so that a stays where either is NaN, and of
    /// zeros of two signs: what x86's instructions do in one step, and the GLSL twins alike.
    friend HWY_INLINE Lanes lower(Lanes a, Lanes b) {
        if constexpr (min_is_a_choice)
            return hn::Min(b.v, a.v);
        else
            return if_less(b, a, b, a);
    }
    friend HWY_INLINE Lanes upper(Lanes a, Lanes b) {
        if constexpr (min_is_a_choice)
            return hn::Max(b.v, a.v);
        else
            return if_less(a, b, b, a);
    }
    friend HWY_INLINE Lanes abs(Lanes a) { return hn::Abs(a.v); }
    /// Whether all lanes are from -limit to limit.
    static HWY_INLINE bool all_within(float limit, Lanes a) {
        return hn::AllTrue(D(), hn::Le(hn::Abs(a.v), hn::Set(D(), limit)));
    }
    /// a <= b ? yes : no, a lane.
    friend HWY_INLINE Lanes if_less_equal(Lanes a, Lanes b, Lanes yes, Lanes no) {
        if constexpr (choose_by_operators)
            return hn::Vec<D>{a.v.raw <= b.v.raw ? yes.v.raw : no.v.raw};
        else
            return hn::IfThenElse(hn::Le(a.v, b.v), yes.v, no.v);
    }
};
