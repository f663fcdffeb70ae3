// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <set>

#include "core/tin/delaunay.h"
#include "ddt/points.h"
#include "tests/core/helpers.h"

namespace ddt::test {
namespace {

/// Different points of a box, sorted row by row.
std::vector<Steps> points_in(int count, uint32_t width, uint32_t height, uint64_t seed) {
    Random random(seed);
    std::vector<Steps> points;
    for (int i = 0; i < count; ++i)
        points.push_back({int32_t(random.below(width)), int32_t(random.below(height))});
    std::sort(points.begin(), points.end(), before);
    points.erase(std::unique(points.begin(), points.end(),
                             [](Steps a, Steps b) { return !before(a, b) && !before(b, a); }),
                 points.end());
    return points;
}

bool on_one_line(const std::vector<Steps>& points) {
    return std::all_of(points.begin(), points.end(),
                       [&](Steps p) { return orientation(points.front(), points.back(), p) == 0; });
}

/// Whether d lies within the circle through a, b and c, by numbers that are exact for small steps.
bool in_circle(Steps a, Steps b, Steps c, Steps d) {
    const auto row = [&](Steps p) {
        const double x = p.x - d.x, y = p.y - d.y;
        return std::array{x, y, x * x + y * y};
    };
    const auto p = row(a), q = row(b), r = row(c);
    return p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0]) +
               p[2] * (q[0] * r[1] - q[1] * r[0]) >
           0;
}

/// Andrew's monotone chain: the corners of the convex hull of points sorted by y, then x.
std::vector<Steps> hull_of(const std::vector<Steps>& points) {
    std::vector<Steps> hull;
    const auto chain = [&](auto begin, auto end) {
        const size_t base = hull.size();
        for (auto p = begin; p != end; ++p) {
            while (hull.size() >= base + 2 &&
                   orientation(hull[hull.size() - 2], hull.back(), *p) <= 0)
                hull.pop_back();
            hull.push_back(*p);
        }
        hull.pop_back(); // the other chain begins with it
    };
    chain(points.begin(), points.end());
    chain(points.rbegin(), points.rend());
    return hull;
}

/// Whether the triangles' areas add up to that of the points' convex hull.
bool covers_hull(const std::vector<Steps>& points,
                 const std::vector<std::array<int32_t, 3>>& triangles) {
    // Whole numbers of up to 61 bits times their number: modulo 2^64 they still compare, as the
    // hull's own area, which is what they make if all is well, is below 2^61.
    uint64_t sum = 0, whole = 0;
    for (const auto& t : triangles)
        sum +=
            uint64_t(orientation(points[size_t(t[0])], points[size_t(t[1])], points[size_t(t[2])]));
    const std::vector<Steps> hull = hull_of(points);
    for (size_t i = 2; i < hull.size(); ++i)
        whole += uint64_t(orientation(hull[0], hull[i - 1], hull[i]));
    return sum == whole;
}

void check(const std::vector<Steps>& points, bool circles, Ties ties = {}) {
    std::vector<std::array<int32_t, 3>> triangles;
    ASSERT_TRUE(find_delaunay(points, triangles, ties));
    EXPECT_TRUE(covers_hull(points, triangles));
    std::set<int32_t> used;
    std::set<std::array<int32_t, 2>> sides;
    for (const auto& t : triangles) {
        const auto at = [&](size_t k) { return points[size_t(t[k])]; };
        EXPECT_GT(orientation(at(0), at(1), at(2)), 0);
        for (size_t k = 0; k < 3; ++k) {
            used.insert(t[k]);
            EXPECT_TRUE(sides.insert({t[k], t[(k + 1) % 3]}).second) << "two beside one edge";
        }
        for (const Steps& p : points)
            ASSERT_FALSE(circles && in_circle(at(0), at(1), at(2), p));
    }
    EXPECT_EQ(used.size(), points.size());
}

TEST(FindDelaunay, CirclesAreEmpty) {
    for (const uint32_t width : {4u, 30u, 1000u})
        for (const uint32_t height : {3u, 30u, 1000u})
            for (const int count : {3, 4, 10, 60})
                for (uint64_t seed = 0; seed < 8; ++seed) {
                    const auto points = points_in(count, width, height, seed);
                    if (!on_one_line(points))
                        check(points, true);
                }
}

TEST(FindDelaunay, AnyShape) {
    constexpr uint32_t most = 1u << 30;
    for (const uint32_t height : {2u, 5u, 1000u, 1000000u, most})
        for (const int count : {3, 50, 3000})
            for (const bool turned : {false, true}) {
                const auto points =
                    turned ? points_in(count, height, most, 9) : points_in(count, most, height, 9);
                if (!on_one_line(points))
                    check(points, false);
            }
}

TEST(FindDelaunay, ManyOnOneLine) {
    std::vector<Steps> points;
    for (int x = 0; x < 40; ++x)
        points.push_back({x, 0});
    points.push_back({7, 1});
    check(points, true);
    for (int x = 0; x < 40; ++x)
        points.push_back({x, 2});
    check(points, true);
}

std::vector<Steps> square(int side) {
    std::vector<Steps> points;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            points.push_back({x, y});
    return points;
}

// What check() goes by.
TEST(FindDelaunay, AHullThatIsNotCoveredIsNoticed) {
    const auto points = points_in(60, 1000, 1000, 1);
    std::vector<std::array<int32_t, 3>> all;
    ASSERT_TRUE(find_delaunay(points, all));
    ASSERT_TRUE(covers_hull(points, all));
    for (size_t i = 0; i < all.size(); ++i) { // on the rim and within
        auto triangles = all;
        triangles.erase(triangles.begin() + std::ptrdiff_t(i));
        EXPECT_FALSE(covers_hull(points, triangles)) << i;
        triangles = all;
        triangles.push_back(all[i]);
        EXPECT_FALSE(covers_hull(points, triangles)) << i;
    }
    EXPECT_FALSE(covers_hull(points, {}));
}

TEST(FindDelaunay, OfPointsOnACircleTheFlatterDiagonalIsMade) {
    const auto points = square(2);
    for (const auto& [guide, first, second] :
         {std::tuple{std::array{0.0f, 1.0f, 0.2f, 0.1f}, 0, 3}, // its ends differ by 0.1, not 0.8
          std::tuple{std::array{0.0f, 0.5f, 0.4f, 1.0f}, 1, 2}}) {
        std::vector<std::array<int32_t, 3>> triangles;
        ASSERT_TRUE(find_delaunay(points, triangles, {guide.data(), 0}));
        ASSERT_EQ(triangles.size(), 2u);
        for (const auto& t : triangles)
            for (const int32_t v : {first, second})
                EXPECT_EQ(std::count(t.begin(), t.end(), v), 1);
    }
}

TEST(FindDelaunay, AnotherSeedIsAnotherTriangulation) {
    constexpr int side = 9;
    const auto points = square(side);
    Random random(2);
    std::vector<float> guide;
    for (size_t i = 0; i < points.size(); ++i)
        guide.push_back(float(random.below(100)));
    std::set<std::vector<std::array<int32_t, 3>>> all;
    for (uint32_t seed = 0; seed < 5; ++seed) {
        check(points, true, {guide.data(), seed});
        std::vector<std::array<int32_t, 3>> triangles;
        ASSERT_TRUE(find_delaunay(points, triangles, {guide.data(), seed}));
        EXPECT_EQ(triangles.size(), size_t(2 * (side - 1) * (side - 1)));
        for (auto& t : triangles)
            std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        std::sort(triangles.begin(), triangles.end());
        all.insert(triangles);
    }
    EXPECT_EQ(all.size(), 5u);
}

TEST(FindDelaunay, CanBeCancelled) {
    const auto points = square(60);
    std::vector<std::array<int32_t, 3>> triangles;
    float last = -1;
    EXPECT_FALSE(find_delaunay(points, triangles, {}, [&](float share) {
        EXPECT_GT(share, last);
        last = share;
        return share < 0.5f;
    }));
    EXPECT_GE(last, 0.5f);
    EXPECT_TRUE(triangles.empty());
}

} // namespace
} // namespace ddt::test
