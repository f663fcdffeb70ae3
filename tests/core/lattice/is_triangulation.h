// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstdlib>

#include <gtest/gtest.h>

#include "core/lattice/lattice.h"
#include "tests/core/lattice/faces.h"

namespace ddt::test {

/// Whether the records make a triangulation: every triangle unimodular, each neighbour's record
/// telling of the same triangle, the whole hull covered.
inline ::testing::AssertionResult is_triangulation(const Lattice& lattice) {
    const int right = 2 * lattice.width() - 2, bottom = 2 * lattice.height() - 2;
    const auto is_vertex = [&](Pixel p) {
        return p.x >= 0 && p.y >= 0 && p.x <= right && p.y <= bottom && p.x % 2 == 0 &&
               p.y % 2 == 0;
    };
    int64_t sides = 0;
    for (int y = 0; y <= bottom; ++y)
        for (int x = 0; x <= right; ++x) {
            if (x % 2 == 0 && y % 2 == 0)
                continue;
            const auto fail = [&](const char* why) {
                return ::testing::AssertionFailure()
                       << why << " at the edge with midpoint (" << x << ", " << y << ")/2";
            };
            const Edge& e = lattice.edge(lattice.site(x, y));
            const Pixel a{x - e.v.x, y - e.v.y}, b{x + e.v.x, y + e.v.y};
            if (!is_vertex(a) || !is_vertex(b) || a == b)
                return fail("ends are no pixels");
            if (std::abs(e.v.x) > longest_edge || std::abs(e.v.y) > longest_edge)
                return fail("too long");
            for (const int sign : {1, -1}) {
                const Vec apex = sign > 0 ? e.left : e.right();
                // Nothing of the hull lies on this side of an edge along the rim.
                const int nx = -e.v.y * sign, ny = e.v.x * sign;
                const bool rim =
                    (a.x == b.x && a.x == 0 && nx < 0) || (a.x == b.x && a.x == right && nx > 0) ||
                    (a.y == b.y && a.y == 0 && ny < 0) || (a.y == b.y && a.y == bottom && ny > 0);
                if (rim != apex.zero())
                    return fail(rim ? "an apex outside the hull" : "no apex within the hull");
                if (rim)
                    continue;
                const Pixel c{x + apex.x, y + apex.y};
                if (!is_vertex(c))
                    return fail("the apex is no pixel");
                if (det(b - a, c - a) != 4 * sign)
                    return fail("triangle not unimodular, or the apex on the wrong side");
                for (const bool which : {false, true}) {
                    const Pixel end = which ? b : a, other = which ? a : b;
                    const int mx = (end.x + c.x) / 2, my = (end.y + c.y) / 2;
                    const Edge& f = lattice.edge(lattice.site(mx, my));
                    const Pixel half{end.x - mx, end.y - my}, v{f.v.x, f.v.y};
                    if (half != v && half != Pixel{-v.x, -v.y})
                        return fail("a triangle's other edge does not exist");
                    const Pixel back{other.x - mx, other.y - my};
                    if (back != Pixel{f.left.x, f.left.y} &&
                        back != Pixel{f.right().x, f.right().y})
                        return fail("a triangle's other edge does not point back");
                }
                ++sides;
            }
        }
    // Three sides a triangle, each of area 1/2.
    if (sides != 3 * int64_t(right / 2) * bottom)
        return ::testing::AssertionFailure() << "the triangles do not cover the hull once";
    return ::testing::AssertionSuccess();
}

} // namespace ddt::test
