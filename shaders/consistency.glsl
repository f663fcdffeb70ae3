// SPDX-License-Identifier: Apache-2.0
// C++ twin: core/surface/consistency/consistency-inl.h, which says what the numbers mean.

struct QuadrantCell {
    vec4 v, x, y, d;
    vec4 vx, vy, xd, yd, diagonal;
    vec4 qvx, qvy, qxd, qyd, q_diagonal;
};

// The mean where the diagonal goes from V to D.
vec4 through(QuadrantCell c) {
    precise vec4 mean =
        ((c.x - c.v) + (c.y - c.v)) * through_beside + (c.d - c.v) * through_opposite;
#ifdef QUADRATIC
    mean = mean + ((c.diagonal * through_bend_diagonal + (c.vx + c.vy) * through_bend_near) +
                   (c.xd + c.yd) * through_bend_far);
#endif
#ifdef SOFT
    mean = mean + ((c.q_diagonal * through_soft_diagonal + (c.qvx + c.qvy) * through_soft_near) +
                   (c.qxd + c.qyd) * through_soft_far);
#endif
    return mean;
}

// The mean where it goes from X to Y.
vec4 across(QuadrantCell c) {
    precise vec4 mean = ((c.x - c.v) + (c.y - c.v)) * across_beside;
#ifdef QUADRATIC
    mean = mean + ((c.vx + c.vy) * across_bend_near + c.diagonal * across_bend_diagonal);
#endif
#ifdef SOFT
    mean = mean + ((c.qvx + c.qvy) * across_soft_near + c.q_diagonal * across_soft_diagonal);
#endif
    return mean;
}

vec4 corrected(vec4 z, vec4 source, vec4 sum, float share, vec4 low, vec4 high) {
    precise vec4 step_ = (source - z) - sum * share;
    precise vec4 negated = vec4(0.0) - step_;
    vec4 size = upper(step_, negated);
    precise vec4 moved = z + step_;
    return if_less_equal(size, vec4(largest_float), lower(upper(moved, low), high), z);
}

void widen(vec4 limit, bool clipped_, vec4 z, inout vec4 low, inout vec4 high) {
    const vec4 zero = vec4(0.0);
    precise vec4 margin = limit * (high - low);
    precise vec4 wide = low - margin;
    precise vec4 dim = low - limit * low;
    precise vec4 above_white = high - vec4(1.0);
    vec4 light = clipped_ ? zero : upper(zero, lower(vec4(1.0), above_white));
    precise vec4 half_ = z * 0.5;
    precise vec4 left = half_ * light;
    dim = upper(dim, left);
    precise vec4 negative = light * upper(wide, lower(z, half_)) + (vec4(1.0) - light) * wide;
    precise vec4 above_black = vec4(nearly_black) - low;
    precise vec4 grey = low * 0.5 - upper(zero, above_black) * black_fall;
    vec4 bound = clipped_ ? grey : if_less(dim, zero, zero, dim);
    precise vec4 raised = high + margin;
    vec4 sunk = if_less(low, zero, negative, if_less(wide, bound, bound, wide));
    high = if_less_equal(raised, vec4(largest_float), raised, high);
    low = if_less_equal(vec4(-largest_float), sunk, sunk, low);
}
