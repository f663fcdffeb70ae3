// SPDX-License-Identifier: Apache-2.0
// Flip the selected edges and collect what must be evaluated again. The 2-regions of two selected
// edges share no record that either flip writes or this kernel reads, so one dispatch does both.
#include "lists.glsl"

layout(local_size_x = LIST_GROUP) in; // an entry of the list; y: a tile

const int own_most = LIST_GROUP * most_in_region;
#include "append.glsl"

void add_dirty(int m, int where) {
    collect(m);
}
#include "touch.glsl"
#include "reach.glsl"

void main() {
    begin_reach();
    begin_list();
    int tile = int(gl_GlobalInvocationID.y);
    uint i = gl_GlobalInvocationID.x;
    if (i < counts[counts_of(first_iteration, tile)].selected) {
        int m = from[tile * list_size + int(i)];
        Edge e = edge_at(m);
        add_reach(tile, m, e);
        flip_and_touch(m, e, first_iteration + 1, 0);
    }
    barrier();
    if (gl_LocalInvocationIndex == 0 && own_count > 0) {
        own_base = atomicAdd(counts[counts_of(first_iteration + 1, tile)].dirty, own_count);
        atomicMax(arguments[arguments_of(first_iteration + 1, STEP_EVALUATE)],
                  groups_for(own_base + own_count));
    }
    keep_reach(tile);
    barrier();
    append_list(tile);
}
