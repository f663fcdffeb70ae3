// SPDX-License-Identifier: Apache-2.0
// After what declares by_gain and gain.
#include "goes_before.glsl"

// Whether candidate m comes before n. C++ twin: AcceptReject::comes_before() in
// core/triangulate/accept_reject.h.
bool comes_before(int m, int n) {
    return by_gain ? goes_before(m, n, gain[n]) : m < n;
}
