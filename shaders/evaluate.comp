// SPDX-License-Identifier: Apache-2.0
// Gains of the edges a flip touched; those that gain enough are candidates. DENSE: gains of all
// edges, and no candidates.
#include "lists.glsl"
#include "evaluate.glsl"

#ifdef DENSE
layout(local_size_x = GAINS_GROUP_X, local_size_y = GAINS_GROUP_Y) in; // a site; z: a tile
#else
layout(local_size_x = LIST_GROUP) in; // an entry of the list; y: a tile
#endif

#ifdef DENSE

void main() {
    int tile = int(gl_GlobalInvocationID.z);
    int x = int(gl_GlobalInvocationID.x), y = int(gl_GlobalInvocationID.y);
    if (x < 2 * extent[tile].x - 1 && y < 2 * extent[tile].y - 1 && ((x | y) & 1) != 0)
        evaluate(tile * slot_sites + y * stride + x);
}

#else

const int own_most = LIST_GROUP;
#include "append.glsl"

shared uint evaluated;

void main() {
    if (gl_LocalInvocationIndex == 0)
        evaluated = 0;
    begin_list();
    int tile = int(gl_GlobalInvocationID.y), c = counts_of(first_iteration, tile);
    uint i = gl_GlobalInvocationID.x;
    if (i < counts[c].dirty) {
        int m = from[tile * list_size + int(i)];
        if (evaluate(m)) {
            atomicAdd(evaluated, 1);
            if (gain[m] > min_gain)
                collect(m);
        }
    }
    barrier();
    if (gl_LocalInvocationIndex == 0 && i < counts[c].dirty) {
        atomicAdd(counts[c].evaluated, evaluated);
        own_base = atomicAdd(counts[c].candidates, own_count);
        // The next step also looks at those that wait.
        uint visits = own_base + own_count + counts[counts_of(first_iteration - 1, tile)].blocked;
        atomicMax(arguments[arguments_of(first_iteration, 1)], groups_for(visits));
    }
    barrier();
    append_list(tile);
}

#endif
