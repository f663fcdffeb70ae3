// SPDX-License-Identifier: Apache-2.0
// Which candidates are the best of their 2-region, among those just evaluated and those that wait.
#include "lists.glsl"
#include "waiting.glsl"

layout(local_size_x = LIST_GROUP) in; // an entry of the lists, candidates first; y: a tile

const int own_most = LIST_GROUP;
#include "append.glsl"

shared uint own_blocked, blocked_base;
shared ivec2 own_blocked_list[own_most];

// The candidate this invocation looks at, -1 if none. A waiting one that goes on waiting is passed
// on.
int pick(int tile, out ivec2 waiting) {
    waiting = ivec2(-1);
    int i = int(gl_GlobalInvocationID.x);
    int n = int(counts[counts_of(first_iteration, tile)].candidates);
    if (i < n)
        return from[tile * list_size + i];
    i -= n;
    if (i >= int(counts[counts_of(first_iteration - 1, tile)].blocked))
        return -1;
    ivec2 b = blocked_at(first_iteration - 1, tile * list_size + i);
    int state = wake(b, first_iteration);
    if (state == 0)
        waiting = b;
    return state == 1 ? b.x : -1;
}

void main() {
    if (gl_LocalInvocationIndex == 0)
        own_blocked = 0;
    begin_list();
    int tile = int(gl_GlobalInvocationID.y);
    ivec2 waiting;
    int m = pick(tile, waiting);
    if (m >= 0) {
        int blocker = find_blocker(m);
        if (blocker < 0)
            collect(m);
        else
            waiting = ivec2(m, blocker);
    }
    if (waiting.x >= 0)
        own_blocked_list[atomicAdd(own_blocked, 1)] = waiting;
    barrier();
    if (gl_LocalInvocationIndex == 0) {
        int c = counts_of(first_iteration, tile);
        if (own_count > 0) {
            own_base = atomicAdd(counts[c].selected, own_count);
            atomicMax(arguments[arguments_of(first_iteration, STEP_FLIP)],
                      groups_for(own_base + own_count));
        }
        if (own_blocked > 0)
            blocked_base = atomicAdd(counts[c].blocked, own_blocked);
    }
    barrier();
    append_list(tile);
    for (uint i = gl_LocalInvocationIndex; i < own_blocked; i += own_most)
        put_blocked(first_iteration, tile * list_size + int(blocked_base + i), own_blocked_list[i]);
}
