// SPDX-License-Identifier: Apache-2.0
// Draws a number for every edge. C++ twin: Annealing::shuffle() in core/triangulate/annealing.h.
#include "lists.glsl"
#include "annealing.glsl"

layout(local_size_x = GAINS_GROUP_X, local_size_y = GAINS_GROUP_Y) in; // a site; z: a tile

layout(std430, binding = BIND_DRAWN) writeonly buffer Drawn { uint drawn[]; }; // a site

void main() {
    int m = edge_of_invocation();
    // Twice the tile's first pixel in the image and the way from there.
    ivec2 place = 2 * extent[gl_WorkGroupID.z].zw + ivec2(gl_GlobalInvocationID.xy);
    if (m >= 0)
        drawn[m] = draw(uvec2(place));
}
