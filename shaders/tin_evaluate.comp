// SPDX-License-Identifier: Apache-2.0
// The gains of dirty edges; edges that gain enough are untreated candidates. C++ twin:
// AcceptReject::evaluate() in core/triangulate/accept_reject.h.
#include "tin.glsl"

void main() {
    int m = own_index();
    if (m >= count)
        return;
    if (mark[m] == dirty) {
        bool can = flippable(m);
        gain[m] = can ? flip_gain(m) : no_gain;
        if (can)
            atomicAdd(evaluated, 1u);
    }
    bool candidate = gain[m] > min_gain;
    mark[m] = candidate ? untreated : idle;
    if (candidate)
        atomicAdd(candidates, 1u);
}
