// SPDX-License-Identifier: Apache-2.0
// The net's edges, an invocation a site, for shaders that would make each of them a dozen times
// over. C++ twin: make_row() in core/surface/edges.cpp.
#include "net.glsl"
#include "served.glsl"

layout(local_size_x = GAINS_GROUP_X, local_size_y = GAINS_GROUP_Y) in; // z: a tile

layout(std430, binding = BIND_MADE_EDGES) writeonly buffer Edges { vec4 edges[]; };

void main() {
    int s = edge_of_invocation();
    if (s < 0)
        return;
    int tile = int(gl_GlobalInvocationID.z);
    ivec2 m = ivec2(gl_GlobalInvocationID.xy), v = edge_at(s).v, i = (m - v) / 2, j = (m + v) / 2;
    if (!is_needed(tile, i) || !is_needed(tile, j))
        return;
    first_site = tile * slot_sites;
    first_pixel = tile * slot_pixels;
#ifdef QUADRATIC
    edges[edge_numbers * s] = bend(i, j);
#endif
#ifdef SOFT
    edges[edge_numbers * s + edge_numbers - 1] = softness(i, j);
#endif
}
