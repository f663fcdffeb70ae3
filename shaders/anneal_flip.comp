// SPDX-License-Identifier: Apache-2.0
// Flips the edges that anneal_select.comp decided to. They are outside each other's 2-regions, so
// none writes what another reads.
#include "lattice.glsl"
#include "counts.glsl"
#include "flip.glsl"

layout(local_size_x = GAINS_GROUP_X, local_size_y = GAINS_GROUP_Y) in; // a site; z: a tile

layout(std430, binding = 6) readonly buffer Decided { uint decided[]; };

shared uint flips, own_reach;

void main() {
    if (gl_LocalInvocationIndex == 0) {
        flips = 0;
        own_reach = 0;
    }
    barrier();
    int tile = int(gl_GlobalInvocationID.z);
    int x = int(gl_GlobalInvocationID.x), y = int(gl_GlobalInvocationID.y);
    int m = tile * slot_sites + y * stride + x;
    bool is_edge = x < 2 * extent[tile].x - 1 && y < 2 * extent[tile].y - 1 && ((x | y) & 1) != 0;
    if (is_edge && decided[m] == 1) {
        Edge e = edge_at(m);
        atomicAdd(flips, 1);
        atomicMax(own_reach, reach_of(e));
        flip(m, e);
    }
    barrier();
    if (gl_LocalInvocationIndex == 0 && flips > 0) {
        atomicAdd(counts[tile].selected, flips);
        atomicMax(reach[tile], own_reach);
    }
}
