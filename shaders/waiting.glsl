// SPDX-License-Identifier: Apache-2.0
// Candidates that wait for a better one in their region, and what wakes them. After lists.glsl.
#include "goes_before.glsl"

// (site, blocker)
layout(std430, binding = BIND_BLOCKED_EVEN) ACCESS buffer BlockedEven { ivec2 blocked_even[]; };
layout(std430, binding = BIND_BLOCKED_ODD) ACCESS buffer BlockedOdd { ivec2 blocked_odd[]; };

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

// Whether a candidate that waited since an earlier iteration is to be looked at again (1), goes on
// waiting (0), or was touched itself, so is among the evaluated if it can still be flipped (-1).
int wake(ivec2 b, int iteration) {
    if (stamp_at(b.x) / 4 == uint(iteration))
        return -1;
    return stamp_at(b.y) / 4 == uint(iteration) ? 1 : 0;
}

// A better candidate in the 2-region of the candidate at m, or -1 if m is the best. C++ twin:
// find_blockers() of any mesh in core/triangulate/regions.h.
int find_blocker(int m) {
    float own = gain[m];
    Edge e = edge_at(m);
    Side s = first_side(e);
    int blocker = -1;
    do {
        int middle = m + offset(middle_of(s));
        ivec3 others = ivec3(middle, edges_beyond(middle, edge_at(middle), s));
        for (int i = 0; i < 3; ++i) {
            if (others.x >= 0 && goes_before(others.x, m, own))
                blocker = others.x;
            others = others.yzx;
        }
        s = next_side(s);
    } while (blocker < 0 && !once_round(s, e));
    return blocker;
}
