// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <filesystem>
#include <sstream>
#include <tuple>

#include <OpenImageIO/imagebufalgo.h>
#include <gtest/gtest.h>

#include "plugin/tool/commands.h"
#include "plugin/tool/points/point_file.h"
#include "tests/plugin/tool/load_image.h"
#include "tests/plugin/tool/points/point_texts.h"
#include "tests/plugin/tool/run_command.h"
#include "tests/temporary.h"

namespace ddt::tool {
namespace {

TEST(ScatterCommand, MakesAnImage) {
    const std::string in = write_file("plane.csv", plane), out = temporary("plane.exr");
    const Ran ran =
        run(make_scatter_command(), {in, out, "--size", "8x4", "--mesh", temporary("plane.ply")});
    ASSERT_EQ(ran.code, exit_done) << ran.err;
    const OIIO::ImageBuf image = load(out);
    ASSERT_EQ(image.spec().width, 8);
    ASSERT_EQ(image.spec().height, 4);
    ASSERT_EQ(image.spec().channelnames, (std::vector<std::string>{"A", "Z"})); // as EXR sorts
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 8; ++i) {
            // The upper row is that of large y.
            EXPECT_NEAR(image.getchannel(i, j, 0, 1), 0.25 + 0.5 * i + 10 * (3.5 - j), 1e-4);
            EXPECT_EQ(image.getchannel(i, j, 0, 0), 1.0f);
        }
    PointFile mesh;
    Failure failure;
    ASSERT_TRUE(read_points(temporary("plane.ply"), mesh, failure)) << failure.why;
    EXPECT_EQ(mesh.mesh.triangles.size(), 4u);
}

TEST(ScatterCommand, TakesColoursByTheirLetters) {
    const std::string numbers = "\n0,0,255,0,0,.5\n9,1,255,0,0,.5\n4,8,255,0,0,.5\n";
    const std::string letters = write_file("letters.csv", "x,y,R,G,B,A" + numbers),
                      out = temporary("letters.exr");
    for (const char* channels : {"", "R,G,B,A", "red,green,blue,alpha"}) {
        std::vector<std::string> arguments{letters, out, "--size", "8x8"};
        if (*channels)
            arguments.insert(arguments.end(), {"--channels", channels});
        const Ran ran = run(make_scatter_command(), arguments);
        ASSERT_EQ(ran.code, exit_done) << ran.err;
        const OIIO::ImageBuf image = load(out);
        EXPECT_EQ(image.spec().channelnames, (std::vector<std::string>{"R", "G", "B", "A"}));
        EXPECT_EQ(image.getchannel(4, 4, 0, 0), 0.5f);
        EXPECT_EQ(image.getchannel(4, 4, 0, 3), 0.5f);
    }
    const Ran twice = run(make_scatter_command(), {letters, out, "--channels", "R,red"});
    EXPECT_NE(twice.err.find("\"R\" would be two channels"), std::string::npos) << twice.err;
}

TEST(ScatterCommand, LeavesTheOutsideEmptyAndPointsWithoutNumbersOut) {
    const std::string in = write_file("plane.csv", plane), out = temporary("window.exr");
    const Ran ran = run(make_scatter_command(), {in, out, "--size", "6x6", "--window", "-1,-1,5,5",
                                                 "--y-down", "--channels", "weight,z"});
    ASSERT_EQ(ran.code, exit_done) << ran.err;
    const OIIO::ImageBuf image = load(out);
    ASSERT_EQ(image.spec().channelnames, (std::vector<std::string>{"A", "Z", "weight"}));
    for (int j = 0; j < 6; ++j)
        for (int i = 0; i < 6; ++i) {
            const bool in_square = i > 0 && i < 5 && j > 0 && j < 5;
            EXPECT_EQ(image.getchannel(i, j, 0, 0), in_square ? 1.0f : 0.0f);
            EXPECT_NEAR(image.getchannel(i, j, 0, 1), in_square ? i - 0.5 + 10 * (j - 0.5) : 0,
                        1e-4);
            EXPECT_TRUE(image.getchannel(i, j, 0, 2) >= 0 && image.getchannel(i, j, 0, 2) <= 4);
        }
}

TEST(ScatterOfAMesh, LeavesOutTrianglesWithACornerThatHasNoNumber) {
    // Two squares side by side; the first's lower left corner has no z.
    const std::string header = "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\n"
                               "property float y\nproperty float z\nelement face 2\n"
                               "property list uchar int vertex_indices\nend_header\n";
    const std::string vertices = "0 0 nan\n1 0 2\n2 0 3\n0 1 4\n1 1 5\n2 1 6\n";
    const std::string in = write_file("squares.ply", header + vertices + "4 0 1 4 3\n4 1 2 5 4\n"),
                      out = temporary("squares.exr");
    const Ran ran = run(make_scatter_command(), {in, out, "--size", "8x4", "--window", "0,0,2,1"});
    ASSERT_EQ(ran.code, exit_done) << ran.err;
    const OIIO::ImageBuf image = load(out);
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 8; ++i) {
            const float x = (float(i) + 0.5f) / 4, y = 1 - (float(j) + 0.5f) / 4;
            EXPECT_EQ(image.getchannel(i, j, 0, 0), i < 4 ? 0.0f : 1.0f);
            EXPECT_NEAR(image.getchannel(i, j, 0, 1), i < 4 ? 0 : 1 + x + 3 * y, 1e-5);
        }
    for (const auto& [faces, told] :
         {std::pair("3 0 1 4\n3 0 4 3\n", "no triangle has numbers at its three points"),
          std::pair("3 1 2 5\n3 1 5 99\n",
                    "wrong.ply\": face 1 has the vertex 99; there are 0 to 4")}) {
        const std::string wrong = write_file("wrong.ply", header + vertices + faces);
        const Ran failed = run(make_scatter_command(), {wrong, out});
        EXPECT_EQ(failed.code, exit_failed);
        EXPECT_NE(failed.err.find(told), std::string::npos) << failed.err;
    }
}

TEST(ScatterOfAMesh, VerticesThatNoTriangleUsesDoNotCount) {
    const auto image = [](const char* name, const std::string& last, const char* count) {
        const std::string in = write_file(
            std::string(name) + ".ply",
            std::string("ply\nformat ascii 1.0\nelement vertex ") + count +
                "\nproperty double x\nproperty double y\nproperty float z\nelement face 2\n"
                "property list uchar int vertex_indices\nend_header\n500000 5000000 1\n"
                "500000.002 5000000 2\n500000 5000000.002 3\n500000.002 5000000.002 4\n" +
                last + "3 0 1 2\n3 1 3 2\n");
        const std::string out = temporary(std::string(name) + ".exr");
        const Ran ran = run(make_scatter_command(), {in, out, "--size", "8x8"});
        EXPECT_EQ(ran.code, exit_done) << ran.err;
        EXPECT_EQ(run(make_mesh_command(), {in, temporary("again.ply")}).code, exit_done);
        return load(out);
    };
    const OIIO::ImageBuf wanted = image("square", "", "4"), far = image("far", "0 0 0\n", "5");
    const auto difference = OIIO::ImageBufAlgo::compare(far, wanted, 0, 0);
    EXPECT_EQ(difference.maxerror, 0);
    EXPECT_NEAR(wanted.getchannel(4, 4, 0, 1), 2.4f, 0.2f);
}

TEST(ScatterCommand, KeepsTheShapeOfAnyBox) {
    const std::string in = write_file("long.csv", "x,y,z\n0,0,1\n1,0,2\n1,20000,3\n0,20000,5\n");
    for (const auto& [size, width, height] :
         {std::tuple("0x1024", 1, 1024), std::tuple("3x0", 3, 60000)}) {
        const std::string out = temporary(std::string(size) + ".exr");
        ASSERT_EQ(run(make_scatter_command(), {in, out, "--size", size}).code, exit_done);
        EXPECT_EQ(load(out).spec().width, width);
        EXPECT_EQ(load(out).spec().height, height);
    }
}

TEST(ScatterCommand, SaysWhatIsWrong) {
    const std::string in = write_file("plane.csv", plane), out = temporary("wrong.exr");
    struct Case {
        std::vector<std::string> args;
        ExitCode code;
        const char* told;
    };
    for (const Case& c :
         {Case{{in, out, "--channels", "height"}, exit_usage, "there are z, weight"},
          Case{{in, out, "--channels", "z,weight,z"}, exit_usage, "\"Z\" would be two channels"},
          Case{{in, out, "--channels", "z,Z"}, exit_usage, "\"Z\" would be two channels"},
          Case{{write_file("a.csv", "x,y,A,alpha\n0,0,.2,1\n1,0,.2,2\n0,1,.2,3\n"), out},
               exit_failed,
               "\"A\" would be two channels"},
          Case{{write_file("twice.csv", "x,y,v,v\n0,0,1,1\n1,0,2,2\n0,1,3,3\n"), out},
               exit_failed,
               "\"v\" would be two channels"},
          Case{{write_file("huge.csv", "x,y,v\n0,0,1\n1,0,-1e39\n0,1,3\n"), out},
               exit_failed,
               "\"v\" has a value beyond the range of a float, -1e+39"},
          Case{{in, out, "--size", "12"}, exit_usage, "WxH"},
          Case{{in, out, "--size", "0x0"}, exit_usage, "WxH"},
          Case{{in, out, "--window", "0,0,1,20000"}, exit_usage, "1024 x 20480000 pixels"},
          Case{{in, out, "--size", "9000000x9000000"}, exit_resources, "9000000 x 9000000 pixels"},
          Case{{in, out, "--window", "1,1,0,0"}, exit_usage, "two corners"},
          Case{{in, out, "--window", "0,0,0,1"}, exit_usage, "two corners"},
          Case{{in, out, "--window", "0,0,1,0"}, exit_usage, "two corners"},
          Case{{in, out, "--filter", "ddt,cost=x"}, exit_usage, "abn, scf"},
          Case{{temporary("none.csv"), out}, exit_failed, "none.csv"},
          Case{{"/tmp", out}, exit_failed, "\"/tmp\": Is a directory"},
          Case{{write_file("line.csv", "x,y,z\n0,0,1\n1,1,2\n2,2,3\n"), out},
               exit_failed,
               "not on one line"},
          Case{{write_file("nan.csv", "x,y,z\n0,0,nan\n1,1,nan\n2,3,nan\n"), out},
               exit_failed,
               "no point has a number in z"},
          Case{{write_file("nans.csv", "x,y,u,v\n0,0,nan,1\n1,1,1,nan\n2,3,nan,1\n"), out},
               exit_failed,
               "no point has a number in u and in v"}}) {
        const Ran ran = run(make_scatter_command(), c.args);
        EXPECT_EQ(ran.code, c.code) << c.told;
        EXPECT_NE(ran.err.find(c.told), std::string::npos) << ran.err;
        EXPECT_FALSE(std::filesystem::exists(out));
    }
}

TEST(ScatterCommand, FitsItsChannelsToTheFormat) {
    const std::string in = write_file("grey.csv", "x,y,z\n0,0,.3\n1,0,.3\n0,1,.3\n1,1,.3\n");
    for (const char* name : {"grey.jpg", "grey.ppm", "grey.bmp"}) {
        const std::string out = temporary(name);
        const Ran ran = run(make_scatter_command(), {in, out, "--size", "16x16"});
        ASSERT_EQ(ran.code, exit_done) << ran.err;
        EXPECT_EQ(ran.err, "ddt: \"" + out + "\" has no room for A\n");
        const OIIO::ImageBuf image = load(out);
        for (int c = 0; c < image.nchannels(); ++c)
            EXPECT_NEAR(image.getchannel(8, 8, 0, c), 0.3f, 0.005f) << name;
    }
}

TEST(ScatterCommand, SaysWhatTheFormatMakesOfThem) {
    const std::string two = write_file("two.csv", "x,y,u,v\n0,0,.3,.1\n1,0,.3,.1\n0,1,.3,.1\n"),
                      high = write_file("high.csv", "x,y,z\n0,0,1\n1,0,2\n0,1,3\n"),
                      png = temporary("of_points.png"), exr = temporary("of_points.exr");
    const auto said = [](const std::string& in, const std::string& out) {
        const Ran ran = run(make_scatter_command(), {in, out, "--size", "4x4"});
        EXPECT_EQ(ran.code, exit_done);
        return ran.err;
    };
    EXPECT_EQ(said(two, png), "ddt: \"" + png + "\" has no room for A as alpha\n");
    EXPECT_EQ(said(two, exr), "");
    EXPECT_EQ(said(high, png), "ddt: \"" + png + "\" holds 0 to 1; what is beyond is cut off\n");
    EXPECT_EQ(said(high, exr), "");
}

TEST(ScatterCommand, SaysWhichPointsAreLeftOut) {
    const std::string square = "x,y,z\n0,0,1\n1,0,1\n0,1,1\n1,1,1\n", out = temporary("some.exr");
    const auto said = [&](const std::string& more) {
        const std::string in = write_file("some.csv", square + more);
        const Ran ran = run(make_scatter_command(), {in, out, "--size", "4x4"});
        EXPECT_EQ(ran.code, exit_done);
        return ran.err;
    };
    EXPECT_EQ(said(""), "");
    EXPECT_EQ(said("0,0,5\n"), "ddt: 1 of 5 points are left out: they lie where others do, or too "
                               "close to them beside what all span\n");
    EXPECT_EQ(said("5,5,nan\n"), "ddt: 1 of 5 points are left out: they have no number in z\n");
    EXPECT_EQ(said("0,1e12,1\n1e12,0,1\n").substr(0, 34), "ddt: 3 of 6 points are left out: t");
}

TEST(ScatterCommand, AnEmptyImageIsTold) {
    const std::string in = write_file("plane.csv", plane), out = temporary("empty.exr");
    const Ran beside =
        run(make_scatter_command(), {in, out, "--size", "8x8", "--window", "5,0,6,4"});
    EXPECT_EQ(beside.code, exit_done);
    EXPECT_EQ(beside.err, "ddt: \"" + out +
                              "\" is empty: no pixel lies on a triangle; they span "
                              "0,0,4,4\n");
    EXPECT_EQ(run(make_scatter_command(), {in, out, "--size", "8x8", "--window", "3,3,9,9"}).err,
              "");
}

TEST(ScatterCommand, AnAxisThatSpansTooLittleIsTold) {
    const auto said = [&](double x, double y) {
        std::ostringstream text;
        text << "x,y,z\n0,0,1\n" << x << ",0,1\n0," << y << ",1\n" << x << ',' << y << ",1\n";
        const std::string in = write_file("axes.csv", text.str()), out = temporary("axes.exr"),
                          mesh = temporary("axes.ply");
        const Ran ran = run(make_scatter_command(), {in, out, "--size", "4x4", "--mesh", mesh});
        EXPECT_EQ(ran.code, exit_done) << ran.err;
        EXPECT_EQ(run(make_mesh_command(), {mesh, mesh}).err, ran.err);
        return ran.err;
    };
    EXPECT_EQ(said(8192, 1), "");
    EXPECT_EQ(said(1, 8192), "");
    EXPECT_EQ(said(1e9, 10), "ddt: x spans 1e+09 and y 10: along y only 11 positions are told "
                             "apart; have both span about as much\n");
    EXPECT_EQ(said(1, 16384), "ddt: x spans 1 and y 16384: along x only 32769 positions are told "
                              "apart; have both span about as much\n");
}

TEST(ScatterOfAMesh, BringsThePictureBack) {
    OIIO::ImageSpec spec(3, 2, 4, OIIO::TypeUInt8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    OIIO::ImageBuf image(spec);
    for (int i = 0; i < 6; ++i) {
        const float alpha = i < 2 ? 1.0f : 0.2f * float(i);
        const float pixel[4] = {alpha * 0.9f, alpha * 0.1f * float(i), alpha * 0.4f, alpha};
        image.setpixel(i % 3, i / 3, pixel);
    }
    const std::string in = temporary("associated.png"), ply = temporary("associated.ply");
    ASSERT_TRUE(image.write(in));
    ASSERT_EQ(run(make_mesh_command(), {in, ply}).code, exit_done);
    const auto scatter = [&](const std::string& out) {
        const Ran ran = run(make_scatter_command(),
                            {ply, out, "--size", "3x2", "--window", "-0.5,-0.5,2.5,1.5"});
        EXPECT_EQ(ran.code, exit_done) << ran.err;
        return load(out);
    };
    const OIIO::ImageBuf wanted = load(in), back = scatter(temporary("back.png"));
    const auto difference = OIIO::ImageBufAlgo::compare(back, wanted, 0.01f, 0.01f);
    EXPECT_EQ(difference.nfail, 0u) << difference.maxerror;
    // The same picture in linear light, which files of EXR are.
    const OIIO::ImageBuf exr = scatter(temporary("back.exr"));
    ASSERT_EQ(exr.spec().channelnames, (std::vector<std::string>{"R", "G", "B", "A"}));
    for (int i = 0; i < 6; ++i)
        for (int c = 0; c < 4; ++c) {
            const float alpha = wanted.getchannel(i % 3, i / 3, 0, 3);
            const float v = wanted.getchannel(i % 3, i / 3, 0, c) / alpha;
            const float light = v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
            EXPECT_NEAR(exr.getchannel(i % 3, i / 3, 0, c), c == 3 ? alpha : alpha * light, 0.02)
                << i << " " << c;
        }
}

TEST(ScatterCommand, ReplacesBothFilesOrNone) {
    const std::string in = write_file("plane.csv", plane), full = temporary("full.ply");
    std::filesystem::create_symlink("/dev/full", full);
    const std::string out = write_file("both.png", "before");
    for (const std::string& mesh : {std::string("/no/such/folder/a.ply"), full}) {
        const Ran ran = run(make_scatter_command(), {in, out, "--size", "4x4", "--mesh", mesh});
        EXPECT_EQ(ran.code, mesh == full ? exit_resources : exit_failed) << ran.err;
        EXPECT_NE(ran.err.find(mesh), std::string::npos) << ran.err;
        EXPECT_EQ(text_in(out), "before");
    }
    const std::string mesh = write_file("both.ply", "before");
    EXPECT_EQ(run(make_scatter_command(), {in, "/no/such/folder/a.png", "--mesh", mesh}).code,
              exit_failed);
    EXPECT_EQ(text_in(mesh), "before");
}

} // namespace
} // namespace ddt::tool
