// SPDX-License-Identifier: Apache-2.0
// Draws a number for every edge. C++ twin: Annealing::shuffle() in core/triangulate/annealing.h.
#include "lattice.glsl"
#include "annealing.glsl"

layout(local_size_x = GAINS_GROUP_X, local_size_y = GAINS_GROUP_Y) in; // a site; z: a tile

layout(std430, binding = 5) writeonly buffer Drawn { uint drawn[]; }; // a site

void main() {
    int tile = int(gl_GlobalInvocationID.z);
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    // Twice the tile's first pixel in the image and the way from there.
    ivec2 place = 2 * extent[tile].zw + at;
    if (at.x < 2 * extent[tile].x - 1 && at.y < 2 * extent[tile].y - 1)
        drawn[tile * slot_sites + at.y * stride + at.x] = draw(uvec2(place));
}
