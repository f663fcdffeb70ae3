// SPDX-License-Identifier: Apache-2.0
// Flipping, and finding what must be evaluated again. Who includes it says where that goes:
// add_dirty(m, where). After lists.glsl.
#include "flip.glsl"

// Stamps say in which iteration an edge is to be looked at again: 4 i and up. It shares a word with
// a part of the record, which is therefore written by atomicMax: what wins brings its own part
// along. Others read and write the words meanwhile as usual, which relies on 32-bit accesses that
// do not tear: a word is what it was or what it becomes.
//
// An edge's record is changed by one flip of a dispatch at most. That flip knows what becomes of
// the edge and says so with a higher stamp, which wins whoever comes first; others that touch the
// edge may still see what it was. 4 i + 1: who came first could flip it and has put it among the
// dirty.
uint stamp(int m, Edge e, uint value) {
    return atomicMax(site[m].y, value << 16 | (pack(e).y & 0xffffu)) >> 16;
}

// Look at the edge m again in this iteration.
void touch(int m, int iteration, int where) {
    Edge e = edge_at(m);
    bool can = flippable(e);
    uint value = uint(4 * iteration) + (can ? 1u : 0u);
    if (stamp(m, e, value) < value && can)
        add_dirty(m, where);
}

// Make e the record of the edge m, and look at it again.
void change(int m, Edge e, int iteration, int where) {
    site[m].x = pack(e).x;
    uint before = stamp(m, e, uint(4 * iteration + 2));
    // What can no longer be flipped gains nothing; it will not be evaluated.
    if (!flippable(e))
        gain[m] = no_gain;
    else if (before != uint(4 * iteration + 1))
        add_dirty(m, where);
}

// Flip the edge e at m and touch its 2-region for the next iteration.
void flip_and_touch(int m, Edge e, int next_iteration, int where) {
    Side s = first_side(e);
    tell_ends(m, e);
    change(m, turned(e), next_iteration, where);
    int k = 0;
    do {
        int middle = m + offset(middle_of(s));
        Edge side = edge_at(middle);
        ivec2 beyond = edges_beyond(middle, side, s);
        change(middle, with_apex(side, s, k < 2 ? e.right : e.left), next_iteration, where);
        for (int i = 0; i < 2; ++i) {
            if (beyond.x >= 0)
                touch(beyond.x, next_iteration, where);
            beyond = beyond.yx;
        }
        s = next_side(s);
        ++k;
    } while (!once_round(s, e));
}
