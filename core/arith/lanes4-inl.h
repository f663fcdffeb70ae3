// Included inside a SIMD target's namespace, where hn is Highway's: four floats, one a channel,
// with the operators the formulas are written in. On a target without vectors, four scalars.

using D4 = hn::CappedTag<float, 4>;

#if HWY_TARGET == HWY_SCALAR
struct Lanes4 {
    float v[4];
    Lanes4() = default;
    explicit Lanes4(float x) : v{x, x, x, x} {}
    static Lanes4 load(const float* p) {
        return make([p](int i) { return p[i]; });
    }
    void store(float* p) const { std::memcpy(p, v, sizeof v); }
    template <class F>
    static Lanes4 make(F&& f) {
        Lanes4 r;
        for (int i = 0; i < 4; ++i)
            r.v[i] = f(i);
        return r;
    }
};
inline Lanes4 operator+(Lanes4 a, Lanes4 b) {
    return Lanes4::make([&](int i) { return a.v[i] + b.v[i]; });
}
inline Lanes4 operator-(Lanes4 a, Lanes4 b) {
    return Lanes4::make([&](int i) { return a.v[i] - b.v[i]; });
}
inline Lanes4 operator*(Lanes4 a, Lanes4 b) {
    return Lanes4::make([&](int i) { return a.v[i] * b.v[i]; });
}
inline Lanes4 rsqrt_seed(Lanes4 x) {
    return Lanes4::make([&](int i) { return scalar::rsqrt_seed(x.v[i]); });
}
/// a < b ? yes : no, a lane.
inline Lanes4 if_less(Lanes4 a, Lanes4 b, Lanes4 yes, Lanes4 no) {
    return Lanes4::make([&](int i) { return a.v[i] < b.v[i] ? yes.v[i] : no.v[i]; });
}
/// a <= b ? yes : no, a lane.
inline Lanes4 if_less_equal(Lanes4 a, Lanes4 b, Lanes4 yes, Lanes4 no) {
    return Lanes4::make([&](int i) { return a.v[i] <= b.v[i] ? yes.v[i] : no.v[i]; });
}
#else
struct Lanes4 {
    hn::Vec<D4> v;
    Lanes4() = default;
    HWY_INLINE Lanes4(hn::Vec<D4> u) : v(u) {}
    HWY_INLINE explicit Lanes4(float x) : v(hn::Set(D4(), x)) {}
    static HWY_INLINE Lanes4 load(const float* p) { return hn::LoadU(D4(), p); }
    HWY_INLINE void store(float* p) const { hn::StoreU(v, D4(), p); }
};
HWY_INLINE Lanes4 operator+(Lanes4 a, Lanes4 b) {
    return hn::Add(a.v, b.v);
}
HWY_INLINE Lanes4 operator-(Lanes4 a, Lanes4 b) {
    return hn::Sub(a.v, b.v);
}
HWY_INLINE Lanes4 operator*(Lanes4 a, Lanes4 b) {
    return hn::Mul(a.v, b.v);
}
HWY_INLINE Lanes4 rsqrt_seed(Lanes4 x) {
    const hn::RebindToSigned<D4> di;
    return hn::BitCast(D4(),
                       hn::Sub(hn::Set(di, rsqrt_magic), hn::ShiftRight<1>(hn::BitCast(di, x.v))));
}
/// a < b ? yes : no, a lane.
HWY_INLINE Lanes4 if_less(Lanes4 a, Lanes4 b, Lanes4 yes, Lanes4 no) {
    return hn::IfThenElse(hn::Lt(a.v, b.v), yes.v, no.v);
}
/// a <= b ? yes : no, a lane.
HWY_INLINE Lanes4 if_less_equal(Lanes4 a, Lanes4 b, Lanes4 yes, Lanes4 no) {
    return hn::IfThenElse(hn::Le(a.v, b.v), yes.v, no.v);
}
#endif
