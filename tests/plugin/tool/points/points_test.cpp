// SPDX-License-Identifier: Apache-2.0
// The commands on points: scatter, fill, mesh of a mesh; and the files they read.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <thread>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/strutil.h>
#include <gtest/gtest.h>

#include "plugin/tool/commands.h"
#include "plugin/tool/file/open_image.h"
#include "plugin/tool/points/point_file.h"
#include "plugin/tool/points/write_points.h"
#include "tests/plugin/tool/run_command.h"
#include "tests/temporary.h"

namespace ddt::tool {
namespace {

std::string write_file(const std::string& name, const std::string& text) {
    const std::string path = temporary(name);
    std::ofstream(path, std::ios::binary) << text;
    return path;
}

OIIO::ImageBuf load(const std::string& path) {
    OIIO::ImageBuf image;
    std::string error;
    EXPECT_TRUE(open_image(path, image, error)) << error;
    return image;
}

std::string table_error(const std::string& text) {
    PointFile points;
    std::string error;
    EXPECT_FALSE(read_table(text, points, error));
    return error;
}

TEST(PointTable, SeparatorsAndComments) {
    for (const char* text :
         {"x,y,z\n1,2,3\n4,5,6\n", "//X Y Z\n1 2 3\n//4 4 4\n4 5 6\n", "x,y,z,\n1,2,3,\n4,5,6,\n",
          "x;y;z;;\r\n1;2;3; ;\r\n4;5;6;;\r\n", "# X Y Z\n1 2 3\n\n# more\n4\t5  6\n",
          "x;y;z\r\n1;2;3\r\n4;5;6", "x,y,z\r1,2,3\r4,5,6\r",
          "# of 2010, by hand; more\n#\nx,y,z\n1,2,3\n#\n4,5,6\n",
          "\"z\", \"x\",\"y\"\n3, 1, 2\n6,4,5\n", "\xEF\xBB\xBFx,y,z\n1,2,3\n4,5,6\n"}) {
        PointFile points;
        std::string error;
        ASSERT_TRUE(read_table(text, points, error)) << error;
        EXPECT_EQ(points.mesh.x, (std::vector<double>{1, 4}));
        EXPECT_EQ(points.mesh.y, (std::vector<double>{2, 5}));
        ASSERT_EQ(points.columns.size(), 1u);
        EXPECT_EQ(points.columns[0].name, "z");
        EXPECT_EQ(points.columns[0].values, (std::vector<double>{3, 6}));
    }
}

TEST(PointTable, EmptyCellsAreNoNumbers) {
    PointFile points;
    std::string error;
    ASSERT_TRUE(read_table("x,y,z,,red,green,blue,\n9,1,,7,255,0,0,\n5,6,7,,,,,\n", points, error))
        << error;
    EXPECT_EQ(points.mesh.x, (std::vector<double>{9, 5}));
    ASSERT_EQ(points.columns.size(), 5u); // a column of numbers without a name is one
    EXPECT_TRUE(std::isnan(points.columns[0].values[0]));
    EXPECT_EQ(points.columns[0].values[1], 7);
    EXPECT_EQ(points.columns[1].values[0], 7);
    EXPECT_EQ(points.columns[2].scale, 255);
    for (size_t k = 1; k < 5; ++k)
        EXPECT_TRUE(std::isnan(points.columns[k].values[1])) << k;
    EXPECT_EQ(table_error("x,y,z\n,1,2\n"), "line 2: \"\" is no number");
    EXPECT_EQ(table_error("x,y,z\n1,2,3,\n"), "line 2: there are 4 columns, not 3");
}

TEST(PointTable, SaysWhichLineIsWrong) {
    EXPECT_EQ(table_error("1,2,3\n"),
              "line 1: the first line must name the columns, x and y among them");
    EXPECT_EQ(table_error("x,y,z\n1,2,3\n1,2\n"), "line 3: there are 2 columns, not 3");
    EXPECT_EQ(table_error("x,y,z\n1,2,three\n"), "line 2: \"three\" is no number");
    EXPECT_EQ(table_error(std::string("x,y,z\n1,2,3\0 4\n", 14)).substr(0, 8), "line 2: ");
    EXPECT_EQ(table_error("x;y;z\n0,5;1;2\n"), "line 2: \"0,5\" is no number");
    EXPECT_EQ(table_error("# a,b\n1,2,3\n"),
              "line 2: the first line must name the columns, x and y among them");
    EXPECT_EQ(table_error("x,y,z\n1,2,3\n\n1,nan,3\n"), "line 4: a position that is not finite");
    EXPECT_EQ(table_error("x,y,z\ninf,2,3\n"), "line 2: a position that is not finite");
    EXPECT_EQ(table_error("x,y,z\n"), "there are no points");
    EXPECT_EQ(table_error(""), "there are no points");
}

TEST(PointTable, WholeNumberColoursAreBytes) {
    PointFile points;
    std::string error;
    const auto read = [&](const std::string& text) {
        EXPECT_TRUE(read_table("x,y,red,green,blue,alpha\n" + text, points, error)) << error;
    };
    read("0,0,255,0,1,1\n1,0,51,0,nan,0.5\n");
    EXPECT_EQ(points.find("red")->values, (std::vector<double>{1, 0.2}));
    EXPECT_EQ(points.find("blue")->values[0], 1.0 / 255);
    EXPECT_EQ(points.find("blue")->scale, 255);
    EXPECT_EQ(points.find("alpha")->values, (std::vector<double>{1, 0.5}));
    read("0,0,255,0,0,255\n1,0,51,0,0,51\n");
    EXPECT_EQ(points.find("alpha")->values, (std::vector<double>{1, 0.2}));
    for (const char* other :
         {"0,0,1,0,1,1\n", "0,0,2,0.5,0,1\n", "0,0,256,0,0,1\n", "0,0,-1,2,0,1\n"}) {
        read(other);
        for (const char* name : {"red", "green", "blue", "alpha"})
            EXPECT_EQ(points.find(name)->scale, 1) << other << name;
    }
}

TEST(PointTable, ColoursMayBeCalledByTheirLetters) {
    const auto names = [](const std::string& line) {
        PointFile points;
        std::string error;
        const auto columns = std::count(line.begin(), line.end(), ',');
        std::string numbers = "255";
        for (int i = 0; i < columns; ++i)
            numbers += ",255";
        EXPECT_TRUE(read_table(line + "\n" + numbers, points, error)) << error;
        std::string all;
        for (const Column& column : points.columns)
            all += column.name + (column.scale == 255 ? "! " : " ");
        return all;
    };
    EXPECT_EQ(names("X,Y,R,G,B"), "red! green! blue! ");
    EXPECT_EQ(names("a,b,g,r,y,x"), "alpha! blue! green! red! ");
    EXPECT_EQ(names("x,y,Red,GREEN,blue,Alpha"), "red! green! blue! alpha! ");
    EXPECT_EQ(names("x,y,A,z"), "alpha! z ");
    EXPECT_EQ(names("x,y,A,alpha"), "A alpha! ");
    // Letters that stand for something else, and names that mean nothing.
    EXPECT_EQ(names("x,y,R,Theta,a"), "R Theta a ");
    EXPECT_EQ(names("x,y,r,g,b,red"), "r g b red! ");
}

TEST(PointFile, ColumnsAreFoundAsTheyAreMeant) {
    PointFile points;
    for (const char* name : {"red", "temp", "Temp", "alpha"})
        points.columns.push_back({name, "float", 1, {}});
    for (const auto& [meant, name] : {std::pair("Temp", "Temp"),
                                      {"TEMP", "temp"},
                                      {"R", "red"},
                                      {"a", "alpha"},
                                      {"Alpha", "alpha"}})
        EXPECT_EQ(points.find_meant(meant)->name, name) << meant;
    EXPECT_EQ(points.find_meant("G"), nullptr);
    EXPECT_EQ(points.find("R"), nullptr);
}

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

/// A mesh of one face after a triangle far below it, as text.
std::string with_face(const std::string& vertices, const std::string& face) {
    const auto count = std::count(vertices.begin(), vertices.end(), '\n');
    return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(count + 3) +
           "\nproperty double x\nproperty double y\nproperty float z\nelement face 2\n"
           "property list uchar int vertex_indices\nend_header\n" +
           vertices + "0 -9 0\n1 -9 0\n0 -8 0\n3 " + std::to_string(count) + ' ' +
           std::to_string(count + 1) + ' ' + std::to_string(count + 2) + '\n' + face + '\n';
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

TEST(Ply, FaultsNameTheFileAndTheFace) {
    const std::string out = temporary("fault.exr");
    for (const auto& [corners, face, fault] :
         {std::tuple("0 0 0\n4 0 0\n4 4 0\n0 4 0\n", "4 0 2 1 3", // crosses itself
                     "face 1 lies over another at one of its edges"),
          std::tuple("0 0 0\n1 0 0\n2 0 0\n3 0 0\n", "4 0 1 2 3",
                     "face 1 has no area, or too little beside what all span")}) {
        const std::string in = write_file("fault.ply", with_face(corners, face)),
                          told = "ddt: \"" + in + "\": " + fault + "\n";
        EXPECT_EQ(run(make_scatter_command(), {in, out}).err, told);
        EXPECT_EQ(run(make_mesh_command(), {in, temporary("out.ply")}).err, told);
    }
}

TEST(Ply, WhatIsWrittenReadsTheSame) {
    PointFile points;
    points.mesh = {{0.1, 5, 3}, {0, 1e-9, 7}, {{0, 1, 2}}};
    points.columns = {{"z", "float", 1, {1.5f, -2, 3}}, {"red", "uchar", 255, {0, 0.2, 1}}};
    const double most = 4294967295;
    points.columns.push_back({"id", "uint", 1, {16777217, most, 0}});
    points.columns.push_back({"key", "int", 1, {-2147483648.0, 16777217, -1}});
    points.columns.push_back({"exact", "double", 1, {0.1, 1e300, -1e-300}});
    points.columns.push_back({"small", "char", 1, {-128, 127, -1}});
    points.columns.push_back({"short", "short", 1, {-32768, 32767, -1}});
    points.columns.push_back({"words", "ushort", 1, {0, 65535, 1}});
    const std::string path = temporary("written.ply");
    Failure failure;
    ASSERT_TRUE(write_points(path, points, failure)) << failure.why;
    PointFile again;
    ASSERT_TRUE(read_points(path, again, failure)) << failure.why;
    EXPECT_EQ(again.mesh.x, points.mesh.x);
    EXPECT_EQ(again.mesh.y, points.mesh.y);
    EXPECT_EQ(again.mesh.triangles, points.mesh.triangles);
    ASSERT_EQ(again.columns.size(), points.columns.size());
    for (size_t k = 0; k < points.columns.size(); ++k) {
        EXPECT_EQ(again.columns[k].type, points.columns[k].type);
        EXPECT_EQ(again.columns[k].name, points.columns[k].name);
        EXPECT_EQ(again.columns[k].values, points.columns[k].values);
    }
}

TEST(Ply, WholeNumbersAreTheNearestThatTheirTypeHolds) {
    PointFile points;
    points.mesh.x = {0, 1, 2, 3, 4};
    points.mesh.y = {0, 0, 0, 0, 0};
    points.columns = {{"a", "char", 1, {-1000, -1.6, 1.4, 1.6, 1000}},
                      {"b", "ushort", 1, {-1, NAN, 0.5, 65534.6, 1e9}},
                      {"c", "int", 1, {-1e300, -0.6, 0.4, 2147483646.6, 1e300}}};
    const std::string path = temporary("rounded.ply");
    Failure failure;
    ASSERT_TRUE(write_points(path, points, failure)) << failure.why;
    PointFile again;
    ASSERT_TRUE(read_points(path, again, failure)) << failure.why;
    using Values = std::vector<double>;
    EXPECT_EQ(again.find("a")->values, (Values{-128, -2, 1, 2, 127}));
    EXPECT_EQ(again.find("b")->values, (Values{0, 0, 1, 65535, 65535}));
    EXPECT_EQ(again.find("c")->values, (Values{-2147483648.0, -1, 0, 2147483647, 2147483647}));
}

TEST(PointFile, GuidesAreNumbersWhateverTheValuesAre) {
    PointFile points;
    points.mesh = {{0, 1, 0}, {0, 0, 1}, {}};
    for (const std::vector<double>& values :
         {std::vector<double>{-1.7e308, 1.7e308, 0}, {0, 5e-324, 0}, {-3e38, 3e38, 0}}) {
        const Column column{"z", "double", 1, values};
        for (const float v : guide_of(points, {&column}))
            EXPECT_TRUE(v >= 0 && v <= 1) << v;
    }
}

TEST(PointFile, GuidesAreOfAllColumns) {
    PointFile points;
    points.mesh = {{0, 1, 0, 1}, {0, 0, 1, 1}, {}};
    const Column x{"nx", "float", 1, {0, 0, 0, 0}}, y{"ny", "float", 1, {1, 1, 1, 1}},
        z{"nz", "float", 1, {0, 0, 0.25, 0}}, quality{"quality", "float", 1, {0, 1000, 0, NAN}},
        alpha{"alpha", "float", 1, {0, 0, 0, 9}};
    using Guide = std::vector<float>;
    EXPECT_EQ(guide_of(points, {&x, &y, &z, &quality}), (Guide{0, 1, 1, 0}));
    // Up to three are taken as they are, and alpha is none of them.
    EXPECT_EQ(guide_of(points, {&x, &y, &z, &alpha}), (Guide{0, 0, 1, 0}));
    EXPECT_EQ(guide_of(points, {&y, &z, &quality}), (Guide{0, 1, 0.25f / 1000, 0}));
}

/// A square of 4 x 4 with z = x + 10 y in its corners and middle, as text.
const char* const plane = "x,y,z,weight\n0,0,0,1\n4,0,4,2\n0,4,40,3\n4,4,44,4\n2,2,22,nan\n";

TEST(OnPoints, ScatterMakesAnImage) {
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

TEST(OnPoints, ScatterTakesColoursByTheirLetters) {
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

TEST(OnPoints, ScatterLeavesTheOutsideEmptyAndPointsWithoutNumbersOut) {
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

TEST(OnPoints, ScatterKeepsTheShapeOfAnyBox) {
    const std::string in = write_file("long.csv", "x,y,z\n0,0,1\n1,0,2\n1,20000,3\n0,20000,5\n");
    for (const auto& [size, width, height] :
         {std::tuple("0x1024", 1, 1024), std::tuple("3x0", 3, 60000)}) {
        const std::string out = temporary(std::string(size) + ".exr");
        ASSERT_EQ(run(make_scatter_command(), {in, out, "--size", size}).code, exit_done);
        EXPECT_EQ(load(out).spec().width, width);
        EXPECT_EQ(load(out).spec().height, height);
    }
}

TEST(OnPoints, ScatterSaysWhatIsWrong) {
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

TEST(OnPoints, ScatterFitsItsChannelsToTheFormat) {
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

TEST(OnPoints, ScatterSaysWhatTheFormatMakesOfThem) {
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

TEST(OnPoints, ScatterSaysWhichPointsAreLeftOut) {
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

TEST(OnPoints, AnEmptyImageIsTold) {
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

TEST(OnPoints, AnAxisThatSpansTooLittleIsTold) {
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

TEST(OnPoints, PlyIsKnownByItsFirstLine) {
    PointFile points;
    Failure failure;
    const std::string text = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                             "property float y\nend_header\n3 4\n";
    ASSERT_TRUE(read_points(write_file("stdin", text), points, failure)) << failure.why;
    EXPECT_EQ(points.mesh.y, std::vector<double>{4});
    ASSERT_TRUE(read_points(write_file("ply.txt", "ply x y\n1 2 3\n"), points, failure));
    EXPECT_EQ(points.columns[0].name, "ply");
}

TEST(OnPoints, DevicesWithoutAnEndAreRefused) {
    const std::string zero = temporary("zero.ply");
    std::filesystem::create_symlink("/dev/zero", zero);
    for (const bool mesh : {false, true}) {
        const Ran ran = run(mesh ? make_mesh_command() : make_scatter_command(),
                            {zero, temporary(mesh ? "zero_mesh.ply" : "zero.exr")});
        EXPECT_EQ(ran.code, exit_failed);
        EXPECT_EQ(ran.err, "ddt: \"" + zero +
                               "\": it is a device; allowed are files, pipes and terminals\n");
    }
}

TEST(OnPoints, ComeFromPipesAndTerminalsToo) {
    const std::string text = "x,y,z\n1,2,3\n", pipe = temporary("points.csv");
    PointFile points;
    Failure failure;
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    std::thread writer([&] { std::ofstream(pipe) << text; });
    EXPECT_TRUE(read_points(pipe, points, failure)) << failure.why;
    writer.join();
    EXPECT_EQ(points.mesh.y, std::vector<double>{2});

    const int keyboard = posix_openpt(O_RDWR | O_NOCTTY);
    if (keyboard < 0 || grantpt(keyboard) != 0 || unlockpt(keyboard) != 0)
        GTEST_SKIP() << "there are no terminals here";
    const std::string terminal = ptsname(keyboard);
    const int held = open(terminal.c_str(), O_RDWR | O_NOCTTY); // or what is typed gets lost
    ASSERT_GE(held, 0);
    const std::string typed = text + "\x04"; // the end of what is typed
    ASSERT_EQ(write(keyboard, typed.data(), typed.size()), ssize_t(typed.size()));
    EXPECT_TRUE(read_points(terminal, points, failure)) << failure.why;
    EXPECT_EQ(points.mesh.y, std::vector<double>{2});
    close(held);
    close(keyboard);
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

TEST(OnPoints, ScatterReplacesBothFilesOrNone) {
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

TEST(OnPoints, FillFillsWhatIsMissingAndNothingElse) {
    OIIO::ImageBuf image(OIIO::ImageSpec(12, 9, 4, OIIO::TypeFloat));
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 12; ++x) {
            const float plain[4] = {0.05f * float(x), 0.1f * float(y), 0.5f, 1};
            image.setpixel(x, y, plain);
        }
    const OIIO::ImageBuf whole = image;
    const float hole[4] = {nan, nan, nan, nan}, clear[4] = {0, 0, 0, 0};
    const float lacks_red[4] = {nan, 0.3f, 0.7f, 1};
    for (int x = 4; x < 7; ++x)
        image.setpixel(x, 4, hole);
    image.setpixel(2, 2, lacks_red);
    image.setpixel(9, 6, clear);
    const std::string in = temporary("holes.exr"), out = temporary("filled.exr");
    ASSERT_TRUE(image.write(in));
    for (const bool alpha : {false, true}) {
        const Ran ran = run(make_fill_command(), {in, out, "--missing", alpha ? "alpha" : "nan"});
        ASSERT_EQ(ran.code, exit_done) << ran.err;
        const OIIO::ImageBuf filled = load(out);
        for (int y = 0; y < 9; ++y)
            for (int x = 0; x < 12; ++x)
                for (int c = 0; c < 4; ++c) {
                    const bool was_clear = x == 9 && y == 6, lacked = x == 2 && y == 2;
                    const float wanted = was_clear && !alpha ? 0.0f
                                         : lacked && c > 0   ? lacks_red[c]
                                                             : whole.getchannel(x, y, 0, c);
                    EXPECT_NEAR(filled.getchannel(x, y, 0, c), wanted, 1e-6) << x << " " << y;
                }
    }
}

} // namespace
} // namespace ddt::tool
