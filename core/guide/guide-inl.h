// SPDX-License-Identifier: Apache-2.0
// Included inside a namespace, once for scalars and once for each SIMD target, where compilers make
// vectors of the loops over it: so every choice is one between two numbers, both at hand, by
// integers: of floats that are not below 0, the bits are in the same order, and NaN is the largest.
// Needs: <cstdint>, arith.h, float_bits.h.

DDT_INLINE bool is_finite(float v) {
    return (bits_of(v) & 0x7f800000u) != 0x7f800000u;
}

// x^(5/12) for a normal positive x = m * 2^e, 1 <= m < 2, is 2^q * 2^(r/12) * m^(5/12) where
// 5e = 12q + r, 0 <= r < 12. (Other x give some number.)
DDT_INLINE float power_5_12(float x) {
    static const float twelfth[12] = {1.0f,        1.05946314f, 1.12246203f, 1.18920708f,
                                      1.25992107f, 1.33483982f, 1.41421354f, 1.49830711f,
                                      1.58740103f, 1.68179286f, 1.78179741f, 1.8877486f};
    // m^(5/12) in t = m - 1, through seven digits at six Chebyshev-Lobatto points of [1, 2]: both
    // ends are among them, so neighbouring octaves meet. Largest relative error 2^-18.7.
    const float c0 = 1.0f, c1 = 0.416594565f, c2 = -0.120247677f, c3 = 0.0571752861f,
                c4 = -0.0239196643f, c5 = 0.00523735536f;
    // Without the low 7 bits a step of the mantissa outweighs the rounding of what follows: the
    // curve can then not fall between neighbours.
    const uint32_t u = bits_of(x) & 0x7fffff80u;
    const uint32_t e5 = 5 * (u >> 23) + (12 * 128 - 5 * 127); // 5e + 12 * 128
    const uint32_t q = (e5 * 43691u) >> 19;                   // e5 / 12 for e5 < 2^16
    const float t = float_of((u & 0x007fffffu) | 0x3f800000u) - 1.0f;
    const float p = ((((c5 * t + c4) * t + c3) * t + c2) * t + c1) * t + c0;
    return p * twelfth[e5 - 12 * q] * float_of((q - 128 + 127) << 23);
}

DDT_INLINE float srgb_curve(float light) {
    const float a = float_of(bits_of(light) & 0x7fffffffu);
    const float linear = 12.92f * a, power = 1.055f * power_5_12(a) - 0.055f;
    const uint32_t v = choose(bits_of(a) <= bits_of(0.0031308f), bits_of(linear), bits_of(power));
    return float_of(v | (bits_of(light) & 0x80000000u));
}

DDT_INLINE float guide_step(float v) {
    const auto size = int32_t(bits_of(v) & 0x7fffffffu), most = int32_t(bits_of(guide_limit));
    const float within = float_of(uint32_t(size < most ? size : most)); // NaN can be converted so
    // Conversion to int drops the fraction: halves go away from 0, alike on both sides of it.
    const auto steps = int32_t(within * (1.0f / guide_unit) + 0.5f);
    const int32_t negative = int32_t(bits_of(v)) >> 31; // -1 or 0
    const float nearest = float((steps ^ negative) - negative) * guide_unit;
    return float_of(choose(is_finite(v), bits_of(nearest), 0));
}
