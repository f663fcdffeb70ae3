// Which candidates are the best of their 2-region, among the edges just evaluated and those that
// wait; DENSE: among all edges.
#include "work.glsl"

#ifdef DENSE
layout(local_size_x = 64, local_size_y = 2) in; // a site; z: a tile
const int group_size = 128;
#else
layout(local_size_x = 64) in; // an entry of the lists, dirty first; y: a tile
const int group_size = 64;
#endif

// What this group appends, so that the lists' counters are touched once a group.
shared uint own_selected, own_blocked, selected_base, blocked_base;
shared int own_selected_list[group_size];
shared ivec2 own_blocked_list[group_size];

// The edge this invocation looks at, -1 if none. A waiting edge that goes on waiting is passed on.
int pick(int tile, out ivec2 waiting) {
    waiting = ivec2(-1);
#ifdef DENSE
    return edge_of_invocation(tile);
#else
    int i = int(gl_GlobalInvocationID.x);
    int n = int(counts[counts_of(first_iteration, tile)].dirty);
    if (i < n)
        return dirty[tile * list_size + i];
    i -= n;
    if (i >= int(counts[counts_of(first_iteration - 1, tile)].blocked))
        return -1;
    ivec2 b = blocked_at(first_iteration - 1, tile * list_size + i);
    int state = wake(b, first_iteration);
    if (state == 0)
        waiting = b;
    return state == 1 ? b.x : -1;
#endif
}

void main() {
    if (gl_LocalInvocationIndex == 0) {
        own_selected = 0;
        own_blocked = 0;
    }
    barrier();
#ifdef DENSE
    int tile = int(gl_GlobalInvocationID.z);
#else
    int tile = int(gl_GlobalInvocationID.y);
#endif
    ivec2 waiting;
    int m = pick(tile, waiting);
    if (m >= 0 && gain[m] > min_gain) {
        int blocker = find_blocker(m);
        if (blocker < 0)
            own_selected_list[atomicAdd(own_selected, 1)] = m;
        else
            waiting = ivec2(m, blocker);
    }
    if (waiting.x >= 0)
        own_blocked_list[atomicAdd(own_blocked, 1)] = waiting;
    barrier();
    if (gl_LocalInvocationIndex == 0) {
        int c = counts_of(first_iteration, tile);
        if (own_selected > 0) {
            selected_base = atomicAdd(counts[c].selected, own_selected);
            atomicMax(arguments[6 * first_iteration + 3], (selected_base + own_selected + 63) / 64);
        }
        if (own_blocked > 0)
            blocked_base = atomicAdd(counts[c].blocked, own_blocked);
    }
    barrier();
    for (uint i = gl_LocalInvocationIndex; i < own_selected; i += group_size)
        selected[tile * list_size + int(selected_base + i)] = own_selected_list[i];
    for (uint i = gl_LocalInvocationIndex; i < own_blocked; i += group_size)
        put_blocked(first_iteration, tile * list_size + int(blocked_base + i), own_blocked_list[i]);
}
