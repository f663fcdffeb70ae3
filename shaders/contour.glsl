// SPDX-License-Identifier: Apache-2.0
// Where the guide's contours run. C++ twins: core/guide/contour.h, which explains it, and
// core/guide/contour-inl.h.
#include "arith.glsl"

const float contour_noise = 0.05;
const float contour_least = 0.01;
const int contour_steps = 500;
const int contour_bits = 10;

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

uint to_steps(float v, float most) {
    float low = v > 0.0 ? v : 0.0;
    return uint(int(low < most ? low : most));
}

uint contour_word(vec3 t) {
    const float scale = 4.0 * 64.0 * 64.0;
    const float noise = scale * contour_noise * contour_noise;
    const float steps = float(contour_steps);
    const float least = contour_least * steps, zero = 0.5 * steps;
    precise float sum = (t.x + t.y) + noise;
    float r = rsqrt(2, sum);
    precise float share = (r * r) * steps;
    precise float xx = t.x * share + (least + 0.5), yy = t.y * share + (least + 0.5),
                  xy = t.z * share + (zero + 0.5);
    return to_steps(xx, steps + least) | to_steps(yy, steps + least) << contour_bits |
           to_steps(xy, steps) << (2 * contour_bits);
}

// Nxy of a cell's word, in steps.
int contour_xy(uint word) {
    return int(word >> (2 * contour_bits)) - contour_steps / 2;
}
