// SPDX-License-Identifier: Apache-2.0
// The paper's schemes, one group a tile: rounds of accepting and rejecting wait for one another too
// often for dispatches. C++ twin: core/triangulate/accept_reject.h. The first iteration's gains are
// there already. A dispatch ends when all is done, or before its loops would turn most_turns times;
// then another goes on: llvmpipe leaves loops after 65535 turns of all of them together.
#define ACCESS coherent
#include "lists.glsl"
#include "waiting.glsl"
#include "evaluate.glsl"
#include "region.glsl"
#include "flip.glsl"
#include "reach.glsl"

layout(local_size_x = FINISH_GROUP) in; // x: a tile

layout(location = AT_BY_GAIN) uniform bool by_gain;
layout(location = AT_WIDE_ITERATIONS) uniform int wide_iterations;
// x: where in `mark` a tile's is kept; y: most_turns
layout(location = AT_PROGRESS) uniform ivec2 progress;

#include "comes_before.glsl"

// `from` is the list of dirty edges here, `to` that of selected ones.

// What the scheme knows of an edge. A dirty edge's iteration is of no interest.
layout(std430, binding = BIND_MARKS) ACCESS buffer Marks { uint mark[]; }; // a site
const uint idle = 0, dirty = MARK_DIRTY, untreated = 2, accepted = 3, rejected = 4;

shared uint evaluated, n_dirty, n_candidates, n_selected, n_waiting;

void synchronize() {
    memoryBarrierBuffer();
    memoryBarrierShared();
    barrier();
}

// The region of this iteration; those without end in -1.
void region_in(bool wide, int m, out int region[wide_region_size]) {
    Edge e = edge_at(m);
    if (wide) {
        wide_region_of(m, e, region);
        return;
    }
    int near[region_size];
    region_of(m, e, near);
    for (int k = 0; k < wide_region_size; ++k)
        region[k] = k < region_size ? near[k] : -1;
}

int find_untreated_blocker(bool wide, int m) {
    int region[wide_region_size];
    region_in(wide, m, region);
    for (int k = 0; k < wide_region_size; ++k) {
        int other = region[k];
        if (other >= 0 && mark[other] == untreated && comes_before(other, m))
            return other;
    }
    return -1;
}

void add_candidate(int iteration, int list, int m) {
    if (gain[m] > min_gain)
        put_blocked(iteration, list + int(atomicAdd(n_candidates, 1)), ivec2(m, -1));
}

// Candidates of the first iteration, from all edges.
void gather(int tile, int list) {
    int width = 2 * extent[tile].x - 1, height = 2 * extent[tile].y - 1;
    int size = int(gl_WorkGroupSize.x);
    for (int y = 0; y < height; ++y)
        for (int x = int(gl_LocalInvocationIndex); x < width; x += size)
            if (((x | y) & 1) != 0)
                add_candidate(first_iteration, list, tile * slot_sites + y * stride + x);
}

void touch(int list, int m) {
    if (m >= 0 && atomicExchange(mark[m], dirty) != dirty)
        from[list + int(atomicAdd(n_dirty, 1))] = m;
}

// Where the work on a tile is: the same in all invocations. Numbers of entries that are shared are
// kept with it between dispatches.
const uint begins = 0, in_rounds = 1, ended = PROGRESS_ENDED, stuck = PROGRESS_STUCK;
uint phase, rounds, first, waiting;
int iteration;

void load_progress(int at) {
    phase = mark[at];
    iteration = int(mark[at + 1]);
    rounds = mark[at + 2];
    first = mark[at + 3];
    waiting = mark[at + 4];
    if (gl_LocalInvocationIndex != 0)
        return;
    evaluated = mark[at + 5];
    n_dirty = mark[at + 6];
    n_candidates = mark[at + 7];
    n_selected = mark[at + 8];
}

void keep_progress(int at) {
    if (gl_LocalInvocationIndex != 0)
        return;
    mark[at] = phase;
    mark[at + 1] = uint(iteration);
    mark[at + 2] = rounds;
    mark[at + 3] = first;
    mark[at + 4] = waiting;
    mark[at + 5] = evaluated;
    mark[at + 6] = n_dirty;
    mark[at + 7] = n_candidates;
    mark[at + 8] = n_selected;
}

// Turns of loops that so many entries take at most, of which each takes 61 or fewer: its own, 4
// about the sides of a quad, and twice wide_region_size over a region.
uint turns_for(uint entries) {
    return (entries / gl_WorkGroupSize.x + 1) * 100;
}
uint turns_ahead(int tile) {
    if (phase == in_rounds)
        return turns_for(n_candidates) + 2 * turns_for(n_selected);
    uint edges = iteration == first_iteration
                     ? uint(2 * extent[tile].y * (2 * extent[tile].x / int(gl_WorkGroupSize.x) + 1))
                     : 0;
    return edges + 2 * turns_for(n_dirty) + 2 * turns_for(n_candidates + n_dirty);
}

// Evaluate the dirty edges; keep the candidates that are not, add those that become some, in the
// blocked lists, in turn. All are untreated then.
void evaluate(int tile, int list) {
    const uint size = gl_WorkGroupSize.x, own = gl_LocalInvocationIndex;
    uint before = n_candidates, touched = n_dirty;
    synchronize();
    if (own == 0) {
        evaluated = iteration == first_iteration
                        ? counts[counts_of(iteration, tile)].evaluated
                        : 0;
        n_candidates = 0;
        n_selected = 0;
    }
    synchronize();
    if (iteration == first_iteration)
        gather(tile, list);
    for (uint i = own; i < touched; i += size)
        if (evaluate(from[list + int(i)]))
            atomicAdd(evaluated, 1);
    for (uint i = own; i < before; i += size) {
        int m = blocked_at(iteration - 1, list + int(i)).x;
        if (mark[m] != dirty)
            put_blocked(iteration, list + int(atomicAdd(n_candidates, 1)), ivec2(m, -1));
    }
    synchronize();
    for (uint i = own; i < touched; i += size) {
        int m = from[list + int(i)];
        mark[m] = idle;
        add_candidate(iteration, list, m);
    }
    synchronize();
    for (uint i = own; i < n_candidates; i += size)
        mark[blocked_at(iteration, list + int(i)).x] = untreated;
    rounds = 0;
    first = 0;
    waiting = n_candidates;
}

// Add every candidate that nothing blocks to the selected, and count those that wait.
void accept(bool wide, int list) {
    for (uint i = gl_LocalInvocationIndex; i < n_candidates; i += gl_WorkGroupSize.x) {
        ivec2 c = blocked_at(iteration, list + int(i));
        if (mark[c.x] != untreated)
            continue;
        if (c.y < 0 || mark[c.y] != untreated) {
            c.y = find_untreated_blocker(wide, c.x);
            put_blocked(iteration, list + int(i), c);
        }
        if (c.y < 0)
            to[list + int(atomicAdd(n_selected, 1))] = c.x;
        else
            atomicAdd(n_waiting, 1);
    }
}

void reject_region(bool wide, int winner) {
    mark[winner] = accepted;
    int region[wide_region_size];
    region_in(wide, winner, region);
    for (int k = 0; k < wide_region_size; ++k)
        if (region[k] >= 0 && mark[region[k]] == untreated)
            mark[region[k]] = rejected;
}

// One round of AcceptReject::select().
void select(int list) {
    const uint size = gl_WorkGroupSize.x, own = gl_LocalInvocationIndex;
    bool wide = iteration <= wide_iterations;
    ++rounds;
    synchronize();
    if (own == 0)
        n_waiting = 0;
    synchronize();
    accept(wide, list);
    synchronize();
    for (uint i = first + own; i < n_selected; i += size)
        reject_region(wide, to[list + int(i)]);
    first = n_selected;
    // The first in order is accepted, if the device computes right.
    if (n_waiting >= waiting)
        phase = stuck;
    waiting = n_waiting;
}

// Flip the selected and collect what must be evaluated again: their 2-regions.
void flip(int tile, int list) {
    const uint size = gl_WorkGroupSize.x, own = gl_LocalInvocationIndex;
    synchronize();
    if (own == 0) {
        counts[counts_of(iteration, tile)] =
            Counts(evaluated, n_candidates, n_selected, 0, n_dirty, rounds);
        n_dirty = 0;
    }
    for (uint i = own; i < n_candidates; i += size)
        mark[blocked_at(iteration, list + int(i)).x] = idle;
    synchronize();
    for (uint i = own; i < n_selected; i += size) {
        int m = to[list + int(i)];
        add_reach(tile, m, edge_at(m));
        flip(m, edge_at(m));
        int region[region_size];
        region_of(m, edge_at(m), region);
        touch(list, m);
        for (int k = 0; k < region_size; ++k)
            touch(list, region[k]);
    }
    ++iteration;
}

void main() {
    int tile = int(gl_WorkGroupID.x), list = tile * list_size;
    int at = progress.x + tile * PROGRESS_SIZE;
    load_progress(at);
    if (iteration == 0)
        iteration = first_iteration;
    begin_reach();
    synchronize();
    uint turns = 0;
    while (phase != ended && phase != stuck) {
        uint ahead = turns_ahead(tile);
        if (turns > 0 && turns + ahead > uint(progress.y))
            break;
        turns += ahead;
        if (phase == begins) {
            if (iteration > last_iteration) {
                phase = ended;
            } else {
                evaluate(tile, list);
                phase = in_rounds;
            }
        } else if (waiting > 0) {
            select(list);
        } else {
            phase = n_candidates == 0 ? ended : begins;
            flip(tile, list);
        }
        synchronize();
    }
    keep_progress(at);
    keep_reach(tile);
}
