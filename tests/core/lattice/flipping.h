// SPDX-License-Identifier: Apache-2.0
// Edges flipped at random and on purpose, and the records to compare afterwards.
#pragma once

#include <vector>

#include "core/lattice/lattice.h"
#include "tests/core/random.h"

namespace ddt::test {

/// The whole of a mesh's edges as numbers, to compare meshes record by record. The direction an
/// edge is stored in counts too: the last bit of a gain may depend on it.
inline std::vector<int> records(const Lattice& lattice) {
    std::vector<int> r;
    lattice.each_edge([&](int m) {
        const Edge& e = lattice.edge(m);
        for (const Vec v : {e.v, e.left, e.right()})
            r.insert(r.end(), {v.x, v.y});
    });
    return r;
}

inline std::vector<int> flippable_edges(const Lattice& lattice) {
    std::vector<int> sites;
    lattice.each_edge([&](int m) {
        if (lattice.edge(m).flippable())
            sites.push_back(m);
    });
    return sites;
}

inline void flip_at_random(Lattice& lattice, int times, Random& random) {
    for (int i = 0; i < times; ++i) {
        const auto sites = flippable_edges(lattice);
        if (sites.empty())
            return;
        lattice.flip(sites[size_t(random.below(int(sites.size())))]);
    }
}

/// Flip until the mesh's edges are as long as they may be: a fan across the whole width (height).
inline void flip_to_longest(Lattice& lattice) {
    for (bool again = true; again;) {
        again = false;
        for (const int m : flippable_edges(lattice)) {
            const Edge& e = lattice.edge(m);
            // Only lengthen those that lean to one side, so that they do not hold each other up.
            const Vec l = e.left.x + e.left.y < 0 ? -e.left : e.left;
            const Vec v = e.v.x + e.v.y < 0 ? -e.v : e.v;
            if (e.flippable() && l.x + l.y > v.x + v.y) {
                lattice.flip(m);
                again = true;
            }
        }
    }
}

} // namespace ddt::test
