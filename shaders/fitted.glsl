// SPDX-License-Identifier: Apache-2.0
// Fitted vertices and bends. C++ twins: core/surface/fitted/features-inl.h, whose sums these are in
// the same order, and weights.h, which says what the numbers mean. After net.glsl.

layout(std140, binding = 1) uniform Fitted {
    vec4 fitted_node;
    float node_scale, index_epsilon, gain_scale, bend_limit;
    vec4 vertex_weights[8]; // two a node
    vec4 shared_weights[4];
    vec4 null_weights[36]; // four nodes, three kinds, three lengths
};

vec4 lower(vec4 a, vec4 b) {
    return if_less(b, a, b, a);
}
vec4 upper(vec4 a, vec4 b) {
    return if_less(a, b, b, a);
}

// The pixel at p; past the rim the picture goes on as its odd mirror image.
vec4 tap(ivec2 p, ivec2 size) {
    ivec2 c = clamp(p, ivec2(0), size - 1), m = clamp(2 * c - p, ivec2(0), size - 1);
    precise vec4 z = value_at(c);
    if (c.y != p.y) {
        precise vec4 twice = z + z;
        z = twice - value_at(ivec2(c.x, m.y));
    }
    if (c.x != p.x) {
        precise vec4 other = value_at(ivec2(m.x, c.y));
        if (c.y != p.y) {
            precise vec4 twice = other + other;
            other = twice - value_at(m);
        }
        precise vec4 twice = z + z;
        z = twice - other;
    }
    return z;
}

// v, or where it is not finite, `otherwise`.
vec4 finite_or(vec4 v, vec4 otherwise) {
    precise vec4 negated = vec4(0.0) - v;
    vec4 size = if_less(v, vec4(0.0), negated, v);
    return if_less_equal(size, vec4(largest_float), v, otherwise);
}

// v within a range; NaN stays.
vec4 clamped(vec4 v, vec4 low, vec4 high) {
    vec4 above = if_less(v, low, low, v);
    return if_less(high, above, high, above);
}

vec4 share(vec4 index, int k) {
    precise vec4 t = (index - fitted_node[k - 1]) * node_scale;
    return upper(vec4(0.0), lower(vec4(1.0), t));
}

// Where the vertex p goes. `step`: what a round of consistency would move it by.
vec4 fitted_vertex(ivec2 p, ivec2 size, vec4 step_, vec4 low, vec4 high, out vec4 index) {
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

    precise vec4 move = zero;
    for (int k = 0; k < 4; ++k) {
        vec4 v = vertex_weights[2 * k], u = vertex_weights[2 * k + 1];
        precise vec4 sum =
            ((v.x * f0 + v.y * f1) + (v.z * f2 + v.w * f3)) + (u.x * f4 + u.y * step_);
        if (k == 0)
            move = sum;
        else
            move = move + share(index, k) * sum;
    }
    precise vec4 moved = z + finite_or(move, zero);
    return finite_or(clamped(moved, low, high), z);
}

// The bend of the edge e with midpoint m (in doubled coordinates) and gain g. index: the mean of
// its ends'.
vec4 fitted_bend(Edge e, ivec2 m, float g, vec4 index, ivec2 size) {
    const vec4 zero = vec4(0.0);
    ivec2 l = is_zero(e.left) ? -e.right : e.left, r = is_zero(e.right) ? -e.left : e.right;
    // Row by row: through the midpoint, and one, two and three times as far as either apex.
    vec4 t[30];
    int n = 0;
    for (int row = 0; row < 7; ++row) {
        ivec2 d = (row + 1) / 2 * ((row & 1) != 0 ? l : r);
        int far = 5 - (row + 1) / 2;
        for (int k = -far; k <= far; k += 2)
            t[n++] = tap((m + d + k * e.v) / 2, size);
    }
    vec4 za = t[2], zb = t[3], zc = t[8], zd = t[13];
    precise vec4 middle = (za + zb) * 0.5;
    precise vec4 o0 = (t[1] + t[4]) * 0.5 - middle;
    precise vec4 o1 = (t[0] + t[5]) * 0.5 - middle;
    precise vec4 o2 = (zc + zd) * 0.5 - middle;
    precise vec4 o3 = ((t[7] + t[9]) + (t[12] + t[14])) * 0.25 - middle;
    precise vec4 o4 = ((t[6] + t[10]) + (t[11] + t[15])) * 0.25 - middle;
    precise vec4 o5 = ((t[17] + t[18]) + (t[21] + t[22])) * 0.25 - middle;
    precise vec4 o6 = ((t[16] + t[19]) + (t[20] + t[23])) * 0.25 - middle;
    precise vec4 o7 = (t[25] + t[28]) * 0.5 - middle;
    precise vec4 o8 = ((t[24] + t[26]) + (t[27] + t[29])) * 0.25 - middle;
    precise vec4 null0 = (o3 - o2) - 0.5 * o0;
    precise vec4 null1 = (o4 - o2) - 0.5 * (o0 + o1);
    precise vec4 null2 = (o5 - o6) - 0.5 * (o0 - o1);
    precise vec4 null3 = (o7 - o8) - (o0 - 0.5 * o1);
    precise vec4 difference = zb - za;
    precise vec4 opposite = zero - difference;
    vec4 rise = if_less(difference, zero, opposite, difference);
    precise vec4 falling = zero - rise;
    precise vec4 four = 4.0 * o0;
    vec4 ahead = upper(falling, lower(rise, four));
    precise vec4 range =
        upper(upper(za, zb), upper(zc, zd)) - lower(lower(za, zb), lower(zc, zd));
    vec4 plain = bend((m - e.v) / 2, (m + e.v) / 2);

    int square = e.v.x * e.v.x + e.v.y * e.v.y;
    int first = 12 * (square > 2 ? 2 : square - 1);
    precise float near = 0.0;
    if (flippable(e)) {
        float loss = g < 0.0 ? g : 0.0;
        near = 1.0 + loss * gain_scale;
        near = near > 0.0 ? near : 0.0;
    }
    precise vec4 f = zero;
    for (int k = 0; k < 4; ++k) {
        precise vec4 w = null_weights[first + k];
        if (flippable(e))
            w = null_weights[first + 4 + k] + near * null_weights[first + 8 + k];
        vec4 s = shared_weights[k];
        precise vec4 sum = ((w.x * null0 + w.y * null1) + (w.z * null2 + w.w * null3)) +
                           ((s.x * o0 + s.y * o1) + (s.z * plain + s.w * ahead));
        if (k == 0)
            f = sum;
        else
            f = f + share(index, k) * sum;
    }
    precise vec4 wide = bend_limit * range;
    vec4 limit = if_less(zero, strict, rise, wide);
    precise vec4 least = zero - limit;
    return finite_or(clamped(finite_or(f, plain), least, limit), plain);
}
