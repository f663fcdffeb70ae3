// The lists of an iteration, and its three steps for one edge. C++ twin:
// core/triangulate/one_round.cpp.
//
// Lists are kept a tile: a tile's part of a list begins at tile * list_size. An iteration's counts
// have a place of their own, so nothing needs to be reset between iterations and one read at the
// end tells all.
#include "gain.glsl"

layout(std430, binding = 1) ACCESS buffer Gains { float gain[]; };        // a site
layout(std430, binding = 2) ACCESS buffer Stamps { uint stamp[]; };       // see first_touch()
layout(std430, binding = 3) ACCESS buffer Dirty { int dirty[]; };         // to evaluate
layout(std430, binding = 4) ACCESS buffer Selected { int selected[]; };   // to flip
layout(std430, binding = 5) ACCESS buffer BlockedEven { ivec2 blocked_even[]; };
layout(std430, binding = 6) ACCESS buffer BlockedOdd { ivec2 blocked_odd[]; }; // (site, blocker)

struct Counts {
    uint evaluated, selected, blocked, dirty, rounds;
};
layout(std430, binding = 7) ACCESS buffer Work {
    // Groups of indirect dispatches, (x, tiles, 1) each: of iteration i's evaluate and select at
    // [6 i], of its flip at [6 i + 3].
    uint arguments[6 * (MAX_ITERATIONS + 2)];
    Counts counts[]; // iteration * tiles + tile; `dirty` is what the iteration evaluates
};

layout(location = 0) uniform int tiles;
layout(location = 1) uniform int list_size;
layout(location = 2) uniform int first_iteration;
layout(location = 3) uniform int last_iteration;
layout(location = 4) uniform float min_gain;

int counts_of(int iteration, int tile) {
    return iteration * tiles + tile;
}

// The edge's site for the dense passes, whose invocations cover a tile's sites; -1 if none.
int edge_of_invocation(int tile) {
    int x = int(gl_GlobalInvocationID.x), y = int(gl_GlobalInvocationID.y);
    bool is_edge = x < 2 * extent[tile].x - 1 && y < 2 * extent[tile].y - 1 && ((x | y) & 1) != 0;
    return is_edge ? tile * slot_sites + y * stride + x : -1;
}

// What an iteration leaves waiting is read by the next: two lists in turn.
ivec2 blocked_at(int iteration, int i) {
    return (iteration & 1) == 0 ? blocked_even[i] : blocked_odd[i];
}
void put_blocked(int iteration, int i, ivec2 b) {
    if ((iteration & 1) == 0)
        blocked_even[i] = b;
    else
        blocked_odd[i] = b;
}

// Compute the gain of the edge at m. True if it can be flipped, that is, was evaluated.
bool evaluate(int m) {
    Edge e = edge_at(m);
    bool can = flippable(e);
    gain[m] = can ? flip_gain(neighbourhood(m, e)) : no_gain;
    return can;
}

// A better candidate in the 2-region of the candidate at m, or -1 if m is the best.
int find_blocker(int m) {
    float own = gain[m];
    int region[12];
    region_of(m, edge_at(m), region);
    int blocker = -1;
    for (int k = 0; k < 12; ++k) {
        int other = region[k];
        float g = other < 0 ? no_gain : gain[other];
        if (g > own || (g == own && other < m && other >= 0))
            blocker = other;
    }
    return blocker;
}

// Stamps say in which iteration an edge is to be looked at again: 2 i, 2 i + 1 if it is among the
// dirty, so can be flipped. The first in a row to say so puts it there.
//
// An edge's record is written by one flip of a dispatch at most. That flip sees what becomes of the
// edge; others that touch it may still see what it was, but then the one that knows speaks up.
bool first_touch(int m, int iteration) {
    if (m < 0)
        return false;
    if (flippable(edge_at(m)))
        return atomicMax(stamp[m], uint(2 * iteration + 1)) < uint(2 * iteration + 1);
    atomicMax(stamp[m], uint(2 * iteration));
    return false;
}

// Flip the edge at m. Sides that can no longer be flipped gain nothing; they will not be evaluated.
void flip_and_settle(int m) {
    Quad q = quad_of(edge_at(m));
    flip(m, edge_at(m));
    for (int k = 0; k < 4; ++k) {
        int side = m + offset(q.middle[k]);
        if (!flippable(edge_at(side)))
            gain[side] = no_gain;
    }
}

// Whether a candidate that waited since an earlier iteration is to be looked at again (1), goes on
// waiting (0), or was touched itself, so is among the dirty if it can still be flipped (-1).
int wake(ivec2 b, int iteration) {
    if (stamp[b.x] / 2 == uint(iteration))
        return -1;
    return stamp[b.y] / 2 == uint(iteration) ? 1 : 0;
}
