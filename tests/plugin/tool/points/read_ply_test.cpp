// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "ddt/points.h"
#include "plugin/tool/points/point_file.h"
#include "tests/plugin/tool/points/point_texts.h"

namespace ddt::tool {
namespace {

const std::string ply_header = "element vertex 3\nproperty float x\nproperty float y\n"
                               "property uchar red\nelement face 1\n"
                               "property list uchar int vertex_indices\nend_header\n";

TEST(Ply, AllEncodingsReadAlike) {
    const std::string zero(4, '\0'), one_big("\x3f\x80\0\0", 4), one_little("\0\0\x80\x3f", 4);
    const auto body = [&](const std::string& one, const std::string& list) {
        return zero + zero + '\xff' + one + zero + '\0' + zero + one + '\x33' + list;
    };
    const std::string big("\3\0\0\0\0\0\0\0\1\0\0\0\2", 13),
        little("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13);
    for (const std::string& text :
         {"ply\nformat ascii 1.0\ncomment nothing\n" + ply_header +
              "0 0 255\n1 0 0\n0 1 51\n3 0 1 2\n",
          "ply\nformat binary_big_endian 1.0\n" + ply_header + body(one_big, big),
          "ply\nformat binary_little_endian 1.0\n" + ply_header + body(one_little, little)}) {
        PointFile points;
        std::string error;
        ASSERT_TRUE(read_ply(text, points, error)) << error;
        EXPECT_EQ(points.mesh.x, (std::vector<double>{0, 1, 0}));
        EXPECT_EQ(points.mesh.y, (std::vector<double>{0, 0, 1}));
        ASSERT_EQ(points.columns.size(), 1u);
        EXPECT_EQ(points.columns[0].values, (std::vector<double>{1, 0, 0.2}));
        ASSERT_EQ(points.mesh.triangles.size(), 1u);
        EXPECT_EQ(points.mesh.triangles[0], (std::array<int32_t, 3>{0, 1, 2}));
        // Cut short anywhere it is an error and nothing worse.
        for (size_t n = 0; n + 2 < text.size(); n += 3)
            EXPECT_FALSE(read_ply(text.substr(0, n), points, error)) << n;
    }
}

TEST(Ply, RefusesNonsense) {
    const auto error_of = [](const std::string& text) {
        PointFile points;
        std::string error;
        EXPECT_FALSE(read_ply(text, points, error));
        return error;
    };
    EXPECT_EQ(error_of("solid"), "not a PLY file: it does not begin with \"ply\"");
    EXPECT_EQ(error_of("ply\nformat ascii 1.0\nelement vertex 99999999999\nproperty float x\n"
                       "property float y\nend_header\n"),
              "the file ends before its vertex elements do");
    for (const char* count : {"-1", "+3", "3.5", "", "99999999999999999999"})
        EXPECT_EQ(error_of(std::string("ply\nformat ascii 1.0\nelement vertex ") + count +
                           "\nend_header\n"),
                  std::string("not a line of a PLY header: \"element vertex ") + count + "\"");
    EXPECT_EQ(error_of("ply\nformat ascii 1.0\nproperty float x\nend_header\n"),
              "not a line of a PLY header: \"property float x\"");
    EXPECT_EQ(
        error_of("ply\nformat ascii 1.0\nelement vertex 1\nproperty float z\nend_header\n1\n"),
        "there must be one element vertex, with one x and one y");
    EXPECT_EQ(error_of("ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n"
                       "property float y\nend_header\n0 0\n1 nan\n"),
              "vertex 1 has a position that is not finite");
    const std::string with_faces = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                                   "property float y\nelement face 1\n"
                                   "property list uchar uint vertex_indices\nend_header\n0 0\n";
    for (const char* face : {"3 0 0 4294967295", "3 0 0 134217728"})
        EXPECT_EQ(error_of(with_faces + face), "face 0 has a vertex that there is not") << face;
    for (const char* face : {"3 0 0 -1", "3 0 0 4294967296", "3 0 0 0.5", "256 0 0 0"})
        EXPECT_EQ(error_of(with_faces + face),
                  "face 0 ends too early or holds what is no number of its type")
            << face;
    std::string floats = with_faces;
    floats.replace(floats.find("uchar uint"), 10, "uchar float");
    EXPECT_EQ(error_of(floats + "3 0 0 0.5"), "face 0 has a vertex that there is not");
    EXPECT_EQ(error_of("ply\nelement vertex 1\nend_header\n"),
              "the PLY header has no line \"format\"");
    EXPECT_EQ(error_of("ply\nformat ascii 2.0\nend_header\n"),
              "not a line of a PLY header: \"format ascii 2.0\"");
}

/// Twice the area of the face's triangles, of which each must have some.
double area_of_face(const PointFile& points) {
    double sum = 0;
    for (size_t i = 1; i < points.mesh.triangles.size(); ++i) {
        const auto& t = points.mesh.triangles[i];
        const auto x = [&](size_t k) { return points.mesh.x[size_t(t[k])]; };
        const auto y = [&](size_t k) { return points.mesh.y[size_t(t[k])]; };
        const double area = (x(1) - x(0)) * (y(2) - y(0)) - (x(2) - x(0)) * (y(1) - y(0));
        EXPECT_NE(area, 0);
        sum += std::fabs(area);
    }
    return sum;
}

TEST(Ply, PolygonsAreTrianglesWhereverTheirCornersBegin) {
    struct Case {
        std::string corners;
        double area; ///< twice
    };
    for (const Case& c :
         {Case{"0 0 0\n2 0 0\n4 0 0\n4 4 1\n0 4 0\n", 32},        // a node on a side
          Case{"4 0 0\n1 1 0\n0 4 1\n0 0 0\n", 8},                // a reflex corner
          Case{"0 0 0\n3 0 0\n3 3 0\n2 1 0\n1 3 0\n0 3 0\n", 14}, // two
          Case{"0 0 0\n1 0 0\n2 0 0\n3 0 0\n0 3 0\n", 9},         // two nodes on a side
          Case{"0 0 0\n1 0 0\n2 0 0\n3 0 0\n3 1 0\n3 2 0\n3 3 0\n2 3 0\n1 3 0\n0 3 0\n"
               "0 2 0\n0 1 0\n",
               18}}) {
        const auto n = std::count(c.corners.begin(), c.corners.end(), '\n');
        for (const bool reversed : {false, true})
            for (std::ptrdiff_t first = 0; first < n; ++first) {
                std::string face = std::to_string(n);
                for (std::ptrdiff_t k = 0; k < n; ++k)
                    face += ' ' + std::to_string((first + (reversed ? n - k : k)) % n);
                PointFile points;
                std::string error;
                ASSERT_TRUE(read_ply(with_face(c.corners, face), points, error)) << error;
                ASSERT_EQ(points.mesh.triangles.size(), size_t(n) - 1);
                EXPECT_EQ(points.faces, [&] {
                    std::vector<uint32_t> faces(size_t(n) - 1, 1);
                    faces[0] = 0;
                    return faces;
                }());
                EXPECT_EQ(area_of_face(points), c.area) << face;
                const std::vector<float> guide(points.mesh.x.size(), 0.0f);
                EXPECT_TRUE(optimise(points.mesh, guide.data(), {}, nullptr, &error)) << error;
            }
    }
}

TEST(Ply, FansThatLieSideBySideStay) {
    PointFile points;
    std::string error;
    ASSERT_TRUE(
        read_ply(with_face("0 0 0\n4 0 0\n5 3 0\n4 4 1\n0 4 0\n", "5 0 1 2 3 4"), points, error));
    const std::vector<std::array<int32_t, 3>> fan{{5, 6, 7}, {0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
    EXPECT_EQ(points.mesh.triangles, fan);
}

} // namespace
} // namespace ddt::tool
