// SPDX-License-Identifier: Apache-2.0
// Included inside a namespace, once for scalars and once for each SIMD target, so that the formula
// stands in one place: T is float or a vector of floats with +, -, *. GLSL twin:
// shaders/arith.glsl.
// Needs: arith.h, rsqrt_seed() of T.

/// 1/sqrt(x) for x > 0 by `steps` Newton steps: with 3 to about 1 part in 10^7, with 1 to 1 in 500,
/// enough for a weight. rsqrt(0) is finite.
template <int steps, class T>
DDT_INLINE T rsqrt(T x) {
    const T half_x = T(0.5f) * x;
    T y = rsqrt_seed(x);
    for (int i = 0; i < steps; ++i)
        y = y * (T(1.5f) - (half_x * y) * y);
    return y;
}
