// SPDX-License-Identifier: Apache-2.0
// The bend of a fitted edge. C++ twin: core/surface/fitted/features-inl.h, whose sums are in
// the same order. After fitted.glsl.

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
