// SPDX-License-Identifier: Apache-2.0
// Where the guide's contours run. C++ twins: core/guide/contour.h, which explains it, and
// core/guide/contour-inl.h.
#include "arith.glsl"

// A structure tensor as xx, yy, xy.
vec3 cell_tensor(float z0, float z1, float z2, float z3) {
    precise float gx = (z1 - z0) + (z3 - z2), gy = (z2 - z0) + (z3 - z1);
    precise vec3 t = vec3(gx * gx, gy * gy, gx * gy);
    return t;
}

vec3 smooth_(vec3 a, vec3 b, vec3 c, vec3 d, vec3 e, vec3 f, vec3 g) {
    precise vec3 sum = ((a + g) + 6.0 * (b + f)) + (15.0 * (c + e) + 20.0 * d);
    return sum;
}

uint to_steps(float v) {
    precise float low = v > 0.0 ? v : 0.0;
    precise float within = low < contour_most ? low : contour_most;
    return uint(int(within));
}

uint contour_word(vec3 t) {
    precise float sum = (t.x + t.y) + contour_noise;
    precise float r = rsqrt(2, sum);
    // Of contrasts of 2e17 and more r is below 2^-63, and its square a denormal float, which some
    // devices have and others take for zero.
    precise float s = abs(r) < uintBitsToFloat(0x20000000u) ? 0.0 : r;
    precise float share = (s * s) * contour_scale;
    precise float xx = t.x * share, yy = t.y * share, xy = t.z * share;
    precise float turn = (xx - yy) * 0.5;
    precise float trust = (turn * turn + xy * xy) * contour_trust;
    precise float counted = trust < 1.0 ? trust * trust : 1.0, less = turn * (1.0 - counted);
    precise float nxx = (xx - less) + contour_square_bias, nyy = (yy + less) + contour_square_bias,
                  nxy = xy * counted + contour_product_bias;
    return to_steps(nxx) | to_steps(nyy) << contour_bits | to_steps(nxy) << (2 * contour_bits);
}

// Nxy of a cell's word, in steps.
int contour_xy(uint word) {
    return int(word >> (2 * contour_bits)) - contour_steps / 2;
}
