// SPDX-License-Identifier: Apache-2.0
#include "core/lattice/locate.h"

#include "tests/core/lattice/flipped_meshes.h"

namespace ddt::test {
namespace {

int64_t doubled_area_part(Pixel a, Pixel b, Point p) {
    return int64_t(b.x - a.x) * (p.y - a.y * position_one) -
           int64_t(b.y - a.y) * (p.x - a.x * position_one);
}

TEST(Locate, FindsTheTriangleThatASearchOfAllFinds) {
    each_flipped_mesh([](const Lattice& lattice, const std::vector<Face>& faces, Random& random) {
        int on_rim = 0;
        for (const Point p : make_points(lattice, 1500, random)) {
            const Face found = face_of_triangle(lattice, locate(lattice, p));
            const int expected = find_face(faces, p);
            if (expected >= 0) {
                ASSERT_EQ(found, faces[size_t(expected)]) << p.x << ' ' << p.y;
                continue;
            }
            // Just outside by the tie rule: a triangle of the mesh that has p on its border.
            ++on_rim;
            ASSERT_TRUE(std::binary_search(faces.begin(), faces.end(), found));
            for (size_t k = 0; k < 3; ++k)
                ASSERT_GE(doubled_area_part(found[k], found[(k + 1) % 3], p), 0);
            ASSERT_TRUE(p.x == (lattice.width() - 1) * position_one ||
                        p.y == (lattice.height() - 1) * position_one);
        }
        EXPECT_GT(on_rim, 0);
    });
}

TEST(Locate, DescribesTheTriangleAsPromised) {
    each_flipped_mesh([](const Lattice& lattice, const std::vector<Face>&, Random& random) {
        for (const Point p : make_points(lattice, 300, random)) {
            const Triangle t = locate(lattice, p);
            const Face f = face_of_triangle(lattice, t);
            ASSERT_EQ(f, make_face(f[0], f[1], f[2])); // smallest address first, det = 1
            ASSERT_EQ(det(f[1] - f[0], f[2] - f[0]), 1);
            for (size_t k = 0; k < 3; ++k) {
                const Pixel sum = f[k] + f[(k + 1) % 3];
                ASSERT_EQ(t.edge[k], lattice.site(sum.x, sum.y));
            }
        }
    });
}

TEST(Locate, WeightsAreExact) {
    each_flipped_mesh([](const Lattice& lattice, const std::vector<Face>&, Random& random) {
        for (const Point p : make_points(lattice, 300, random)) {
            const Triangle t = locate(lattice, p);
            const Face f = face_of_triangle(lattice, t);
            int32_t w[3];
            t.weights(p, w);
            ASSERT_EQ(w[0] + w[1] + w[2], position_one);
            int64_t x = 0, y = 0;
            for (size_t k = 0; k < 3; ++k) {
                ASSERT_GE(w[k], 0);
                ASSERT_EQ(w[k], doubled_area_part(f[(k + 1) % 3], f[(k + 2) % 3], p));
                x += int64_t(w[k]) * f[k].x;
                y += int64_t(w[k]) * f[k].y;
            }
            ASSERT_EQ(x, p.x);
            ASSERT_EQ(y, p.y);
        }
    });
}

TEST(Locate, HoldsIsTrueForOneTriangleOnly) {
    each_flipped_mesh([](const Lattice& lattice, const std::vector<Face>& faces, Random& random) {
        // One Triangle for each face, found by its inside.
        std::vector<Triangle> triangles;
        for (const Face& f : faces) {
            const Pixel sum = f[0] + f[1] + f[2];
            triangles.push_back(
                locate(lattice, {sum.x * position_one / 3, sum.y * position_one / 3}));
            ASSERT_EQ(face_of_triangle(lattice, triangles.back()), f);
        }
        for (const Point p : make_points(lattice, 300, random)) {
            std::vector<Face> holders;
            for (const Triangle& t : triangles) {
                int32_t w[3];
                if (std::abs(p.x - t.at[0].x) > 100 * position_one ||
                    std::abs(p.y - t.at[0].y) > 100 * position_one)
                    continue;
                t.weights(p, w);
                if (t.holds(w))
                    holders.push_back(face_of_triangle(lattice, t));
            }
            const int expected = find_face(faces, p);
            ASSERT_EQ(holders.size(), expected < 0 ? 0u : 1u);
            ASSERT_TRUE(expected < 0 || holders[0] == faces[size_t(expected)]);
        }
    });
}

} // namespace
} // namespace ddt::test
