// SPDX-License-Identifier: Apache-2.0
// Soft edges seen in whole pictures: the blend of an edge with its flipped state stays within both
// its triangles, which else cut it off each at its own range.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "ddt/core.h"
#include "tests/core/random.h"

namespace ddt::test {
namespace {

constexpr int factor = 64;

/// A square picture of one channel, `factor` times as large, by `ddt` as it comes.
struct Enlarged {
    int side;
    std::vector<float> values;

    explicit Enlarged(const std::vector<float>& picture) {
        const int from = int(std::lround(std::sqrt(double(picture.size()))));
        side = from * factor;
        values.resize(size_t(side) * size_t(side));
        std::string error;
        EXPECT_EQ(enlarge(picture.data(), from, from, 1, nullptr, values.data(), side, side, {}, {},
                          1, &error),
                  Outcome::done)
            << error;
    }
    float at(int x, int y) const { return values[size_t(y) * size_t(side) + size_t(x)]; }

    float largest_step() const {
        float largest = 0;
        for (int y = 1; y < side; ++y)
            for (int x = 1; x < side; ++x)
                largest = std::max({largest, std::fabs(at(x, y) - at(x - 1, y)),
                                    std::fabs(at(x, y) - at(x, y - 1))});
        return largest;
    }
};

TEST(SoftEdges, ADotLooksTheSameFromEverySide) {
    std::vector<float> dot(9 * 9, 0.0f);
    dot[4 * 9 + 4] = 1.0f;
    const Enlarged large(dot);
    for (int y = 0; y < large.side; ++y)
        for (int x = 0; x < large.side; ++x) {
            const float z = large.at(x, y);
            ASSERT_NEAR(z, large.at(large.side - 1 - x, y), 1e-6f) << x << " " << y;
            ASSERT_NEAR(z, large.at(x, large.side - 1 - y), 1e-6f) << x << " " << y;
            ASSERT_NEAR(z, large.at(y, x), 1e-6f) << x << " " << y;
        }
}

// The steepest slope that there is, of a vertex whose gradients bend all its edges, is below four
// times that from one pixel to the next.
TEST(SoftEdges, TheSurfaceDoesNotJumpFromOneTriangleToTheNext) {
    for (uint64_t seed = 0; seed < 20; ++seed)
        for (const int levels : {2, 3, 1 << 20}) {
            Random random(seed);
            std::vector<float> picture(8 * 8);
            for (float& z : picture)
                z = float(random.below(levels)) / float(levels - 1);
            EXPECT_LT(Enlarged(picture).largest_step(), 4.0f / factor) << seed << " " << levels;
        }
}

} // namespace
} // namespace ddt::test
