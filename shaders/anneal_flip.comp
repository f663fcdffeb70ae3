// SPDX-License-Identifier: Apache-2.0
// Flips the edges that anneal_select.comp decided to. They are outside each other's 2-regions, so
// none writes what another reads.
#include "lists.glsl"
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
    int m = edge_of_invocation();
    if (m >= 0 && decided[m] == 1) {
        Edge e = edge_at(m);
        atomicAdd(flips, 1);
        atomicMax(own_reach, reach_of(e));
        flip(m, e);
    }
    barrier();
    if (gl_LocalInvocationIndex == 0 && flips > 0) {
        int tile = int(gl_WorkGroupID.z);
        atomicAdd(counts[counts_of(0, tile)].selected, flips);
        atomicMax(reach[tile], own_reach);
    }
}
