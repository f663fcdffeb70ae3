// SPDX-License-Identifier: Apache-2.0
#include "core/lattice/locate.h"
#include "tests/core/helpers.h"
#include "tests/core/sample/surface_reader.h"
#include "tests/core/surface/scene.h"

namespace ddt::test {
namespace {

TEST(LocateRow, ARowIsItsPositionsOneByOne) {
    each_scene([](const Scene& scene, Random& random) {
        const int right = (scene.lattice.width() - 1) * position_one;
        const int bottom = (scene.lattice.height() - 1) * position_one;
        for (const Surface surface : both_surfaces) {
            const auto values = make_values(Values::hdr, scene.pixels(), random);
            SurfaceReader reader(scene, surface, values);
            for (int k = 0; k < 60; ++k) {
                // Straight rows, sloping ones, along the rim, on lattice lines, small and large
                // steps.
                const int n = random.between(1, 60), step = 1 << random.between(0, 17);
                Point p{random.between(0, right), random.between(0, bottom)};
                if (k % 3 == 0)
                    p.y &= -position_one;
                if (k % 5 == 0)
                    p.x &= -(position_one / 4);
                const Point d{k % 2 ? step : -step, k % 4 < 2 ? 0 : random.between(-step, step)};
                std::vector<Point> points;
                for (int i = 0; i < n; ++i) {
                    points.push_back(p);
                    p.x = std::clamp(p.x + d.x, 0, right);
                    p.y = std::clamp(p.y + d.y, 0, bottom);
                }
                std::vector<float> expected;
                for (const Point q : points)
                    expected.push_back(reader.row(&q, 1, true)[0]);
                ASSERT_EQ(differing(reader.row(points.data(), n), expected), 0u);
                ASSERT_EQ(differing(reader.row(points.data(), n), expected), 0u); // known now
                // A row a little lower.
                for (Point& q : points)
                    q.y = std::min(q.y + 3000, bottom);
                const auto below = reader.row(points.data(), n);
                ASSERT_EQ(differing(below, reader.row(points.data(), n, true)), 0u);
            }
        }
    });
}

TEST(LocateRow, RowsHoldTheTrianglesOfTheirPositions) {
    int in_cells = 0, in_triangles = 0;
    each_scene([&](const Scene& scene, Random& random) {
        const Lattice& l = scene.lattice;
        Search search;
        LocatedRow row;
        search.begin();
        for (int y = 0; y <= (l.height() - 1) * position_one; y += 20011) {
            std::vector<Point> points;
            for (int x = 0; x <= (l.width() - 1) * position_one; x += random.between(1, 9000))
                points.push_back({x, y});
            locate_row(l, points.data(), int(points.size()), search, row);
            int at = 0;
            for (const Span& s : row.spans) {
                ASSERT_EQ(s.begin, at);
                ASSERT_GT(s.end, s.begin);
                at = s.end;
                for (int i = s.begin; i < s.end; ++i) {
                    const Point p = points[size_t(i)];
                    const Triangle t = locate(l, p);
                    const Face f = face_of_triangle(l, t);
                    int32_t w[3];
                    t.weights(p, w);
                    if (s.kind == Span::triangle) {
                        ++in_triangles;
                        const int cx = std::min(p.x >> position_bits, l.width() - 2);
                        const int cy = std::min(p.y >> position_bits, l.height() - 2);
                        for (int k = 0; k < 3; ++k) {
                            ASSERT_EQ(s.vertex[k], t.vertex[k]);
                            ASSERT_EQ(s.edge[k], t.edge[k]);
                            ASSERT_EQ(row.weight[k][size_t(i)] * 65536.0f, float(w[k]));
                            ASSERT_LE(f[size_t(k)].x, cx + l.longest());
                            ASSERT_GE(f[size_t(k)].x, cx + 1 - l.longest());
                            ASSERT_LE(f[size_t(k)].y, cy + l.longest());
                            ASSERT_GE(f[size_t(k)].y, cy + 1 - l.longest());
                        }
                        continue;
                    }
                    // A plain cell: the triangle's vertices are three of its corners.
                    ++in_cells;
                    const Pixel corner{s.vertex[0] % l.stride() / 2, s.vertex[0] / l.stride() / 2};
                    ASSERT_EQ(row.weight[0][size_t(i)] * 65536.0f,
                              float(p.x - corner.x * position_one));
                    ASSERT_EQ(row.weight[1][size_t(i)] * 65536.0f,
                              float(p.y - corner.y * position_one));
                    for (const Pixel v : f) {
                        const Pixel c = v - corner;
                        ASSERT_TRUE(c.x >= 0 && c.x <= 1 && c.y >= 0 && c.y <= 1);
                    }
                }
            }
            ASSERT_EQ(at, int(points.size()));
        }
    });
    EXPECT_GT(in_cells, 1000);
    EXPECT_GT(in_triangles, 1000);
}

} // namespace
} // namespace ddt::test
