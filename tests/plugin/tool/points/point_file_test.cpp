// SPDX-License-Identifier: Apache-2.0
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <future>
#include <thread>

#include <fcntl.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "plugin/tool/commands.h"
#include "plugin/tool/points/point_file.h"
#include "plugin/tool/points/write_points.h"
#include "tests/plugin/tool/points/point_texts.h"
#include "tests/plugin/tool/run_command.h"
#include "tests/temporary.h"

namespace ddt::tool {
namespace {

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

TEST(PointFile, WhatIsWrittenReadsTheSame) {
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

TEST(PointFile, WholeNumbersAreTheNearestThatTheirTypeHolds) {
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

TEST(PointFile, FaultsNameTheFileAndTheFace) {
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

TEST(PointFile, PlyIsKnownByItsFirstLine) {
    PointFile points;
    Failure failure;
    const std::string text = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                             "property float y\nend_header\n3 4\n";
    ASSERT_TRUE(read_points(write_file("stdin", text), points, failure)) << failure.why;
    EXPECT_EQ(points.mesh.y, std::vector<double>{4});
    ASSERT_TRUE(read_points(write_file("ply.txt", "ply x y\n1 2 3\n"), points, failure));
    EXPECT_EQ(points.columns[0].name, "ply");
}

TEST(PointFile, DevicesWithoutAnEndAreRefused) {
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

/// What is read of a path. An attempt that does not end by itself is ended by `release`, without
/// the points: it is their absence that fails, not the time.
template <class Release>
PointFile points_in_time(const std::string& path, Release&& release) {
    PointFile points;
    Failure failure;
    auto reading =
        std::async(std::launch::async, read_points, path, std::ref(points), std::ref(failure));
    if (reading.wait_for(std::chrono::seconds(60)) != std::future_status::ready)
        release();
    EXPECT_TRUE(reading.get()) << failure.why;
    return points;
}

const char* const two_points = "x,y,z\n1,2,3\n4,5,6\n";

TEST(PointFile, ComesFromAPipeToo) {
    const std::string pipe = temporary("points.csv");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    std::atomic<bool> done{false};
    std::thread writer([&] {
        int end = -1;
        while (!done && end < 0) { // until there is a reader
            end = open(pipe.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        if (end < 0)
            return;
        EXPECT_EQ(write(end, two_points, std::strlen(two_points)),
                  ssize_t(std::strlen(two_points)));
        close(end);
    });
    const PointFile points =
        points_in_time(pipe, [&] { close(open(pipe.c_str(), O_RDWR | O_CLOEXEC)); });
    done = true;
    writer.join();
    EXPECT_EQ(points.mesh.y, (std::vector<double>{2, 5}));
}

TEST(PointFile, ComesFromATerminalToo) {
    int keyboard = posix_openpt(O_RDWR | O_NOCTTY);
    if (keyboard < 0 || grantpt(keyboard) != 0 || unlockpt(keyboard) != 0)
        GTEST_SKIP() << "there are no terminals here";
    const std::string terminal = ptsname(keyboard);
    const int held = open(terminal.c_str(), O_RDWR | O_NOCTTY); // or what is typed gets lost
    ASSERT_GE(held, 0);
    const std::string typed = std::string(two_points) + "\x04"; // the end of what is typed
    ASSERT_EQ(write(keyboard, typed.data(), typed.size()), ssize_t(typed.size()));
    const PointFile points = points_in_time(terminal, [&] {
        close(keyboard);
        keyboard = -1;
    });
    EXPECT_EQ(points.mesh.y, (std::vector<double>{2, 5}));
    close(held);
    close(keyboard);
}

} // namespace
} // namespace ddt::tool
