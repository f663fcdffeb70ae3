// SPDX-License-Identifier: Apache-2.0
#include "core/tin/step_grid.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/tin/tin.h"
#include "ddt/names.h"
#include "ddt/points.h"
#include "tests/core/random_points.h"

namespace ddt::test {
namespace {

TEST(StepGrid, ThePointsSpanHalfOfTheStepsThereAreOrMore) {
    for (const double extent : {1.0, 1.0000001, 1.9999999, 2.0, 3.0, 1e-30, 1e30})
        for (const bool turned : {false, true}) {
            const std::vector<double> along{-0.25 * extent, 0.75 * extent}, across{0, 0.1 * extent};
            StepGrid grid;
            std::string error;
            ASSERT_TRUE(grid.fit(turned ? across : along, turned ? along : across, error)) << error;
            const double x = turned ? 0.1 * extent : 0.75 * extent,
                         y = turned ? 0.75 * extent : 0.1 * extent;
            const Steps last = grid.steps(x, y);
            EXPECT_GE(std::max(last.x, last.y), most_steps / 2) << extent;
            EXPECT_LE(std::max(last.x, last.y), most_steps) << extent;
        }
}

/// A lattice of 2 mm in the middle of a country, its diagonals all alike, and a ridge across them.
PointMesh survey(std::vector<float>& guide) {
    constexpr int side = 12;
    PointMesh mesh;
    guide.clear();
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const int v = int(mesh.x.size());
            mesh.x.push_back(500000 + x / 512.0);
            mesh.y.push_back(5000000 + y / 512.0);
            guide.push_back(x + y == side ? 1.0f : 0.0f);
            if (x + 1 < side && y + 1 < side)
                for (const std::array<int32_t, 3>& t :
                     {std::array{v, v + 1, v + side + 1}, std::array{v, v + side + 1, v + side}})
                    mesh.triangles.push_back(t);
        }
    return mesh;
}

TEST(StepGrid, PointsThatNoTriangleUsesTakeNoSteps) {
    std::vector<float> guide;
    const PointMesh mesh = survey(guide);
    PointMesh plain = mesh, far = mesh;
    far.x.push_back(0);
    far.y.push_back(0);
    guide.push_back(0);
    std::string error;
    for (const char* scheme : {"one-round", "lawson", "annealing"}) {
        MeshOptions options;
        ASSERT_TRUE(find_scheme(scheme, options));
        plain.triangles = far.triangles = mesh.triangles;
        MeshReport report;
        ASSERT_TRUE(optimise(plain, guide.data(), options, &report, &error, {}, Device::cpu) &&
                    optimise(far, guide.data(), options, nullptr, &error, {}, Device::cpu))
            << error;
        EXPECT_GT(report.statistics.flips, 0);
        EXPECT_EQ(far.triangles, plain.triangles) << scheme;
    }
    const PixelGrid grid{500000, 5000000, 1 / 1024.0, 1 / 1024.0, 24, 24};
    std::vector<float> wanted(24 * 24), drawn(24 * 24);
    std::vector<uint8_t> inside(24 * 24);
    ASSERT_TRUE(draw(plain, guide.data(), 1, grid, wanted.data(), inside.data()));
    ASSERT_TRUE(draw(far, guide.data(), 1, grid, drawn.data(), inside.data()));
    EXPECT_EQ(drawn, wanted);
    EXPECT_GT(std::count(inside.begin(), inside.end(), uint8_t(0)), 0);
    EXPECT_LT(std::count(inside.begin(), inside.end(), uint8_t(0)), 24 * 24 / 4);
}

/// Of points that lie together one is a corner; the others, which no triangle uses, hold the grid.
TEST(StepGrid, AMeshThatDelaunayMadeKeepsItsGrid) {
    PointMesh mesh = random_points(50, 5);
    // The first of each two is a corner; the other lies farther out, by less than a step, so that
    // all span a power of two and the corners less.
    mesh.x.insert(mesh.x.end(), {-1, -1 - 1e-7, 1023 - 5e-8, 1023 + 1e-7});
    mesh.y.insert(mesh.y.end(), {0, 0, 999, 999});
    StepGrid all, of_mesh;
    std::string error;
    ASSERT_TRUE(all.fit(mesh.x, mesh.y, error) && delaunay(mesh, &error)) << error;
    ASSERT_TRUE(of_mesh.fit(mesh, error)) << error;
    const std::vector<uint8_t> is_corner = corners_of(mesh.triangles, mesh.x.size());
    EXPECT_EQ(std::count(is_corner.begin(), is_corner.end(), uint8_t(0)), 2);
    for (size_t i = 0; i < mesh.x.size(); ++i) {
        const Steps a = all.steps(mesh.x[i], mesh.y[i]), b = of_mesh.steps(mesh.x[i], mesh.y[i]);
        EXPECT_TRUE(a.x == b.x && a.y == b.y) << i;
    }
}

/// A usual clean-up. Points that lay within a step of each other as the mesh was made turn some
/// triangles over on the corners' own, finer grid.
TEST(StepGrid, AMeshThatLostItsFarTrianglesKeepsTheGridThatItWasMadeOn) {
    Random random(7);
    PointMesh mesh;
    for (int i = 0; i < 1500; ++i) {
        mesh.x.push_back(500000 + random.below(1 << 24) * 0x1p-24);
        mesh.y.push_back(5000000 + random.below(1 << 24) * 0x1p-24);
    }
    mesh.x.push_back(0);
    mesh.y.push_back(0);
    std::string error;
    ASSERT_TRUE(delaunay(mesh, &error)) << error;
    const auto far = int32_t(mesh.x.size()) - 1;
    const auto has_far = [&](const std::array<int32_t, 3>& t) {
        return std::find(t.begin(), t.end(), far) != t.end();
    };
    auto& triangles = mesh.triangles;
    const size_t all = triangles.size();
    triangles.erase(std::remove_if(triangles.begin(), triangles.end(), has_far), triangles.end());
    ASSERT_LT(triangles.size(), all);
    const std::vector<float> guide(mesh.x.size());
    EXPECT_TRUE(optimise(mesh, guide.data(), {}, nullptr, &error, {}, Device::cpu)) << error;
}

} // namespace
} // namespace ddt::test
