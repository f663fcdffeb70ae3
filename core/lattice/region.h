// SPDX-License-Identifier: Apache-2.0
// The wide region of an edge: the region of influence of degree 3.
//
// The region of degree k is the set of edges of the triangles that are at most k - 1 steps, across
// edges, from the two triangles of the edge itself. So degree 1 has the sides of the parallelogram,
// degree 2 (Lattice::any_of_region) 12 edges: what a flip's gain depends on; degree 3 has up to 28:
// the edges of the next ring of triangles too. "m is in the region of n" is symmetric.
#pragma once

#include "core/lattice/lattice.h"

namespace ddt {

/// Call f(site) for the edge at `site`, which runs along `side` (in pixels, either way) and has one
/// apex `inner`, and for the edges of the triangles on its other side up to `rings` steps away,
/// until f returns true. Returns whether it did. No edge is left out; at vertices with few edges
/// some are visited twice.
template <class F>
bool any_beyond(const Lattice& lattice, int site, Vec side, Vec inner, int rings, F&& f) {
    if (f(site))
        return true;
    if (rings == 0)
        return false;
    const Vec apex = apex_beyond(lattice.edge(site), inner);
    if (apex.zero())
        return false;
    // As sides and as ways to each other's midpoint. In each, the apex within the triangle is the
    // other end of this one.
    const Vec first = from_first_end(apex, side), last = from_last_end(apex, side);
    return any_beyond(lattice, site + lattice.offset(last), first, side - last, rings - 1, f) ||
           any_beyond(lattice, site + lattice.offset(first), last, -side - first, rings - 1, f);
}

/// Call f(site) for the edges of the region of degree 3 of the flippable edge at m until it returns
/// true; m itself may be among them. Returns whether f did.
template <class F>
bool any_of_wide_region(const Lattice& lattice, int m, F&& f) {
    const Quad q(lattice.edge(m));
    for (int k = 0; k < 4; ++k)
        if (any_beyond(lattice, m + lattice.offset(q.middle[k]), q.side[k], q.inner[k], 2, f))
            return true;
    return false;
}

} // namespace ddt
