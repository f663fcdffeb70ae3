// SPDX-License-Identifier: Apache-2.0
// Gains of the edges a flip touched; those that gain enough are candidates. DENSE: gains of all
// edges, and no candidates. DENSE CANDIDATES: with them, as the first iteration of a mesh that
// others have flipped.
#include "lists.glsl"
#include "evaluate.glsl"

#ifdef DENSE
layout(local_size_x = GAINS_GROUP_X, local_size_y = GAINS_GROUP_Y) in; // a site; z: a tile
const int own_most = GAINS_GROUP_X * GAINS_GROUP_Y;

int own_tile() {
    return int(gl_GlobalInvocationID.z);
}
int own_edge(int tile) {
    return edge_of_invocation();
}
#else
layout(local_size_x = LIST_GROUP) in; // an entry of the list; y: a tile
const int own_most = LIST_GROUP;

int own_tile() {
    return int(gl_GlobalInvocationID.y);
}
int own_edge(int tile) {
    int i = int(gl_GlobalInvocationID.x);
    int n = int(counts[counts_of(first_iteration, tile)].dirty);
    return i < n ? from[tile * list_size + i] : -1;
}
#endif

#if defined(DENSE) && !defined(CANDIDATES)

void main() {
    int m = edge_of_invocation();
    if (m >= 0)
        evaluate(m);
}

#else

#include "append.glsl"

shared uint evaluated;

void main() {
    if (gl_LocalInvocationIndex == 0)
        evaluated = 0;
    begin_list();
    int tile = own_tile(), c = counts_of(first_iteration, tile), m = own_edge(tile);
    if (m >= 0) {
#ifdef DENSE
        site[m].y &= 0xffffu; // stamps of earlier iterations are none of these
#endif
        if (evaluate(m)) {
            atomicAdd(evaluated, 1);
            if (gain[m] > min_gain)
                collect(m);
        }
    }
    barrier();
    if (gl_LocalInvocationIndex == 0 && (m >= 0 || evaluated > 0)) {
        atomicAdd(counts[c].evaluated, evaluated);
        own_base = atomicAdd(counts[c].candidates, own_count);
        // The next step also looks at those that wait.
        uint visits = own_base + own_count + counts[counts_of(first_iteration - 1, tile)].blocked;
        atomicMax(arguments[arguments_of(first_iteration, STEP_SELECT)], groups_for(visits));
    }
    barrier();
    append_list(tile);
}

#endif
