// SPDX-License-Identifier: Apache-2.0
// A round's winners: untreated edges before which none comes in their region. C++ twin:
// AcceptReject::accept() in core/triangulate/accept_reject.h.
#include "tin.glsl"
#include "comes_before.glsl"

void main() {
    int m = own_index();
    if (m >= count || mark[m] != untreated)
        return;
    int region[wide_region_size];
    region_of(m, wide, region);
    bool blocked = false;
    for (int k = 0; k < wide_region_size; ++k) {
        int other = region[k];
        if (other < 0 || other == m)
            continue;
        uint state = mark[other];
        blocked = blocked || ((state == untreated || state == winner) && comes_before(other, m));
    }
    if (blocked)
        atomicAdd(waiting, 1u);
    else
        mark[m] = winner;
}
