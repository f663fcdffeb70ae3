// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>

#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/strutil.h>
#include <gtest/gtest.h>

#include "plugin/tool/commands.h"
#include "plugin/tool/points/point_file.h"
#include "plugin/tool/points/write_points.h"
#include "tests/plugin/tool/points/point_texts.h"
#include "tests/plugin/tool/run_command.h"
#include "tests/temporary.h"

namespace ddt::tool {
namespace {

TEST(MeshOfPoints, EdgesFollowTheValues) {
    // A ridge of ones from 1 to 3, which the diagonal of the quad 0 1 2 3 lies on and its other one
    // crosses: that is the one that the file begins with.
    PointFile points;
    points.mesh = {{0, 4, 9, 5, -4, 13, 4, 5},
                   {0, 0, 4, 4, 2, 2, -5, 9},
                   {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {1, 5, 2}, {0, 6, 1}, {3, 2, 7}}};
    points.columns = {{"z", "float", 1, {0, 1, 0, 1, 0, 0, 0, 0}}};
    const std::string in = temporary("step.ply"), out = temporary("flipped.ply");
    Failure failure;
    ASSERT_TRUE(write_points(in, points, failure));
    const Ran ran = run(make_mesh_command(), {in, out, "--cost", "jnd", "--scheme", "lawson"});
    ASSERT_EQ(ran.code, exit_done) << ran.err;
    PointFile flipped;
    ASSERT_TRUE(read_points(out, flipped, failure));
    EXPECT_EQ(flipped.mesh.x, points.mesh.x);
    EXPECT_EQ(flipped.columns[0].values, points.columns[0].values);
    EXPECT_EQ(flipped.mesh.triangles.size(), points.mesh.triangles.size());
    const auto has_edge = [](const PointFile& file, int a, int b) {
        return std::any_of(file.mesh.triangles.begin(), file.mesh.triangles.end(), [&](auto& t) {
            return std::count(t.begin(), t.end(), a) && std::count(t.begin(), t.end(), b);
        });
    };
    EXPECT_TRUE(has_edge(points, 0, 2));
    EXPECT_FALSE(has_edge(flipped, 0, 2));
    EXPECT_TRUE(has_edge(flipped, 1, 3));
    EXPECT_EQ(run(make_mesh_command(), {in, temporary("a.svg")}).code, exit_usage);
    EXPECT_EQ(run(make_mesh_command(), {in, out, "--scheme", "x"}).code, exit_usage);
    EXPECT_EQ(run(make_mesh_command(), {write_file("bad.ply", "ply\n"), out}).code, exit_failed);
}

TEST(MeshOfPoints, PointsAloneGetTheirTrianglesByScatter) {
    const std::string in =
        write_file("alone.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                                "property float y\nproperty float z\nend_header\n"
                                "0 0 1\n1 0 2\n0 1 3\n");
    const std::string made = temporary("made.ply");
    const Ran ran = run(make_mesh_command(), {in, temporary("out.ply")});
    EXPECT_EQ(ran.code, exit_failed);
    EXPECT_NE(ran.err.find("ddt scatter POINTS image.exr --mesh OUT"), std::string::npos)
        << ran.err;
    ASSERT_EQ(
        run(make_scatter_command(), {in, temporary("image.exr"), "--size", "8x8", "--mesh", made})
            .code,
        exit_done);
    EXPECT_EQ(run(make_mesh_command(), {made, temporary("out.ply")}).code, exit_done);
}

TEST(MeshOfPoints, FlagsOfOtherFilesAreRefused) {
    OIIO::ImageBuf image(OIIO::ImageSpec(4, 4, 3, OIIO::TypeUInt8));
    const std::string picture = temporary("flags.png"), ply = temporary("flags.ply");
    ASSERT_TRUE(OIIO::ImageBufAlgo::zero(image) && image.write(picture));
    ASSERT_EQ(run(make_mesh_command(), {picture, ply, "--height", "3"}).code, exit_done);
    struct Case {
        std::string in, out, flag, value, told;
    };
    for (const Case& c :
         {Case{picture, "x.ply", "--fill", "flat", "names that end in .svg; \"x.ply\" is none"},
          Case{picture, "x.OBJ", "--lines", "1", "names that end in .svg; \"x.OBJ\" is none"},
          Case{picture, "x.svg", "--height", "0",
               "names that end in .ply or .obj; \"x.svg\" is none"},
          Case{ply, "x.ply", "--height", "3", "images; \"" + ply + "\" is a mesh already"},
          Case{ply, "x.ply", "--lines", "1", "images; \"" + ply + "\" is a mesh already"},
          Case{ply, "x.ply", "--fill", "flat", "images; \"" + ply + "\" is a mesh already"}}) {
        const std::string out = temporary(c.out);
        const Ran ran = run(make_mesh_command(), {c.in, out, c.flag, c.value});
        EXPECT_EQ(ran.code, exit_usage) << c.flag;
        const std::string told = OIIO::Strutil::replace(c.told, "\"" + c.out, "\"" + out);
        EXPECT_NE(ran.err.find(c.flag + " is for " + told), std::string::npos) << ran.err;
        EXPECT_FALSE(std::filesystem::exists(out));
    }
}

} // namespace
} // namespace ddt::tool
