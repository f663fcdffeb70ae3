// All iterations that remain, one group a tile. Late iterations treat a few edges each: here they
// cost a barrier of one group where dispatches would each wait for the whole device.
#define ACCESS coherent
#include "work.glsl"

layout(local_size_x = FINISH_GROUP) in; // x: a tile

shared uint evaluated, n_dirty, n_selected, n_blocked, next_dirty;

void synchronize() {
    memoryBarrierBuffer();
    memoryBarrierShared();
    barrier();
}

void touch(int list, int m, int iteration) {
    if (first_touch(m, iteration))
        dirty[list + int(atomicAdd(next_dirty, 1))] = m;
}

void consider(int list, int m, int iteration) {
    if (!(gain[m] > min_gain))
        return;
    int blocker = find_blocker(m);
    if (blocker < 0)
        selected[list + int(atomicAdd(n_selected, 1))] = m;
    else
        put_blocked(iteration, list + int(atomicAdd(n_blocked, 1)), ivec2(m, blocker));
}

void main() {
    const uint size = gl_WorkGroupSize.x, own = gl_LocalInvocationIndex;
    int tile = int(gl_WorkGroupID.x), list = tile * list_size;
    uint waiting = counts[counts_of(first_iteration - 1, tile)].blocked;
    if (own == 0)
        n_dirty = counts[counts_of(first_iteration, tile)].dirty;
    synchronize();
    for (int iteration = first_iteration; iteration <= last_iteration; ++iteration) {
        uint dirty_now = n_dirty;
        if (dirty_now == 0)
            break;
        synchronize();
        if (own == 0) {
            evaluated = 0;
            n_selected = 0;
            n_blocked = 0;
            next_dirty = 0;
        }
        synchronize();
        for (uint i = own; i < dirty_now; i += size)
            if (evaluate(dirty[list + int(i)]))
                atomicAdd(evaluated, 1);
        synchronize();
        for (uint i = own; i < dirty_now; i += size)
            consider(list, dirty[list + int(i)], iteration);
        for (uint i = own; i < waiting; i += size) {
            ivec2 b = blocked_at(iteration - 1, list + int(i));
            int state = wake(b, iteration);
            if (state == 1)
                consider(list, b.x, iteration);
            else if (state == 0)
                put_blocked(iteration, list + int(atomicAdd(n_blocked, 1)), b);
        }
        synchronize();
        for (uint i = own; i < n_selected; i += size) {
            int m = selected[list + int(i)];
            flip_and_settle(m);
            int region[12];
            region_of(m, edge_at(m), region);
            touch(list, m, iteration + 1);
            for (int k = 0; k < 12; ++k)
                touch(list, region[k], iteration + 1);
        }
        synchronize();
        waiting = n_blocked;
        if (own == 0) {
            n_dirty = next_dirty;
            counts[counts_of(iteration, tile)] =
                Counts(evaluated, n_selected, n_blocked, dirty_now, 0);
        }
        synchronize();
    }
}
