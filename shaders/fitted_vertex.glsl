// SPDX-License-Identifier: Apache-2.0
// Where a fitted vertex goes. C++ twin: core/surface/fitted/features-inl.h, whose sums are in
// the same order. After consistency.glsl and fitted_index.glsl.

vec4 at_bound(vec4 distance) {
    precise vec4 t = vec4(1.0) - distance;
    return upper(vec4(0.0), lower(vec4(1.0), t));
}

// Where the vertex with these surroundings and this index goes. `step`: what a round of consistency
// would move it by; low, high: the range of its 3x3 pixels.
vec4 fitted_vertex(Surroundings s, vec4 index, vec4 step_, vec4 limit, float lowest, vec4 low,
                   vec4 high) {
    const vec4 zero = vec4(0.0);
    vec4 z = near(12);
    precise vec4 sum0 = (near(11) + near(13)) + (near(7) + near(17));
    precise vec4 sum1 = (near(6) + near(18)) + (near(8) + near(16));
    precise vec4 sum2 = (near(10) + near(14)) + (near(2) + near(22));
    precise vec4 sum3 =
        ((near(5) + near(19)) + (near(9) + near(15))) + ((near(1) + near(23)) + (near(3) + near(21)));
    precise vec4 sum4 = (near(0) + near(24)) + (near(4) + near(20));
    precise vec4 f0 = sum0 * 0.25 - z;
    precise vec4 f1 = sum1 * 0.25 - z;
    precise vec4 f2 = sum2 * 0.25 - z;
    precise vec4 f3 = sum3 * 0.125 - z;
    precise vec4 f4 = sum4 * 0.25 - z;

    precise vec4 above_black = s.least * black_scale;
    precise vec4 below_white = (vec4(1.0) - s.most) * white_scale;
    vec4 dark = at_bound(above_black), bright = at_bound(below_white);
    precise vec4 both = (s.most - z) * dark + (z - s.least) * bright;
    precise vec4 share_of_both = both * (25.0 * s.reciprocal);
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
            move = move + share_of(index, k) * sum;
    }
    precise vec4 moved = z + finite_or(move, zero);
    return finite_or(clamped(moved, low, high), z);
}
