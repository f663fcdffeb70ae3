// SPDX-License-Identifier: Apache-2.0
// The cells' contour words, and what they gain by a flip. C++ twin: core/triangulate/gain-inl.h. A
// cell's word has half the number of the site of its upper left pixel: a tile's part is half of
// slot_sites words long, in rows of `stride` of which one half is used. After lattice.glsl.

#ifndef CONTOUR_ACCESS
#define CONTOUR_ACCESS readonly
#endif
layout(std430, binding = BIND_CONTOURS) CONTOUR_ACCESS buffer ContourWords {
    uint contour_words[];
};

#ifdef CONTOURS
layout(location = AT_CONTOUR_WEIGHT) uniform float contour_weight; // times contour_unit

// xx, yy, xy of the cells that meet at the midpoint m of a flippable edge along v.
ivec3 contours_at(int m, ivec2 v) {
    ivec2 odd = v & 1, even = 1 - odd;
    int cell = m - (odd.y * stride + odd.x), other = cell - 2 * (even.y * stride + even.x);
    uint words = contour_words[cell / 2] + contour_words[other / 2];
    const uint mask = (1u << contour_bits) - 1u;
    return ivec3(words & mask, words >> contour_bits & mask,
                 int(words >> (2 * contour_bits)) - contour_steps);
}

// In units of contour_unit.
float contour_gain(ivec3 n_, ivec2 w_, ivec2 u_) {
    vec3 n = vec3(n_);
    vec2 w = vec2(w_), u = vec2(u_);
    precise float along =
        ((n.x * (w.x * u.x)) + (n.y * (w.y * u.y))) + (n.z * ((w.x * u.y) + (w.y * u.x)));
    return along;
}
#endif
