// SPDX-License-Identifier: Apache-2.0
// The surface's formulas, a lane a channel. C++ twins: core/surface/gradient-inl.h and
// core/surface/patch-inl.h.
#include "arith.glsl"

struct GradientMean {
    vec4 base_x, base_y, sum_x, sum_y, weight;
    bool begun;
};
const GradientMean no_triangles =
    GradientMean(vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), false);

// Add the triangle vertex, vertex + j, vertex + k, det(j, k) = 1, with value differences.
void add(inout GradientMean mean, ivec2 j, ivec2 k, vec4 dzj, vec4 dzk) {
    const vec4 zero = vec4(0.0);
    precise vec4 gx = dzj * float(k.y) - dzk * float(j.y);
    precise vec4 gy = dzk * float(j.x) - dzj * float(k.x);
    precise vec4 square = gx * gx + gy * gy;
    precise vec4 raised = square + gradient_epsilon;
    vec4 w = if_less_equal(square, vec4(largest_float), rsqrt(1, raised), zero);
    gx = if_less_equal(square, vec4(largest_float), gx, zero);
    gy = if_less_equal(square, vec4(largest_float), gy, zero);
    if (!mean.begun) {
        mean.base_x = gx;
        mean.base_y = gy;
        mean.begun = true;
    }
    // Small by a large gradient along the other axis.
    precise vec4 x = w * (gx - mean.base_x);
    precise vec4 y = w * (gy - mean.base_y);
    precise vec4 sum_x = mean.sum_x + without_denormals(x);
    precise vec4 sum_y = mean.sum_y + without_denormals(y);
    precise vec4 weight = mean.weight + w;
    // What is left where terms cancel; result() makes it large again where all gradients are.
    mean.sum_x = without_denormals(sum_x);
    mean.sum_y = without_denormals(sum_y);
    mean.weight = weight;
}

void result(GradientMean mean, out vec4 gx, out vec4 gy) {
    precise vec4 r = rsqrt(3, if_less(vec4(0.0), mean.weight, mean.weight, vec4(1.0)));
    precise vec4 reciprocal = r * r;
    precise vec4 beside_x = mean.sum_x * reciprocal;
    precise vec4 beside_y = mean.sum_y * reciprocal;
    precise vec4 x = mean.base_x + without_denormals(beside_x);
    precise vec4 y = mean.base_y + without_denormals(beside_y);
    gx = without_denormals(x);
    gy = without_denormals(y);
}

// e of the edge from i to j = i + v.
vec4 edge_bend(vec4 gix, vec4 giy, vec4 gjx, vec4 gjy, vec4 zi, vec4 zj, ivec2 v) {
    const vec4 zero = vec4(0.0);
    precise vec4 difference = zj - zi;
    precise vec4 negated = zero - difference;
    precise vec4 limit = upper(difference, negated);
    precise vec4 least = zero - limit;
    precise vec4 e = bend_strength * ((gix - gjx) * float(v.x) + (giy - gjy) * float(v.y));
    e = lower(upper(e, least), limit);
    return if_less_equal(limit, vec4(largest_float), e, zero);
}

// Weight of the flipped state of a flippable edge with this gain.
float soft_weight(float gain, float reciprocal_tau) {
    precise float w = soft_share * (1.0 + lower(0.0, gain) * reciprocal_tau);
    return upper(0.0, w);
}

// q of an edge from i to j with apexes c and d, weight w and bend e.
vec4 edge_softness(float w, vec4 zi, vec4 zj, vec4 zc, vec4 zd, vec4 e) {
    const vec4 zero = vec4(0.0);
    precise vec4 ends = zi + zj;
    precise vec4 blend = w * ((zc + zd) - ends);
    vec4 q = blend;
    vec4 low = lower(lower(zi, zj), upper(zc, zd));
    precise vec4 half_bend = 0.5 * e;
#if defined(BOUNDS_VERTICES)
    vec4 high = upper(upper(zi, zj), lower(zc, zd));
    precise vec4 least = ((low + low) - ends) - half_bend;
    precise vec4 most = ((high + high) - ends) - half_bend;
    least = lower(zero, least);
    most = upper(zero, most);
    q = lower(upper(blend, least), most);
#elif defined(BOUNDS_DARK)
    precise vec4 least = (2.0 * dark_share * low - ends) - half_bend;
    least = lower(zero, least);
    q = if_less_equal(zero, low, upper(blend, least), blend);
#endif
    precise vec4 negated = zero - blend;
    vec4 size = if_less(blend, zero, negated, blend);
    return if_less_equal(size, vec4(largest_float), q, zero);
}

struct Patch {
    vec4 z0, z1, z2, e01, e12, e20, q01, q12, q20, low, high;
};

// Unlike lower() and upper(), b stays unless a is strictly beyond it: so f, and NaN as f, stays
// where bounds are put to it.
float smaller(float a, float b) {
    precise float r = a < b ? a : b;
    return r;
}
vec4 smaller(vec4 a, vec4 b) {
    return if_less(a, b, a, b);
}
vec4 larger(vec4 a, vec4 b) {
    return if_less(b, a, a, b);
}

void find_range(inout Patch p) {
    p.low = smaller(p.z2, smaller(p.z1, p.z0));
    p.high = larger(p.z2, larger(p.z1, p.z0));
#ifndef BOUNDS_VERTICES
    const vec4 infinity = uintBitsToFloat(uvec4(0x7f800000u)),
               none = uintBitsToFloat(uvec4(0xff800000u));
#ifdef BOUNDS_DARK
    precise vec4 half_low = dark_share * p.low;
    p.low = if_less_equal(vec4(0.0), p.low, half_low, none);
#else
    p.low = none;
#endif
    p.high = infinity;
#endif
}

// b z, but 0 where b = 0, whatever z is.
vec4 term(float b, vec4 z) {
    precise vec4 t = b * z;
    precise vec4 r = b > 0.0 ? t : vec4(0.0);
    return r;
}

// The surface at barycentric weights b, all >= 0.
vec4 at(Patch p, float b0, float b1, float b2) {
    precise vec4 f = (term(b0, p.z0) + term(b1, p.z1)) + term(b2, p.z2);
#ifdef QUADRATIC
    precise float b01 = b0 * b1, b12 = b1 * b2, b20 = b2 * b0;
    f = f + ((b01 * p.e01 + b12 * p.e12) + b20 * p.e20);
#endif
#ifdef SOFT
    f = f + ((smaller(b0, b1) * p.q01 + smaller(b1, b2) * p.q12) + smaller(b2, b0) * p.q20);
#endif
    return smaller(p.high, larger(p.low, f));
}

// The mean of some surfaces at a position from that of all but the last, and the last, whose share
// is 1 / their number.
vec4 running_mean(vec4 mean, vec4 last, float share) {
    precise float others = 1.0 - share;
    precise vec4 f = mean * others + last * share;
    vec4 low = if_less(last, mean, last, mean), high = if_less(last, mean, mean, last);
    f = if_less(f, low, low, f);
    return if_less(high, f, high, f);
}

// The bits of a result: zeros have no sign, denormals are zeros, and all NaN are alike, which are
// known by their bits: compilers may take it that there are none.
uvec4 result_bits(vec4 f) {
    uvec4 own = floatBitsToUint(f);
    bvec4 is_nan = greaterThan(own & 0x7fffffffu, uvec4(0x7f800000u));
    uvec4 bits = if_true(lessThan(own & 0x7fffffffu, uvec4(0x00800000u)), uvec4(0u), own);
    return if_true(is_nan, uvec4(0x7fc00000u), bits);
}
