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
    Random random(7);
    std::vector<float> picture(20 * 20);
    for (const bool binary : {true, false}) {
        for (float& z : picture)
            z = binary ? float(random.unit() < 0.5f) : random.unit();
        EXPECT_LT(Enlarged(picture).largest_step(), 4.0f / factor) << binary;
    }
}

} // namespace
} // namespace ddt::test
