// SPDX-License-Identifier: Apache-2.0
// The paper's schemes, whole, one group a tile: rounds of accepting and rejecting wait for one
// another too often for dispatches. C++ twin: core/triangulate/accept_reject.h. The first
// iteration's gains are there already.
#define ACCESS coherent
#include "lists.glsl"
#include "waiting.glsl"
#include "evaluate.glsl"
#include "region.glsl"
#include "flip.glsl"
#include "reach.glsl"

layout(local_size_x = FINISH_GROUP) in; // x: a tile

layout(location = 5) uniform bool by_gain;
layout(location = 6) uniform int wide_iterations;
layout(location = 7) uniform bool all_rounds;

// `from` is the list of dirty edges here, `to` that of selected ones.

// What the scheme knows of an edge. A dirty edge's iteration is of no interest.
layout(std430, binding = 2) ACCESS buffer Stamps { uint stamp[]; }; // a site
const uint idle = 0, is_dirty = 1, untreated = 2, accepted = 3, rejected = 4;

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
    int near[12];
    region_of(m, e, near);
    for (int k = 0; k < wide_region_size; ++k)
        region[k] = k < 12 ? near[k] : -1;
}

bool comes_before(int m, int n) {
    if (by_gain) {
        float a = gain[m], b = gain[n];
        if (a != b)
            return a > b;
    }
    return m < n;
}

int find_untreated_blocker(bool wide, int m) {
    int region[wide_region_size];
    region_in(wide, m, region);
    for (int k = 0; k < wide_region_size; ++k) {
        int other = region[k];
        if (other >= 0 && stamp[other] == untreated && comes_before(other, m))
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
    if (m >= 0 && atomicExchange(stamp[m], is_dirty) != is_dirty)
        from[list + int(atomicAdd(n_dirty, 1))] = m;
}

void main() {
    const uint size = gl_WorkGroupSize.x, own = gl_LocalInvocationIndex;
    int tile = int(gl_WorkGroupID.x), list = tile * list_size;
    if (own == 0) {
        n_dirty = 0;
        n_candidates = 0;
    }
    begin_reach();
    synchronize();
    for (int iteration = first_iteration; iteration <= last_iteration; ++iteration) {
        // Candidates: those that stay, and the dirty that gain. Kept in the blocked lists, in turn.
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
            if (stamp[m] != is_dirty)
                put_blocked(iteration, list + int(atomicAdd(n_candidates, 1)), ivec2(m, -1));
        }
        synchronize();
        for (uint i = own; i < touched; i += size) {
            int m = from[list + int(i)];
            stamp[m] = idle;
            add_candidate(iteration, list, m);
        }
        synchronize();
        uint candidates = n_candidates;
        for (uint i = own; i < candidates; i += size)
            stamp[blocked_at(iteration, list + int(i)).x] = untreated;
        bool wide = iteration <= wide_iterations;
        uint rounds = 0, first = 0, waiting = candidates;
        while (waiting > 0 && (all_rounds || rounds == 0)) {
            ++rounds;
            synchronize();
            if (own == 0)
                n_waiting = 0;
            synchronize();
            for (uint i = own; i < candidates; i += size) {
                ivec2 c = blocked_at(iteration, list + int(i));
                if (stamp[c.x] != untreated)
                    continue;
                if (c.y < 0 || stamp[c.y] != untreated) {
                    c.y = find_untreated_blocker(wide, c.x);
                    put_blocked(iteration, list + int(i), c);
                }
                if (c.y < 0)
                    to[list + int(atomicAdd(n_selected, 1))] = c.x;
                else
                    atomicAdd(n_waiting, 1);
            }
            synchronize();
            for (uint i = first + own; i < n_selected; i += size) {
                int winner = to[list + int(i)];
                stamp[winner] = accepted;
                int region[wide_region_size];
                region_in(wide, winner, region);
                for (int k = 0; k < wide_region_size; ++k)
                    if (region[k] >= 0 && stamp[region[k]] == untreated)
                        stamp[region[k]] = rejected;
            }
            first = n_selected;
            waiting = n_waiting;
        }
        synchronize();
        if (own == 0) {
            counts[counts_of(iteration, tile)] =
                Counts(evaluated, candidates, n_selected, 0, touched, rounds);
            n_dirty = 0;
        }
        if (candidates == 0)
            break;
        for (uint i = own; i < candidates; i += size)
            stamp[blocked_at(iteration, list + int(i)).x] = idle;
        synchronize();
        for (uint i = own; i < n_selected; i += size) {
            int m = to[list + int(i)];
            add_reach(tile, m, edge_at(m));
            flip(m, edge_at(m));
            int region[12];
            region_of(m, edge_at(m), region);
            touch(list, m);
            for (int k = 0; k < 12; ++k)
                touch(list, region[k]);
        }
        synchronize();
    }
    keep_reach(tile);
}
