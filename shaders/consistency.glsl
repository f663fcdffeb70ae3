// SPDX-License-Identifier: Apache-2.0
// C++ twin: core/surface/consistency-inl.h, which says what the numbers mean.

struct QuadrantCell {
    vec4 v, x, y, d;
    vec4 vx, vy, xd, yd, diagonal;
    vec4 qvx, qvy, qxd, qyd, q_diagonal;
};

// The mean where the diagonal goes from V to D.
vec4 through(QuadrantCell c) {
    precise vec4 mean = ((c.x - c.v) + (c.y - c.v)) * (1.0 / 16.0) + (c.d - c.v) * (3.0 / 16.0);
#ifdef QUADRATIC
    mean = mean + ((c.diagonal * (1.0 / 8.0) + (c.vx + c.vy) * (5.0 / 128.0)) +
                   (c.xd + c.yd) * (1.0 / 128.0));
#endif
#ifdef SOFT
    mean = mean + ((c.q_diagonal * (3.0 / 16.0) + (c.qvx + c.qvy) * (1.0 / 16.0)) +
                   (c.qxd + c.qyd) * (1.0 / 32.0));
#endif
    return mean;
}

// The mean where it goes from X to Y.
vec4 across(QuadrantCell c) {
    precise vec4 mean = ((c.x - c.v) + (c.y - c.v)) * (1.0 / 4.0);
#ifdef QUADRATIC
    mean = mean + ((c.vx + c.vy) * (7.0 / 64.0) + c.diagonal * (1.0 / 16.0));
#endif
#ifdef SOFT
    mean = mean + ((c.qvx + c.qvy) * (7.0 / 32.0) + c.q_diagonal * (3.0 / 16.0));
#endif
    return mean;
}

vec4 corrected(vec4 z, vec4 source, vec4 sum, vec4 low, vec4 high) {
    precise vec4 step_ = (source - z) - sum * 0.25;
    precise vec4 negated = vec4(0.0) - step_;
    vec4 size = if_less(step_, vec4(0.0), negated, step_);
    precise vec4 moved = z + step_;
    moved = if_less(moved, low, low, moved);
    moved = if_less(high, moved, high, moved);
    return if_less_equal(size, vec4(largest), moved, z);
}

void widen(vec4 limit, float lowest, inout vec4 low, inout vec4 high) {
    const vec4 zero = vec4(0.0);
    precise vec4 margin = limit * (high - low);
    precise vec4 wide = low - margin;
    precise vec4 dim = low - limit * low;
    const vec4 bound = if_less(vec4(lowest), zero, vec4(lowest), if_less(dim, zero, zero, dim));
    precise vec4 raised = high + margin;
    high = raised;
    low = if_less(low, zero, wide, if_less(wide, bound, bound, wide));
}
