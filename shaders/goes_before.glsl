// SPDX-License-Identifier: Apache-2.0
// After what declares gain.

// Whether the candidate at `other`, in the region of the one at m, goes before it. own: the gain at
// m, which is looked up once for all. C++ twin: core/triangulate/regions.h.
bool goes_before(int other, int m, float own) {
    float g = gain[other];
    return g > own || (g == own && other < m);
}
