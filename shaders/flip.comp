// Flip the selected edges and collect what must be evaluated again. The 2-regions of two selected
// edges share no record that either flip writes or this kernel reads, so one dispatch does both.
#include "work.glsl"

layout(local_size_x = 64) in; // an entry of the list; y: a tile

shared uint own_dirty, dirty_base;
shared int own_dirty_list[64 * 13];

void touch(int m) {
    if (first_touch(m, first_iteration + 1))
        own_dirty_list[atomicAdd(own_dirty, 1)] = m;
}

void main() {
    if (gl_LocalInvocationIndex == 0)
        own_dirty = 0;
    barrier();
    int tile = int(gl_GlobalInvocationID.y);
    uint i = gl_GlobalInvocationID.x;
    if (i < counts[counts_of(first_iteration, tile)].selected) {
        int m = selected[tile * list_size + int(i)];
        flip_and_settle(m);
        int region[12];
        region_of(m, edge_at(m), region);
        touch(m);
        for (int k = 0; k < 12; ++k)
            touch(region[k]);
    }
    barrier();
    if (gl_LocalInvocationIndex == 0 && own_dirty > 0) {
        dirty_base = atomicAdd(counts[counts_of(first_iteration + 1, tile)].dirty, own_dirty);
        uint visits = dirty_base + own_dirty + counts[counts_of(first_iteration, tile)].blocked;
        atomicMax(arguments[6 * (first_iteration + 1)], (visits + 63) / 64);
    }
    barrier();
    for (uint k = gl_LocalInvocationIndex; k < own_dirty; k += 64)
        dirty[tile * list_size + int(dirty_base + k)] = own_dirty_list[k];
}
