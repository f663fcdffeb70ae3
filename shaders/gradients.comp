// SPDX-License-Identifier: Apache-2.0
// Gradients at the vertices, one invocation a pixel. C++ twin: make_gradients in
// core/surface/gradients.cpp. FITTED: their indices too, which are wanted within an edge less.
#include "lattice.glsl"
#include "served.glsl"
#include "surface.glsl"

layout(local_size_x = SURFACE_GROUP_X, local_size_y = SURFACE_GROUP_Y) in; // z: a tile

layout(std430, binding = BIND_VALUES) readonly buffer Values { uvec4 value[]; }; // a pixel
// Two a pixel: x, y.
layout(std430, binding = BIND_GRADIENTS) writeonly buffer Gradients { vec4 gradient[]; };

vec4 value_at(int pixel) {
    return uintBitsToFloat(value[pixel]);
}

#ifdef FITTED
layout(std430, binding = BIND_BENDS) writeonly buffer Bends { vec4 index_at[]; }; // a site

int first_pixel;

vec4 value_at(ivec2 p) {
    return value_at(first_pixel + p.y * slot_width + p.x);
}
#include "fitted.glsl"
#include "fitted_index.glsl"
#endif

// The apex on one side of the edge with midpoint r relative to the vertex at s, seen from there.
ivec2 apex(int s, ivec2 r, bool left) {
    Edge e = edge_at(s + offset(r));
    return (e.v == r) == left ? e.left : e.right;
}

// The edge of the vertex at s with the smallest address, found from any of its edges: round to the
// left, at the rim then to the right.
ivec2 first_edge(int s, ivec2 any_edge) {
    ivec2 first = any_edge, r = any_edge;
    bool left = true;
    for (int steps = 0; steps < longest_walk; ++steps) {
        ivec2 a = apex(s, r, left);
        if (is_zero(a)) {
            if (!left)
                break;
            left = false;
            r = any_edge;
            continue;
        }
        r = (r + a) / 2;
        if (r == any_edge)
            break;
        if (edge_key(r) < edge_key(first))
            first = r;
    }
    return first;
}

void main() {
    int tile = int(gl_GlobalInvocationID.z);
    int x = int(gl_GlobalInvocationID.x), y = int(gl_GlobalInvocationID.y);
#ifdef FITTED
    first_pixel = tile * slot_pixels;
    read_near(extent[tile].xy);
    barrier();
#endif
    if (x >= extent[tile].x || y >= extent[tile].y || !is_needed(tile, ivec2(x, y)))
        return;
    int s = tile * slot_sites + 2 * y * stride + 2 * x;
    int pixel = tile * slot_pixels + y * slot_width + x;
    ivec2 first = first_edge(s, midpoint_of_key(site[s].y));
    vec4 z = value_at(pixel);
    precise vec4 dz_first = value_at(pixel + first.y * slot_width + first.x) - z;

    GradientMean mean = no_triangles;
    ivec2 r = first;
    vec4 dz = dz_first;
    bool left = true; // first round to the left, at the rim then from the first edge to the right
    for (int steps = 0; steps < longest_walk; ++steps) {
        ivec2 a = apex(s, r, left);
        if (is_zero(a)) {
            if (!left)
                break;
            left = false;
            r = first;
            dz = dz_first;
            continue;
        }
        ivec2 next = (r + a) / 2;
        precise vec4 dz_next = value_at(pixel + next.y * slot_width + next.x) - z;
        if (left)
            add(mean, r, next, dz, dz_next);
        else
            add(mean, next, r, dz_next, dz);
        if (next == first)
            break;
        r = next;
        dz = dz_next;
    }
    vec4 gx, gy;
    result(mean, gx, gy);
    gradient[2 * pixel] = gx;
    gradient[2 * pixel + 1] = gy;
#ifdef FITTED
    if (is_within(tile, ivec2(x, y), margin - 1))
        index_at[s] = index_of(surroundings());
#endif
}
