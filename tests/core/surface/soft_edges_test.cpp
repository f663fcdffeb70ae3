// SPDX-License-Identifier: Apache-2.0
// Soft edges seen in whole pictures: the blend of an edge with its flipped state stays within both
// its triangles, which else cut it off each at its own range.
#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "core/surface/bounds.h"
#include "ddt/core.h"
#include "ddt/option_table.h"
#include "tests/core/random.h"

namespace ddt::test {
namespace {

/// A square picture of one channel, some times as large.
struct Enlarged {
    int side;
    std::vector<float> values;

    Enlarged(const std::vector<float>& picture, int factor, const std::string& filter = "ddt") {
        FilterOptions options;
        std::string error;
        EXPECT_TRUE(parse_filter(filter, options, error)) << error;
        const int from = int(std::lround(std::sqrt(double(picture.size()))));
        side = from * factor;
        values.resize(size_t(side) * size_t(side));
        EXPECT_EQ(enlarge(picture.data(), from, from, 1, nullptr, values.data(), side, side,
                          options.surface, options.mesh, 1, &error),
                  Outcome::done)
            << error;
    }
    float at(int x, int y) const { return values[size_t(y) * size_t(side) + size_t(x)]; }

    /// Values outside 0 to 1 are cut off before they are seen, where `clipped`.
    float largest_step(bool clipped = false) const {
        const auto seen = [&](int x, int y) {
            return clipped ? std::clamp(at(x, y), 0.0f, 1.0f) : at(x, y);
        };
        float largest = 0;
        for (int y = 1; y < side; ++y)
            for (int x = 1; x < side; ++x)
                largest = std::max({largest, std::fabs(seen(x, y) - seen(x - 1, y)),
                                    std::fabs(seen(x, y) - seen(x, y - 1))});
        return largest;
    }
};

TEST(SoftEdges, ADotLooksTheSameFromEverySide) {
    std::vector<float> dot(9 * 9, 0.0f);
    dot[4 * 9 + 4] = 1.0f;
    const Enlarged large(dot, 64);
    for (int y = 0; y < large.side; ++y)
        for (int x = 0; x < large.side; ++x) {
            const float z = large.at(x, y);
            ASSERT_NEAR(z, large.at(large.side - 1 - x, y), 1e-6f) << x << " " << y;
            ASSERT_NEAR(z, large.at(x, large.side - 1 - y), 1e-6f) << x << " " << y;
            ASSERT_NEAR(z, large.at(y, x), 1e-6f) << x << " " << y;
        }
}

/// Small pictures of two, three and many levels from `lowest` to 1.
template <class F>
void each_picture(int pictures, float lowest, F&& f) {
    for (int seed = 0; seed < pictures; ++seed)
        for (const int levels : {2, 3, 1 << 20}) {
            Random random{uint64_t(seed)};
            std::vector<float> picture(8 * 8);
            for (float& z : picture)
                z = lowest + (1 - lowest) * float(random.below(levels)) / float(levels - 1);
            SCOPED_TRACE(::testing::Message() << "seed " << seed << ", levels " << levels);
            f(picture);
        }
}

// The steepest slope that there is, of a vertex whose gradients bend all its edges, is below four
// times that from one pixel to the next.
TEST(SoftEdges, TheSurfaceDoesNotJumpFromOneTriangleToTheNext) {
    each_picture(20, 0.0f, [](const std::vector<float>& picture) {
        EXPECT_LT(Enlarged(picture, 64).largest_step(), 4.0f / 64);
    });
}

// Corrections make it steeper. Where they make it negative it is cut off before it is seen.
TEST(SoftEdges, NorDoesThatOfDdtSharp) {
    constexpr int factor = 256;
    for (const std::string filter : {"ddt-sharp", "ddt-sharp,clipped=1,fitted=0",
                                     "ddt-sharp,clipped=1", "ddt-sharp,fitted=1,soft=0"}) {
        const bool clipped = filter.find("clipped=1") != std::string::npos;
        for (const float lowest : {-0.5f, 0.03f}) {
            if (lowest < 0 && filter != "ddt-sharp")
                continue;
            SCOPED_TRACE(::testing::Message() << filter << " from " << lowest);
            each_picture(4, lowest, [&](const std::vector<float>& picture) {
                EXPECT_LT(Enlarged(picture, factor, filter).largest_step(clipped),
                          8.0f * (1 - lowest) / factor);
            });
        }
    }
}

TEST(SoftEdges, AreBoundedByWhatTheVerticesAre) {
    SurfaceOptions surface;
    EXPECT_EQ(bounds_of(surface), Bounds::vertices);
    surface.consistency = 2;
    EXPECT_EQ(bounds_of(surface), Bounds::dark);
    surface.clipped = true;
    EXPECT_EQ(bounds_of(surface), Bounds::none);
    surface.soft = 0;
    EXPECT_EQ(bounds_of(surface), Bounds::vertices);
    surface.fitted = true; // bends of which go past the vertices
    EXPECT_EQ(bounds_of(surface), Bounds::none);
}

// Nor does rounding show where nothing but that could.
TEST(SoftEdges, WithoutThemAnEvenPictureComesBackExactly) {
    for (const std::string filter : {"ddt", "ddt-linear,consistency=2", "ddt-sharp,soft=0"})
        for (const float even : {0.1f, 0.3f, 0.999f})
            for (const float z : Enlarged(std::vector<float>(8 * 8, even), 7, filter).values)
                ASSERT_EQ(z, even) << filter;
}

} // namespace
} // namespace ddt::test
