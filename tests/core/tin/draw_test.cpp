// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/float_bits.h"
#include "ddt/points.h"

namespace ddt::test {
namespace {

TEST(Draw, APlaneStaysAPlaneAndEveryPixelHasOneTriangle) {
    PointMesh mesh{{0, 8, 8, 0, 4}, {0, 0, 8, 8, 4}, {{0, 1, 4}, {1, 4, 2}, {2, 3, 4}, {3, 0, 4}}};
    const auto plane = [](double x, double y) { return float(0.25 * x - 0.5 * y + 3); };
    std::vector<float> values;
    for (size_t i = 0; i < 5; ++i)
        values.push_back(plane(mesh.x[i], mesh.y[i]));
    // Pixels beyond the square on both sides, on its rim, its diagonals and its middle.
    const PixelGrid grid{-1, 9, 0.5, -0.5, 21, 21};
    std::vector<float> pixels(21 * 21, -7.0f);
    std::vector<uint8_t> inside(21 * 21);
    ASSERT_TRUE(draw(mesh, values.data(), 1, grid, pixels.data(), inside.data()));
    for (int j = 0; j < 21; ++j)
        for (int i = 0; i < 21; ++i) {
            const double x = -1 + 0.5 * i, y = 9 - 0.5 * j;
            const bool in = x >= 0 && x <= 8 && y >= 0 && y <= 8;
            ASSERT_EQ(inside[size_t(21 * j + i)] != 0, in) << x << " " << y;
            ASSERT_NEAR(pixels[size_t(21 * j + i)], in ? plane(x, y) : -7.0f, 1e-5);
        }
    std::vector<float> again(21 * 21, -7.0f);
    std::reverse(mesh.triangles.begin(), mesh.triangles.end());
    ASSERT_TRUE(draw(mesh, values.data(), 1, grid, again.data(), inside.data()));
    EXPECT_EQ(pixels, again);
}

TEST(Draw, ATriangleWithoutAreaShowsNothing) {
    // The first and the last lie on a row of pixels, one a line and one a point.
    const PointMesh mesh{{0, 4, 0, 2}, {0, 0, 4, 0}, {{0, 3, 1}, {0, 1, 2}, {3, 3, 3}, {1, 3, 0}}};
    const std::vector<float> values = {1, 1, 1, 1};
    const PixelGrid grid{0, 0, 1, 1, 6, 2};
    std::vector<float> pixels(12, -7.0f);
    std::vector<uint8_t> inside(12);
    ASSERT_TRUE(draw(mesh, values.data(), 1, grid, pixels.data(), inside.data()));
    EXPECT_EQ(pixels, (std::vector<float>{1, 1, 1, 1, 1, -7, 1, 1, 1, 1, -7, -7}));
}

TEST(Draw, NothingIsDrawnOfAMeshThatIsNone) {
    PointMesh mesh{{0, 2, 0, 2}, {0, 0, 2, 2}, {{0, 1, 2}, {1, 3, 2}}};
    const std::vector<float> values = {1, 1, 1, 1};
    for (const int32_t wrong : {-1, 4}) {
        mesh.triangles[1][1] = wrong;
        std::vector<float> pixels(9, -7.0f);
        std::vector<uint8_t> inside(9, 5);
        std::string error;
        EXPECT_FALSE(
            draw(mesh, values.data(), 1, {0, 0, 1, 1, 3, 3}, pixels.data(), inside.data(), &error));
        EXPECT_EQ(error,
                  "ddt: triangle 1 has the vertex " + std::to_string(wrong) + "; there are 0 to 3");
        EXPECT_EQ(pixels, std::vector<float>(9, -7.0f));
        EXPECT_EQ(inside, std::vector<uint8_t>(9, 5));
    }
}

TEST(Draw, WhatHasNoWeightIsNotLookedAt) {
    const float infinity = std::numeric_limits<float>::infinity();
    PointMesh mesh;
    mesh.x = {0, 2, 0, 2};
    mesh.y = {0, 0, 2, 2};
    const std::vector<float> values = {1, 2, 4, infinity};
    for (const auto& triangles : {std::vector<std::array<int32_t, 3>>{{0, 1, 2}, {1, 3, 2}},
                                  std::vector<std::array<int32_t, 3>>{{1, 3, 2}, {0, 1, 2}}}) {
        mesh.triangles = triangles;
        std::vector<float> pixels(9);
        std::vector<uint8_t> inside(9);
        ASSERT_TRUE(draw(mesh, values.data(), 1, {0, 0, 1, 1, 3, 3}, pixels.data(), inside.data()));
        EXPECT_EQ(pixels,
                  (std::vector<float>{1, 1.5f, 2, 2.5f, 3, infinity, 4, infinity, infinity}));
    }
}

TEST(Draw, SizesThatCannotBe) {
    PointMesh mesh;
    mesh.x = {0, 2, 0};
    mesh.y = {0, 0, 2};
    mesh.triangles = {{0, 1, 2}};
    const std::vector<float> values(3);
    float pixel = 7;
    uint8_t inside = 7;
    const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
    for (const PixelGrid& grid :
         {PixelGrid{0, 0, 1, 1, -1, 1}, PixelGrid{0, 0, 1, 1, 1, -5}, PixelGrid{0, 0, 0, 1, 1, 1},
          PixelGrid{0, 0, 1, nan, 1, 1}, PixelGrid{nan, 0, 1, 1, 1, 1},
          PixelGrid{0, -inf, 1, 1, 1, 1}, PixelGrid{1e308, 0, 1e308, 1, 1, 1}}) {
        std::string error;
        EXPECT_FALSE(draw(mesh, values.data(), 1, grid, &pixel, &inside, &error));
        EXPECT_NE(error, "");
    }
    EXPECT_FALSE(draw(mesh, values.data(), 0, {0, 0, 1, 1, 1, 1}, &pixel, &inside));
    EXPECT_EQ(pixel, 7);
    EXPECT_EQ(inside, 7);
}

TEST(Draw, DenormalsAreZero) {
    const PointMesh mesh{{0, 4, 0}, {0, 0, 4}, {{0, 1, 2}}};
    const float values[] = {1e-40f, 1e-40f, 1e-38f};
    float drawn[16];
    uint8_t inside[16];
    ASSERT_TRUE(draw(mesh, values, 1, {0, 0, 1, 1, 4, 4}, drawn, inside));
    int covered = 0;
    for (int i = 0; i < 16; ++i)
        if (inside[i]) {
            ++covered;
            EXPECT_EQ(bits_of(drawn[i]), 0u) << i;
        }
    EXPECT_GE(covered, 6);
}

} // namespace
} // namespace ddt::test
