// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include "core/lattice/locate.h"
#include "tests/core/lattice/faces.h"
#include "tests/core/random.h"

namespace ddt::test {

/// Positions where something may go wrong, and random ones: vertices, points on edges, the rim,
/// next to all of these, anywhere.
inline std::vector<Point> make_points(const Lattice& lattice, int n, Random& random) {
    const int right = (lattice.width() - 1) * position_one;
    const int bottom = (lattice.height() - 1) * position_one;
    std::vector<int> edges;
    lattice.each_edge([&](int m) { edges.push_back(m); });
    std::vector<Point> points;
    for (int i = 0; i < n; ++i) {
        Point p{int32_t(random.bits() % uint64_t(right + 1)),
                int32_t(random.bits() % uint64_t(bottom + 1))};
        switch (i % 6) {
        case 0:
            p = {p.x & -position_one, p.y & -position_one};
            break;
        case 1:
        case 2: {
            // A point on an edge whose coordinates are multiples of 2^-16: k/2^j of the way.
            const EdgeView e = view(lattice, edges[size_t(random.below(int(edges.size())))]);
            const int j = random.between(1, 10), k = random.between(0, 1 << j);
            p = {e.a.x * position_one + ((e.b.x - e.a.x) * (position_one >> j)) * k,
                 e.a.y * position_one + ((e.b.y - e.a.y) * (position_one >> j)) * k};
            break;
        }
        case 3:
            (i % 4 < 2 ? p.x : p.y) = i % 8 < 4 ? 0 : (i % 4 < 2 ? right : bottom);
            break;
        default:
            break;
        }
        if (i % 6 == 2) {
            p.x = std::clamp(p.x + random.between(-1, 1), 0, right);
            p.y = std::clamp(p.y + random.between(-1, 1), 0, bottom);
        }
        points.push_back(p);
    }
    return points;
}

} // namespace ddt::test
