// SPDX-License-Identifier: Apache-2.0
// The bend of a fitted edge. C++ twin: core/surface/fitted/features-inl.h, whose sums are in
// the same order. After fitted.glsl.

// The mean of the pixels `along` halves of the edge, whose vector is v, away from m, both ways, and
// `far` times either apex (l, r) off it, in doubled coordinates.
vec4 mean_of_taps(ivec2 m, ivec2 v, ivec2 l, ivec2 r, int along, int far, ivec2 size) {
    ivec2 first = m + far * l, second = along == 0 ? m + far * r : first;
    precise vec4 sum = odd_mirror_tap((first - along * v) / 2, size) +
                       odd_mirror_tap((second + along * v) / 2, size);
    if (along == 0 || far == 0) {
        precise vec4 half_ = sum * 0.5;
        return half_;
    }
    second = m + far * r;
    precise vec4 others = odd_mirror_tap((second - along * v) / 2, size) +
                          odd_mirror_tap((second + along * v) / 2, size);
    precise vec4 quarter = (sum + others) * 0.25;
    return quarter;
}

// What an edge is bent by.
struct EdgeFeatures {
    vec4 null0, null1, null2, null3;
    vec4 o0, o1, plain, ahead; // EdgeFeatures::shared
    vec4 range;
};

// EdgeFeatures::find() of the edge e with midpoint m (in doubled coordinates).
EdgeFeatures find_features(Edge e, ivec2 m, ivec2 size) {
    const vec4 zero = vec4(0.0);
    ivec2 l = is_zero(e.left) ? -e.right : e.left, r = is_zero(e.right) ? -e.left : e.right;
    vec4 za = value_at((m - e.v) / 2), zb = value_at((m + e.v) / 2);
    vec4 zc = odd_mirror_tap((m + l) / 2, size), zd = odd_mirror_tap((m + r) / 2, size);
    precise vec4 middle = (za + zb) * 0.5;
    precise vec4 o2 = (zc + zd) * 0.5 - middle;
    // The means through the midpoint, and one, two and three times as far as either apex, the last
    // two put last in the row (see Side in lattice.glsl; an array would be in memory). The first
    // turns hand on what none has made.
    vec4 o0 = zero, o1 = zero, o3 = zero, o4 = zero, o5 = zero, o6 = zero, o7 = zero, o8 = zero;
    int far = 0;
    do {
        o0 = o3;
        o1 = o4;
        o3 = o5;
        o4 = o6;
        o5 = o7;
        o6 = o8;
        precise vec4 nearer = mean_of_taps(m, e.v, l, r, 3 - far, far, size) - middle;
        precise vec4 further = mean_of_taps(m, e.v, l, r, 5 - far, far, size) - middle;
        o7 = nearer;
        o8 = further;
        ++far;
    } while (far < 4);
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
    return EdgeFeatures(null0, null1, null2, null3, o0, o1, plain, ahead, range);
}

// The class of an edge with this vector in pixels.
int fitted_length(ivec2 v) {
    int square = v.x * v.x + v.y * v.y;
    return square > 2 ? 2 : square - 1;
}

// How nearly a flip of an edge with this gain would pay. C++ twin:
// core/surface/fitted/irregular_bends-inl.h.
float nearness(float gain) {
    precise float t = 1.0 + lower(0.0, gain) * gain_scale;
    return upper(0.0, t);
}

// The bend of the edge e with these features and this gain. index: the mean of its ends'.
vec4 fitted_bend(Edge e, EdgeFeatures edge, float gain, vec4 index) {
    const vec4 zero = vec4(0.0);
    int first = 12 * fitted_length(e.v);
    bool can = flippable(e);
    float near = nearness(gain);
    precise vec4 f = zero;
    for (int k = 0; k < 4; ++k) {
        precise vec4 w = null_weights[first + k];
        if (can)
            w = null_weights[first + 4 + k] + near * null_weights[first + 8 + k];
        vec4 s = shared_weights[k];
        precise vec4 sum =
            ((w.x * edge.null0 + w.y * edge.null1) + (w.z * edge.null2 + w.w * edge.null3)) +
            ((s.x * edge.o0 + s.y * edge.o1) + (s.z * edge.plain + s.w * edge.ahead));
        if (k == 0)
            f = sum;
        else
            f = f + share_of(index, k) * sum;
    }
    precise vec4 limit = bend_limit * edge.range;
    precise vec4 least = zero - limit;
    return finite_or(clamped(finite_or(f, edge.plain), least, limit), edge.plain);
}
