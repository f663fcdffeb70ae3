// SPDX-License-Identifier: Apache-2.0
// What a round's winners leave no room for. C++ twin: AcceptReject::reject_region() in
// core/triangulate/accept_reject.h.
#include "tin.glsl"

void main() {
    int m = own_index();
    if (m >= count || mark[m] != winner)
        return;
    int region[wide_region_size];
    region_of(m, wide, region);
    for (int k = 0; k < wide_region_size; ++k)
        if (region[k] >= 0 && region[k] != m && mark[region[k]] == untreated)
            mark[region[k]] = rejected;
    mark[m] = accepted;
}
