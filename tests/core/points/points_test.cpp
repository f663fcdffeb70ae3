// SPDX-License-Identifier: Apache-2.0
#include "ddt/points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/tin/step_grid.h"
#include "ddt/names.h"
#include "tests/core/helpers.h"
#include "tests/core/plain.h"
#include "tests/core/random_points.h"

namespace ddt::test {
namespace {

/// The circle through a, b, c holds no other point. In long double; cases too near to tell pass.
bool is_delaunay(const PointMesh& mesh) {
    for (const auto& t : mesh.triangles) {
        long double m[3][3];
        for (size_t p = 0; p < mesh.x.size(); ++p) {
            for (size_t k = 0; k < 3; ++k) {
                const long double x = mesh.x[size_t(t[k])] - mesh.x[p],
                                  y = mesh.y[size_t(t[k])] - mesh.y[p];
                m[k][0] = x;
                m[k][1] = y;
                m[k][2] = x * x + y * y;
            }
            const long double det = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                                    m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                                    m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
            if (det > 1e3L)
                return false;
        }
    }
    return true;
}

/// Twice the area of all triangles, each of which must be positive.
int64_t doubled_area(const PointMesh& mesh) {
    StepGrid grid;
    std::string error;
    EXPECT_TRUE(grid.fit(mesh.x, mesh.y, error));
    const auto vertices = vertices_of(grid, mesh.x, mesh.y);
    int64_t sum = 0;
    for (const auto& t : mesh.triangles) {
        const int64_t area = orientation(vertices[size_t(t[0])].at, vertices[size_t(t[1])].at,
                                         vertices[size_t(t[2])].at);
        EXPECT_GT(area, 0);
        sum += area;
    }
    return sum;
}

std::string failure_of(PointMesh mesh) {
    std::string error;
    EXPECT_FALSE(delaunay(mesh, &error));
    return error;
}

TEST(Delaunay, CirclesThroughTrianglesAreEmpty) {
    for (const int count : {3, 4, 10, 300}) {
        PointMesh mesh = random_points(count, uint64_t(count));
        std::string error;
        ASSERT_TRUE(delaunay(mesh, &error)) << error;
        EXPECT_TRUE(is_delaunay(mesh));
    }
}

TEST(Delaunay, CoversTheConvexHull) {
    // Many points on and next to a straight rim.
    for (uint64_t seed = 1; seed <= 20; ++seed) {
        PointMesh mesh = random_points(2000, seed);
        std::string error;
        ASSERT_TRUE(delaunay(mesh, &error)) << error;
        std::set<std::array<int32_t, 2>> sides;
        for (const auto& t : mesh.triangles)
            for (size_t k = 0; k < 3; ++k)
                EXPECT_TRUE(sides.insert({t[k], t[(k + 1) % 3]}).second);
        StepGrid grid;
        ASSERT_TRUE(grid.fit(mesh.x, mesh.y, error)) << error;
        const auto vertices = vertices_of(grid, mesh.x, mesh.y);
        const auto at = [&](int32_t v) { return vertices[size_t(v)].at; };
        size_t rim = 0;
        for (const auto& s : sides) {
            if (sides.count({s[1], s[0]}))
                continue;
            ++rim;
            EXPECT_TRUE(std::none_of(vertices.begin(), vertices.end(), [&](const auto& v) {
                return orientation(at(s[0]), at(s[1]), v.at) < 0;
            })) << "a point beyond the rim";
        }
        // Euler's formula: no point is left out within.
        EXPECT_EQ(mesh.triangles.size(), 2 * mesh.x.size() - 2 - rim);
    }
}

TEST(Delaunay, PointsOfAGridAndPointsTwice) {
    PointMesh mesh;
    for (int k = 0; k < 2; ++k)
        for (int y = 0; y < 12; ++y)
            for (int x = 0; x < 17; ++x) {
                mesh.x.push_back(x);
                mesh.y.push_back(y);
            }
    std::string error;
    ASSERT_TRUE(delaunay(mesh, &error)) << error;
    EXPECT_EQ(mesh.triangles.size(), 2u * 11 * 16);
    for (const auto& t : mesh.triangles)
        for (const int32_t v : t)
            EXPECT_LT(v, 12 * 17);
}

TEST(Delaunay, SaysWhatIsWrong) {
    PointMesh line;
    for (int i = 0; i < 9; ++i) {
        line.x.push_back(3 * i);
        line.y.push_back(2 * i);
    }
    for (const PointMesh& flat :
         {line, PointMesh{{1, 2}, {5, 3}, {}}, PointMesh{{7, 7, 7}, {5, 5, 5}, {}},
          PointMesh{{0, 1e9, 2e9}, {0, 0.1, 0}, {}}})
        EXPECT_EQ(failure_of(flat), "ddt: triangles need 3 points that are not on one line or too "
                                    "flat beside their extent");
    EXPECT_NE(failure_of({}).find("1 to"), std::string::npos);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(failure_of({{0, 1, nan}, {0, 1, 5}, {}}),
              "ddt: point 2 has a position that is not finite");
    const double huge = std::numeric_limits<double>::max();
    EXPECT_EQ(failure_of({{-huge, huge, 0}, {0, 1, 5}, {}}),
              "ddt: the points' positions are too far apart; x and y may span 1.7e308 at most");
}

TEST(Optimise, KeepsTheHullAndLowersTheCost) {
    PointMesh mesh = random_points(500, 3);
    std::string error;
    ASSERT_TRUE(delaunay(mesh, &error)) << error;
    const int64_t area = doubled_area(mesh);
    std::vector<float> guide;
    for (size_t i = 0; i < mesh.x.size(); ++i)
        guide.push_back(mesh.x[i] + mesh.y[i] > 900 ? 1.0f : 0.0f);
    for (const Cost cost : all_costs) {
        PointMesh flipped = mesh;
        MeshOptions options;
        options.cost = cost;
        options.scheme = Scheme::lawson;
        options.min_gain = -1;
        MeshReport report;
        ASSERT_TRUE(optimise(flipped, guide.data(), options, &report, &error)) << error;
        EXPECT_EQ(doubled_area(flipped), area);
        EXPECT_LT(report.cost, report.cost_start);
        EXPECT_GT(report.statistics.flips, 0);
        EXPECT_EQ(report.statistics.pixels, 500);
        MeshReport again;
        options.scheme = Scheme::pixel;
        ASSERT_TRUE(optimise(flipped, guide.data(), options, &again, &error)) << error;
        EXPECT_NEAR(again.cost_start / report.cost, 1, 1e-6); // floats, from other ends
        EXPECT_EQ(again.cost, again.cost_start);
    }
}

TEST(Optimise, DoesNotDependOnTheOrderOfTriangles) {
    PointMesh mesh{{0, 4, 5, 1, 2}, {0, 1, 6, 5, 3}, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
    PointMesh other = mesh;
    other.triangles = {{3, 2, 4}, {4, 3, 0}, {4, 1, 0}, {2, 4, 1}};
    const float guide[] = {0, 0.3f, 0.9f, 0.4f, 0.8f};
    for (PointMesh* m : {&mesh, &other}) {
        ASSERT_TRUE(optimise(*m, guide, {}));
        for (auto& t : m->triangles)
            std::sort(t.begin(), t.end());
        std::sort(m->triangles.begin(), m->triangles.end());
    }
    EXPECT_EQ(mesh.triangles, other.triangles);
}

/// Delaunay triangles of a 13 x 11 lattice, with some that run the other way round, and a guide.
PointMesh partly_clockwise(std::vector<float>& guide) {
    constexpr int width = 13, height = 11;
    PointMesh mesh;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            mesh.x.push_back(x);
            mesh.y.push_back(y);
            const int v = y * width + x;
            if (x + 1 == width || y + 1 == height)
                continue;
            mesh.triangles.push_back({v, v + 1, v + width});
            mesh.triangles.push_back({v + 1, v + width + 1, v + width});
            if (v % 3)
                std::swap(mesh.triangles.back()[0], mesh.triangles.back()[1]);
        }
    guide = make_guide(Kind::noise, width, height, 8);
    return mesh;
}

TEST(Optimise, TrianglesComeOutRunningFromXTowardsY) {
    std::vector<float> guide;
    const PointMesh given = partly_clockwise(guide);
    for (const std::string& scheme : scheme_names()) {
        SCOPED_TRACE(scheme);
        MeshOptions options;
        ASSERT_TRUE(find_scheme(scheme, options));
        options.max_iterations = 6; // annealing does as many as it may
        PointMesh mesh = given;
        ASSERT_TRUE(optimise(mesh, guide.data(), options, nullptr, nullptr, {}, Device::cpu));
        ASSERT_EQ(mesh.triangles.size(), given.triangles.size());
        double area = 0;
        for (const auto& t : mesh.triangles) {
            const auto at = [&](size_t k) {
                return Pixel{int(mesh.x[size_t(t[k])]), int(mesh.y[size_t(t[k])])};
            };
            const int64_t doubled = det(at(1) - at(0), at(2) - at(0));
            EXPECT_GT(doubled, 0);
            area += 0.5 * double(doubled);
        }
        EXPECT_EQ(area, 12 * 10);
    }
}

TEST(Optimise, SomeOptionsMeanNothing) {
    std::vector<float> guide;
    const PointMesh given = partly_clockwise(guide);
    MeshReport wanted;
    PointMesh plain = given;
    ASSERT_TRUE(optimise(plain, guide.data(), plain_mesh(), &wanted, nullptr, {}, Device::cpu));
    ASSERT_GT(wanted.statistics.flips, 0);
    const auto same = [&](const char* what, auto&& change) {
        MeshOptions options = plain_mesh();
        change(options);
        PointMesh mesh = given;
        MeshReport report;
        ASSERT_TRUE(optimise(mesh, guide.data(), options, &report, nullptr, {}, Device::cpu));
        EXPECT_EQ(mesh.triangles, plain.triangles) << what;
        EXPECT_EQ(report.cost_start, wanted.cost_start) << what;
        EXPECT_EQ(report.cost, wanted.cost) << what;
    };
    for (const float blur : {largest_blur, 9.0f, std::nanf("")})
        same("blur", [&](MeshOptions& o) { o.blur = blur; });
    for (const float contour : {5.0f, -9.0f, std::nanf("")})
        same("contour", [&](MeshOptions& o) { o.contour = contour; });
    for (const int meshes : {most_meshes, 77})
        same("meshes", [&](MeshOptions& o) { o.meshes = meshes; });
    for (const Start start : {Start::diagonal, Start(9)})
        same("start", [&](MeshOptions& o) { o.start = start; });
}

TEST(Optimise, RefusesWhatIsNoTriangulation) {
    const PointMesh points{{0, 4, 0, 4, 2}, {0, 0, 4, 4, 0}, {}};
    const float guide[5] = {};
    const auto failure = [&](const std::vector<std::array<int32_t, 3>>& triangles) {
        PointMesh mesh = points;
        mesh.triangles = triangles;
        std::string error;
        EXPECT_FALSE(optimise(mesh, guide, {}, nullptr, &error));
        EXPECT_EQ(mesh.triangles, triangles);
        return error;
    };
    EXPECT_EQ(failure({}), "ddt: there are no triangles");
    EXPECT_EQ(failure({{0, 1, 2}, {0, 1, 5}}),
              "ddt: triangle 1 has the vertex 5; there are 0 to 4");
    EXPECT_EQ(failure({{0, 1, 4}}),
              "ddt: triangle 0 has no area, or too little beside what all span");
    EXPECT_EQ(failure({{0, 1, 2}, {0, 1, 3}}), "ddt: triangle 1 lies over another at one of its "
                                               "edges");
    PointMesh mesh{{0, 4, 0}, {0, 0, 4}, {{0, 1, 2}}};
    MeshOptions options;
    options.max_iterations = 1000;
    EXPECT_FALSE(optimise(mesh, guide, options));
    std::string error;
    EXPECT_FALSE(optimise(mesh, guide, {}, nullptr, &error, {}, Device(9)));
    EXPECT_EQ(error.compare(0, 33, "ddt: option \"device=\" is not allo"), 0) << error;
    EXPECT_TRUE(optimise(mesh, guide, {}));
}

TEST(Optimise, CanBeCancelled) {
    PointMesh mesh = random_points(300, 4);
    ASSERT_TRUE(delaunay(mesh));
    std::vector<float> guide;
    for (size_t i = 0; i < mesh.x.size(); ++i)
        guide.push_back(float(i % 7) / 7);
    std::string error;
    const auto triangles = mesh.triangles;
    for (const int last : {1, 3}) {
        int calls = 0;
        EXPECT_FALSE(optimise(mesh, guide.data(), {}, nullptr, &error,
                              [&](float) { return ++calls < last; }));
        EXPECT_EQ(error, "ddt: cancelled");
        EXPECT_EQ(mesh.triangles, triangles);
    }
}

// A road, two kilometres long and six metres wide.
TEST(Delaunay, OfANarrowBandLeavesNoPointOut) {
    PointMesh road;
    for (int i = 0; i < 200; ++i) {
        road.x.push_back(10 * i);
        road.y.push_back(3 * std::sin(0.01 * i));
    }
    std::string error;
    ASSERT_TRUE(delaunay(road, &error)) << error;
    std::set<int32_t> used;
    for (const auto& t : road.triangles)
        used.insert(t.begin(), t.end());
    EXPECT_EQ(used.size(), 200u);
}

TEST(Delaunay, CanBeCancelled) {
    PointMesh mesh = random_points(3000, 1);
    mesh.triangles = {{0, 1, 2}};
    std::string error;
    EXPECT_FALSE(delaunay(mesh, &error, [](float share) { return share < 0.5f; }));
    EXPECT_EQ(error, "ddt: cancelled");
    EXPECT_EQ(mesh.triangles, (std::vector<std::array<int32_t, 3>>{{0, 1, 2}}));
}

TEST(Points, AnnealingHasRoomForTheLargestSteps) {
    constexpr double side = 1.9999999999; // 2^30 steps
    PointMesh mesh;
    mesh.x = {0, side, 0, side, side / 2};
    mesh.y = {0, 0, side, side, side / 3};
    const std::vector<float> guide = {0, 1, 0.5f, 0, 1};
    MeshOptions options = plain_mesh();
    options.scheme = Scheme::annealing;
    std::string error;
    ASSERT_TRUE(delaunay(mesh, &error)) << error;
    EXPECT_TRUE(optimise(mesh, guide.data(), options, nullptr, &error)) << error;
    EXPECT_EQ(mesh.triangles.size(), 4u);
}

} // namespace
} // namespace ddt::test
