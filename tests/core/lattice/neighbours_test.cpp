// SPDX-License-Identifier: Apache-2.0
#include "core/lattice/neighbours.h"

#include "core/lattice/locate.h"
#include "tests/core/helpers.h"

namespace ddt::test {
namespace {

bool holds(const Rect& r, Pixel p) {
    return p.x >= r.x0 && p.x < r.x1 && p.y >= r.y0 && p.y < r.y1;
}

Pixel pixel_at(const Lattice& lattice, int site) {
    return {site % lattice.stride() / 2, site / lattice.stride() / 2};
}

/// That the rectangle holds what its contract says.
void check(const Lattice& lattice, const Rect& part) {
    const Rect all = with_neighbours(lattice, part);
    lattice.each_edge([&](int m) {
        const int to_b = lattice.offset(lattice.edge(m).v);
        const Pixel a = pixel_at(lattice, m - to_b), b = pixel_at(lattice, m + to_b);
        if (holds(part, a) || holds(part, b)) {
            EXPECT_TRUE(holds(all, a) && holds(all, b)) << "edge " << m;
        }
    });
    constexpr int32_t step = position_one / 4;
    for (int32_t y = part.y0 * position_one; y <= (part.y1 - 1) * position_one; y += step)
        for (int32_t x = part.x0 * position_one; x <= (part.x1 - 1) * position_one; x += step)
            for (const int vertex : locate(lattice, {x, y}).vertex)
                EXPECT_TRUE(holds(all, pixel_at(lattice, vertex))) << x << ", " << y;
}

TEST(Neighbours, HoldWhatThePartIsMadeFrom) {
    constexpr int width = 23, height = 17;
    int longest = 0, less = 0;
    for (uint64_t seed = 1; seed < 40; ++seed) {
        Random random(seed);
        Lattice lattice;
        const auto guide = make_guide(Kind::noise, width, height, seed);
        lattice.start(width, height, guide.data(), true);
        flip_at_random(lattice, int(seed) * 20, random);
        longest = std::max(longest, lattice.longest());
        for (const Rect& part : {Rect{0, 0, width, height}, Rect{8, 6, 10, 8}, Rect{5, 4, 18, 12},
                                 Rect{0, 9, 12, 17}, Rect{20, 0, 23, 2}}) {
            check(lattice, part);
            const Rect all = with_neighbours(lattice, part),
                       most = grown(lattice, part, lattice.longest());
            less += all.area() < most.area();
            EXPECT_TRUE(all.x0 >= most.x0 && all.x1 <= most.x1 && all.y0 >= most.y0 &&
                        all.y1 <= most.y1);
        }
    }
    EXPECT_GT(longest, 3);
    EXPECT_GT(less, 50);
}

TEST(Neighbours, OfAFreshMeshAreOnePixelRound) {
    Lattice lattice;
    const std::vector<float> guide(20 * 20, 0.5f);
    lattice.start(20, 20, guide.data(), false);
    const Rect all = with_neighbours(lattice, {3, 0, 9, 20});
    EXPECT_TRUE(all.x0 == 2 && all.y0 == 0 && all.x1 == 10 && all.y1 == 20);
}

} // namespace
} // namespace ddt::test
