// SPDX-License-Identifier: Apache-2.0
// The control net over the meshes. Its edges are made where they are read, or STORED_EDGES: were
// made by net_edges.comp. C++ twin: core/surface/control_net.h. QUADRATIC, SOFT: edges bend, are
// soft. BOUNDS_VERTICES, BOUNDS_DARK: Bounds.
#include "lattice.glsl"
#include "surface.glsl"

layout(std430, binding = BIND_VALUES) readonly buffer Values { uvec4 value[]; }; // a pixel
#if defined(STORED_EDGES)
// edge_numbers a site
layout(std430, binding = BIND_GRADIENTS) readonly buffer Edges { vec4 stored_edge[]; };
#elif defined(STORED_BENDS)
// Fitted ones, a site.
layout(std430, binding = BIND_GRADIENTS) readonly buffer Bends { vec4 stored_bend[]; };
#else
// Two a pixel: x, y.
layout(std430, binding = BIND_GRADIENTS) readonly buffer Gradients { vec4 gradient[]; };
#endif
#ifndef STORED_EDGES
layout(std430, binding = BIND_GAINS) readonly buffer Gains { float gain[]; }; // a site
#endif

#if defined(QUADRATIC) && defined(SOFT)
const int edge_numbers = 2; // of an edge: its bend, its softness
#else
const int edge_numbers = 1;
#endif

layout(location = AT_RECIPROCAL_TAU) uniform float reciprocal_tau;

int first_site, first_pixel; // of the tile; to be set before anything below is called

int pixel_of(ivec2 p) {
    return first_pixel + p.y * slot_width + p.x;
}
vec4 value_at(ivec2 p) {
    return uintBitsToFloat(value[pixel_of(p)]);
}

// e of the edge between i and j; seen from either end the same, but for the sign of zero.
vec4 bend(ivec2 i, ivec2 j) {
#if defined(STORED_EDGES)
    return stored_edge[edge_numbers * (first_site + offset(i + j))];
#elif defined(STORED_BENDS)
    return stored_bend[first_site + offset(i + j)];
#else
    int at_i = 2 * pixel_of(i), at_j = 2 * pixel_of(j);
    return edge_bend(gradient[at_i], gradient[at_i + 1], gradient[at_j], gradient[at_j + 1],
                     value_at(i), value_at(j), j - i);
#endif
}

// q of the edge between i and j.
vec4 softness(ivec2 i, ivec2 j) {
    ivec2 m = i + j;
    int s = first_site + offset(m);
#ifdef STORED_EDGES
    return stored_edge[edge_numbers * s + edge_numbers - 1];
#else
    Edge e = edge_at(s);
    float w = flippable(e) ? soft_weight(gain[s], reciprocal_tau) : 0.0;
    // Of a weight of 0 edge_softness() makes a zero, of either sign, which no result shows: where
    // values are not finite, too. So they need not be read.
    if (w == 0.0)
        return vec4(0.0);
#ifdef QUADRATIC
    vec4 bent = bend(i, j);
#else
    const vec4 bent = vec4(0.0);
#endif
    return edge_softness(w, value_at(i), value_at(j), value_at((m + e.left) / 2),
                         value_at((m - e.left) / 2), bent);
#endif
}

Patch patch_of(ivec2 p0, ivec2 p1, ivec2 p2) {
    Patch p;
    p.z0 = value_at(p0);
    p.z1 = value_at(p1);
    p.z2 = value_at(p2);
#ifdef QUADRATIC
    p.e01 = bend(p0, p1);
    p.e12 = bend(p1, p2);
    p.e20 = bend(p2, p0);
#endif
#ifdef SOFT
    p.q01 = softness(p0, p1);
    p.q12 = softness(p1, p2);
    p.q20 = softness(p2, p0);
#endif
    find_range(p);
    return p;
}
