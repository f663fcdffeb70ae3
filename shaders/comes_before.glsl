// SPDX-License-Identifier: Apache-2.0
// After what declares by_gain and gain.

// Whether candidate m comes before n. C++ twin: AcceptReject::comes_before() in
// core/triangulate/accept_reject.h.
bool comes_before(int m, int n) {
    if (by_gain) {
        float a = gain[m], b = gain[n];
        if (a != b)
            return a > b;
    }
    return m < n;
}
