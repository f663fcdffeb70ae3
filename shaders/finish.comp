// SPDX-License-Identifier: Apache-2.0
// Iterations that remain, one group a tile. Late iterations treat a few edges each: here they
// cost a barrier of one group where dispatches would each wait for the whole device. Some of them,
// or all: llvmpipe leaves loops after 65535 turns of all of them together, and drivers of hardware
// take a dispatch of seconds for one that hangs. The next dispatch goes on.
#define ACCESS coherent
#include "lists.glsl"
#include "waiting.glsl"
#include "evaluate.glsl"

layout(local_size_x = FINISH_GROUP) in; // x: a tile

shared uint evaluated, n_dirty, n_candidates, n_selected, n_blocked;

layout(location = AT_ITERATIONS_A_DISPATCH) uniform int iterations_a_dispatch; // even

// Which of the two lists the iteration's dirty edges are in; its candidates are in the other one,
// the selected in this one again, then what is dirty next in the other.
bool second = false;

int listed(bool in_second, int i) {
    return in_second ? to[i] : from[i];
}
void put_listed(bool in_second, int i, int m) {
    if (in_second)
        to[i] = m;
    else
        from[i] = m;
}

void add_dirty(int m, int list) {
    put_listed(!second, list + int(atomicAdd(n_dirty, 1)), m);
}
#include "touch.glsl"
#include "reach.glsl"

void synchronize() {
    memoryBarrierBuffer();
    memoryBarrierShared();
    barrier();
}

void main() {
    const uint size = gl_WorkGroupSize.x, own = gl_LocalInvocationIndex;
    int tile = int(gl_WorkGroupID.x), list = tile * list_size;
    uint waiting = counts[counts_of(first_iteration - 1, tile)].blocked;
    uint dirty = counts[counts_of(first_iteration, tile)].dirty;
    begin_reach();
    for (int iteration = first_iteration; dirty > 0; ++iteration) {
        synchronize();
        if (own == 0) {
            evaluated = 0;
            n_dirty = 0;
            n_candidates = 0;
            n_selected = 0;
            n_blocked = 0;
        }
        synchronize();
        for (uint i = own; i < dirty; i += size) {
            int m = listed(second, list + int(i));
            if (!evaluate(m))
                continue;
            atomicAdd(evaluated, 1);
            if (gain[m] > min_gain)
                put_listed(!second, list + int(atomicAdd(n_candidates, 1)), m);
        }
        if (iteration > last_iteration)
            break; // gains are wanted of all edges
        synchronize();
        uint candidates = n_candidates, visits = candidates + waiting;
        for (uint i = own; i < visits; i += size) {
            ivec2 b; // a candidate and what it waits for
            int state = 1;
            if (i < candidates) {
                b.x = listed(!second, list + int(i));
            } else {
                b = blocked_at(iteration - 1, list + int(i - candidates));
                state = wake(b, iteration);
            }
            if (state == 1)
                b.y = find_blocker(b.x);
            if (state == 1 && b.y < 0)
                put_listed(second, list + int(atomicAdd(n_selected, 1)), b.x);
            else if (state >= 0)
                put_blocked(iteration, list + int(atomicAdd(n_blocked, 1)), b);
        }
        synchronize();
        for (uint i = own; i < n_selected; i += size) {
            int m = listed(second, list + int(i));
            Edge e = edge_at(m);
            add_reach(tile, m, e);
            flip_and_touch(m, e, iteration + 1, list);
        }
        synchronize();
        if (own == 0)
            counts[counts_of(iteration, tile)] =
                Counts(evaluated, candidates, n_selected, n_blocked, dirty, 0);
        waiting = n_blocked;
        dirty = n_dirty;
        second = !second;
        if (iteration + 1 == first_iteration + iterations_a_dispatch) {
            // In the list where they are looked for first: `second` is false again.
            if (own == 0)
                counts[counts_of(iteration + 1, tile)].dirty = dirty;
            break;
        }
    }
    keep_reach(tile);
}
