// SPDX-License-Identifier: Apache-2.0
// What a vertex' pixels are like. C++ twin: core/surface/fitted/features-inl.h, whose sums are in
// the same order. After fitted.glsl.

// The 5x5 pixels about a vertex, row by row, their range, and 1 / (25 times that).
struct Surroundings {
    vec4 w[25], least, most, reciprocal;
};

Surroundings surroundings(ivec2 p, ivec2 size) {
    Surroundings s;
    for (int i = 0; i < 25; ++i)
        s.w[i] = tap(p + ivec2(i % 5, i / 5) - 2, size);
    s.least = s.w[12];
    s.most = s.w[12];
    for (int i = 0; i < 25; ++i) {
        s.least = lower(s.least, s.w[i]);
        s.most = upper(s.most, s.w[i]);
    }
    precise vec4 spread = (s.most - s.least) * 25.0 + index_epsilon;
    precise vec4 r = rsqrt(3, spread);
    precise vec4 reciprocal = r * r;
    s.reciprocal = reciprocal;
    return s;
}

// What the weights at a vertex and along its edges depend on.
vec4 index_of(Surroundings s) {
    precise vec4 near = vec4(0.0);
    for (int y = 0; y < 25; y += 5) {
        precise vec4 row = vec4(0.0);
        for (int i = y; i < y + 5; ++i) {
            precise vec4 above = s.w[i] - s.least;
            precise vec4 below = s.most - s.w[i];
            row = row + lower(above, below);
        }
        near = near + row;
    }
    precise vec4 index = near * s.reciprocal;
    return index;
}
