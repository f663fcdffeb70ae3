// SPDX-License-Identifier: Apache-2.0
// Where a fitted vertex goes. C++ twin: core/surface/fitted/features-inl.h, whose sums are in
// the same order. After consistency.glsl and fitted.glsl.

vec4 at_bound(vec4 distance) {
    precise vec4 t = vec4(1.0) - distance;
    return upper(vec4(0.0), lower(vec4(1.0), t));
}

// Where the vertex p goes. `step`: what a round of consistency would move it by; low, high: the
// range of its 3x3 pixels.
vec4 fitted_vertex(ivec2 p, ivec2 size, vec4 step_, vec4 limit, float lowest, vec4 low, vec4 high,
                   out vec4 index) {
    const vec4 zero = vec4(0.0);
    vec4 w[25];
    for (int i = 0; i < 25; ++i)
        w[i] = tap(p + ivec2(i % 5, i / 5) - 2, size);
    vec4 z = w[12];
    precise vec4 sum0 = (w[11] + w[13]) + (w[7] + w[17]);
    precise vec4 sum1 = (w[6] + w[18]) + (w[8] + w[16]);
    precise vec4 sum2 = (w[10] + w[14]) + (w[2] + w[22]);
    precise vec4 sum3 =
        ((w[5] + w[19]) + (w[9] + w[15])) + ((w[1] + w[23]) + (w[3] + w[21]));
    precise vec4 sum4 = (w[0] + w[24]) + (w[4] + w[20]);
    precise vec4 f0 = sum0 * 0.25 - z;
    precise vec4 f1 = sum1 * 0.25 - z;
    precise vec4 f2 = sum2 * 0.25 - z;
    precise vec4 f3 = sum3 * 0.125 - z;
    precise vec4 f4 = sum4 * 0.25 - z;

    vec4 least = z, most = z;
    for (int i = 0; i < 25; ++i) {
        least = lower(least, w[i]);
        most = upper(most, w[i]);
    }
    precise vec4 near = zero;
    for (int y = 0; y < 25; y += 5) {
        precise vec4 row = zero;
        for (int i = y; i < y + 5; ++i) {
            precise vec4 above = w[i] - least;
            precise vec4 below = most - w[i];
            row = row + lower(above, below);
        }
        near = near + row;
    }
    precise vec4 spread = (most - least) * 25.0 + index_epsilon;
    precise vec4 r = rsqrt(3, spread);
    precise vec4 reciprocal = r * r;
    precise vec4 quotient = near * reciprocal;
    index = quotient;
    precise vec4 above_black = least * black_scale;
    precise vec4 below_white = (vec4(1.0) - most) * white_scale;
    vec4 dark = at_bound(above_black), bright = at_bound(below_white);
    precise vec4 both = (most - z) * dark + (z - least) * bright;
    precise vec4 share_of_both = both * (25.0 * reciprocal);
    vec4 kept = lowest < 0.0 ? strict : vec4(1.0);
    vec4 bound = if_less(zero, kept, zero, share_of_both);
    precise vec4 widened = limit + limit * (bound * bound_limit);
    widen(widened, lowest, low, high);

    precise vec4 move = zero;
    for (int k = 0; k < 4; ++k) {
        vec4 v = vertex_weights[2 * k], u = vertex_weights[2 * k + 1];
        precise vec4 sum =
            ((v.x * f0 + v.y * f1) + (v.z * f2 + v.w * f3)) + (u.x * f4 + u.y * step_);
        v = bound_weights[2 * k];
        u = bound_weights[2 * k + 1];
        precise vec4 more =
            ((v.x * f0 + v.y * f1) + (v.z * f2 + v.w * f3)) + (u.x * f4 + u.y * step_);
        sum = sum + bound * more;
        if (k == 0)
            move = sum;
        else
            move = move + share(index, k) * sum;
    }
    precise vec4 moved = z + finite_or(move, zero);
    return finite_or(clamped(moved, low, high), z);
}
