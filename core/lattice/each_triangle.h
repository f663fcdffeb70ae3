// SPDX-License-Identifier: Apache-2.0
// A lattice's triangles.
#pragma once

#include "core/lattice/lattice.h"

namespace ddt {

/// Call f(a, b, c) with the vertices' sites, det(b - a, c - a) = 1, for every triangle once: at the
/// smallest address of its edges, in address order. Of those that begin in rows y0 to y1 - 1 of
/// sites.
template <class F>
void each_triangle(const Lattice& lattice, int y0, int y1, F&& f) {
    lattice.each_edge(y0, y1, [&](int m) {
        const Edge& e = lattice.edge(m);
        const int v = lattice.offset(e.v);
        const auto side = [&](int a, int b, Vec apex) {
            if (apex.zero())
                return;
            const int c = m + lattice.offset(apex);
            // Sites are linear in position, so a midpoint's is the mean of its ends'.
            if (m < (b + c) / 2 && m < (c + a) / 2)
                f(a, b, c);
        };
        side(m - v, m + v, e.left);
        side(m + v, m - v, e.right());
    });
}

} // namespace ddt
