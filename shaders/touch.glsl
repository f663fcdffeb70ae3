// Flipping, and finding what must be evaluated again. Who includes it says where that goes:
// add_dirty(m, where). After waiting.glsl.
#include "flip.glsl"

// Stamps say in which iteration an edge is to be looked at again: 2 i, 2 i + 1 if it is among the
// dirty, so can be flipped. The first in a row to say so puts it there.
//
// An edge's record is written by one flip of a dispatch at most. That flip sees what becomes of the
// edge; others that touch it may still see what it was, but then the one that knows speaks up.
void touch(int m, Edge e, int iteration, int where) {
    bool can = flippable(e);
    uint mark = uint(can ? 2 * iteration + 1 : 2 * iteration);
    if (atomicMax(stamp[m], mark) < mark && can)
        add_dirty(m, where);
}

// Flip the edge at m and touch its 2-region for the next iteration. Sides that can no longer be
// flipped gain nothing; they will not be evaluated.
void flip_and_touch(int m, Edge e, int next_iteration, int where) {
    Side s = first_side(e);
    turn(m, e);
    touch(m, e, next_iteration, where); // can be flipped back
    int k = 0;
    do {
        int middle = m + offset(middle_of(s));
        Edge side = edge_at(middle);
        ivec2 beyond = edges_beyond(middle, side, s);
        side = with_apex(side, s, k < 2 ? e.right : e.left);
        site[middle] = pack(side);
        if (!flippable(side))
            gain[middle] = no_gain;
        touch(middle, side, next_iteration, where);
        for (int i = 0; i < 2; ++i) {
            if (beyond.x >= 0)
                touch(beyond.x, edge_at(beyond.x), next_iteration, where);
            beyond = beyond.yx;
        }
        s = next_side(s);
        ++k;
    } while (!once_round(s, e));
}
