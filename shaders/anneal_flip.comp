// SPDX-License-Identifier: Apache-2.0
// Flips the edges that anneal_select.comp decided to. They are outside each other's 2-regions, so
// none writes what another reads.
#include "lists.glsl"
#include "flip.glsl"
#include "reach.glsl"

layout(local_size_x = GAINS_GROUP_X, local_size_y = GAINS_GROUP_Y) in; // a site; z: a tile

layout(std430, binding = BIND_DECIDED) readonly buffer Decided { uint decided[]; };

shared uint flips;

void main() {
    if (gl_LocalInvocationIndex == 0)
        flips = 0;
    begin_reach();
    barrier();
    int m = edge_of_invocation(), tile = int(gl_WorkGroupID.z);
    if (m >= 0 && decided[m] == 1) {
        Edge e = edge_at(m);
        atomicAdd(flips, 1);
        add_reach(tile, m, e);
        flip(m, e);
    }
    barrier();
    if (gl_LocalInvocationIndex == 0 && flips > 0)
        atomicAdd(counts[counts_of(0, tile)].selected, flips);
    keep_reach(tile);
}
