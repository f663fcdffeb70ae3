// SPDX-License-Identifier: Apache-2.0
// What a vertex' pixels are like. C++ twin: core/surface/fitted/features-inl.h, whose sums are in
// the same order. After fitted.glsl.

// How far the taps of VertexFeatures are from their vertex along an axis, in pixels.
const int vertex_taps = 2;

// The pixels of a group and the taps about them. (An array of its own for each invocation would be
// in memory on GPUs: registers have no indices.)
const int near_width = SURFACE_GROUP_X + 2 * vertex_taps,
          near_height = SURFACE_GROUP_Y + 2 * vertex_taps;
shared vec4 near_pixel[near_width * near_height];

// By all of a group, before a barrier.
void read_near(ivec2 size) {
    ivec2 corner = ivec2(gl_WorkGroupID.xy) * ivec2(SURFACE_GROUP_X, SURFACE_GROUP_Y) -
                   vertex_taps;
    for (int i = int(gl_LocalInvocationIndex); i < near_width * near_height;
         i += SURFACE_GROUP_X * SURFACE_GROUP_Y)
        near_pixel[i] = odd_mirror_tap(corner + ivec2(i % near_width, i / near_width), size);
}

// The 5x5 pixels about the vertex of this invocation, row by row.
vec4 near(int i) {
    return near_pixel[(int(gl_LocalInvocationID.y) + i / 5) * near_width +
                      int(gl_LocalInvocationID.x) + i % 5];
}

// The range of the 5x5 pixels about a vertex, and 1 / (25 times that).
struct Surroundings {
    vec4 low, high, reciprocal;
};

Surroundings surroundings() {
    Surroundings s;
    s.low = near(12);
    s.high = s.low;
    for (int i = 0; i < 25; ++i) {
        s.low = lower(s.low, near(i));
        s.high = upper(s.high, near(i));
    }
    precise vec4 spread = (s.high - s.low) * 25.0 + index_epsilon;
    precise vec4 r = rsqrt(3, spread);
    precise vec4 reciprocal = r * r;
    // Of ranges of 1e36 and more that is a denormal float, if not zero as in the C++ twin: some
    // devices have them. It is one where r is nearer to zero than 2^-63.
    s.reciprocal = if_less(abs(r), vec4(uintBitsToFloat(0x20000000u)), vec4(0.0), reciprocal);
    return s;
}

// What the weights at a vertex and along its edges depend on.
vec4 index_of(Surroundings s) {
    precise vec4 sum = vec4(0.0);
    for (int y = 0; y < 25; y += 5) {
        precise vec4 row = vec4(0.0);
        for (int i = y; i < y + 5; ++i) {
            precise vec4 above = near(i) - s.low, below = s.high - near(i);
            row = row + lower(above, below);
        }
        sum = sum + row;
    }
    precise vec4 index = sum * s.reciprocal;
    return index;
}
