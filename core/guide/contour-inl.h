// SPDX-License-Identifier: Apache-2.0
// Included inside a namespace, once for scalars and once for each SIMD target, where compilers make
// vectors of the loops over it. GLSL twin: shaders/contour.glsl.
// Needs: <cstdint>, arith.h, rsqrt-inl.h.

/// A structure tensor: sums of the products of the gradient's components.
struct Tensor {
    float xx, yy, xy;
};

/// Of a cell with these corners, row by row: 4 times the tensor of the mean gradient.
DDT_INLINE Tensor cell_tensor(float z0, float z1, float z2, float z3) {
    const float gx = (z1 - z0) + (z3 - z2), gy = (z2 - z0) + (z3 - z1);
    return {gx * gx, gy * gy, gx * gy};
}

/// 64 times the binomial mean of seven neighbours, the middle one d.
DDT_INLINE float smooth(float a, float b, float c, float d, float e, float f, float g) {
    return ((a + g) + 6.0f * (b + f)) + (15.0f * (c + e) + 20.0f * d);
}

/// v as an integer from 0 to contour_most; NaN as 0.
DDT_INLINE uint32_t to_steps(float v) {
    const float low = v > 0.0f ? v : 0.0f;
    return uint32_t(int32_t(low < contour_most ? low : contour_most));
}

/// The word of a cell (contour.h) from 4 * 64 * 64 times its smoothed tensor.
DDT_INLINE uint32_t contour_word(Tensor t) {
    const float r = rsqrt<2>((t.xx + t.yy) + contour_noise);
    // Of contrasts of 2e17 and more r is below 2^-63, and its square a denormal float, which some
    // devices have and others take for zero. So r is zero there: by a mask, since of a condition
    // GCC makes a branch, and then no vectors of the loop.
    const uint32_t size = bits_of(r) & 0x7fffffffu;
    const float s = float_of(bits_of(r) & uint32_t(int32_t(0x1fffffffu - size) >> 31));
    const float share = (s * s) * contour_scale;
    const float xx = t.xx * share, yy = t.yy * share, xy = t.xy * share;
    const float turn = (xx - yy) * 0.5f;
    const float trust = (turn * turn + xy * xy) * contour_trust;
    // The lesser of it and 1, of NaN 1, by the bits: here too a condition would be a branch.
    const uint32_t one = bits_of(1.0f), bits = bits_of(trust);
    const float within = float_of(bits < one ? bits : one);
    const float counted = within * within, less = turn * (1.0f - counted);
    return to_steps((xx - less) + contour_square_bias) |
           to_steps((yy + less) + contour_square_bias) << contour_bits |
           to_steps(xy * counted + contour_product_bias) << (2 * contour_bits);
}
