// SPDX-License-Identifier: Apache-2.0
// The cells' contour words, and what they gain by a flip (C++ twin: core/triangulate/gain-inl.h). A cell's has half the number of the site of its upper left pixel: a tile's
// part is slot_sites / 2 words long, in rows of `stride` of which one half is used. After
// lattice.glsl.

#ifndef CONTOUR_ACCESS
#define CONTOUR_ACCESS readonly
#endif
layout(std430, binding = 2) CONTOUR_ACCESS buffer ContourWords { uint contour_words[]; };

#ifdef CONTOURS
layout(location = 8) uniform float contour_weight; // times contour_unit

// The words, together, of the cells that meet at the midpoint m of a flippable edge along v.
uint contours_at(int m, ivec2 v) {
    ivec2 odd = v & 1, even = 1 - odd;
    int cell = m - (odd.y * stride + odd.x), other = cell - 2 * (even.y * stride + even.x);
    return contour_words[cell / 2] + contour_words[other / 2];
}

// In units of contour_unit, of the edge e.
float contour_gain(uint words, Edge e) {
    const uint mask = (1u << contour_bits) - 1u;
    float xx = float(words & mask), yy = float(words >> contour_bits & mask),
          xy = float(int(words >> (2 * contour_bits)) - contour_steps);
    ivec2 w = (e.v + e.left) / 2, u = e.v - w;
    precise float along = ((xx * float(w.x * u.x)) + (yy * float(w.y * u.y))) +
                          (xy * float(w.x * u.y + w.y * u.x));
    return along;
}
#endif
