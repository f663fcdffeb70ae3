// SPDX-License-Identifier: Apache-2.0
#include "core/base/log.h"

#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "ddt/core.h"
#include "ddt/points.h"
#include "tests/environment.h"

namespace ddt {
namespace {

TEST(Log, IsAnythingSetThatDoesNotBeginWithZero) {
    const Environment unset("DDT_VERBOSE", std::nullopt);
    EXPECT_FALSE(verbose());
    for (const char* no : {"", "0", "00"}) {
        const Environment set("DDT_VERBOSE", no);
        EXPECT_FALSE(verbose()) << no;
    }
    for (const char* yes : {"1", "2", "yes"}) {
        const Environment set("DDT_VERBOSE", yes);
        EXPECT_TRUE(verbose()) << yes;
    }
}

TEST(Log, ACallbackTakesTheLines) {
    const Environment unset("DDT_VERBOSE", std::nullopt);
    std::vector<std::string> lines;
    set_log([&](const char* line) { lines.emplace_back(line); });
    EXPECT_TRUE(verbose());
    say("ddt: %d of %s", 3, "them");
    std::vector<float> pixels(4 * 4, 0.5f), out(8 * 8);
    EXPECT_EQ(enlarge(pixels.data(), 4, 4, 1, nullptr, out.data(), 8, 8), Outcome::done);
    say("ddt: %s failed", "a\ndriver\n");
    set_log({});
    say("ddt: nobody listens");
    EXPECT_FALSE(verbose());
    ASSERT_GE(lines.size(), 3u);
    EXPECT_EQ(lines[0], "ddt: 3 of them");
    EXPECT_EQ(lines[lines.size() - 2].rfind("ddt: device ", 0), 0u) << lines[lines.size() - 2];
    EXPECT_EQ(lines.back(), "ddt: a driver failed");
}

/// The lines that tell where `work` was done.
template <class Work>
std::vector<std::string> places_told(Work&& work) {
    std::vector<std::string> lines;
    set_log([&](const char* line) {
        if (std::string(line).rfind("ddt: device ", 0) == 0)
            lines.emplace_back(line);
    });
    work();
    set_log({});
    return lines;
}

TEST(Log, MeshesOfPointsAreToldOf) {
    PointMesh mesh{{0, 4, 0, 4, 1}, {0, 0, 4, 4, 2}, {}};
    const float guide[] = {0, 1, 0, 1, 0.5f};
    ASSERT_TRUE(delaunay(mesh));
    const auto lines = places_told([&] { EXPECT_TRUE(optimise(mesh, guide, MeshOptions())); });
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].rfind("ddt: device cpu; 5 points, ", 0), 0u) << lines[0];
}

TEST(Log, FilledHolesAreToldOfInOneLine) {
    constexpr int side = 200; // of which two holes far apart have meshes of their own
    std::vector<float> image(side * side, 0.5f), guide = image;
    std::vector<uint8_t> missing(side * side, 0);
    missing[2 * side + 2] = missing[180 * side + 180] = missing[180 * side + 181] = 1;
    const auto fill = [&] {
        return fill_holes(image.data(), side, side, 1, nullptr, guide.data(), missing.data(),
                          MeshOptions());
    };
    const auto lines = places_told([&] { EXPECT_TRUE(fill()); });
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].rfind("ddt: device cpu; 3 missing pixels, ", 0), 0u) << lines[0];
    missing.assign(missing.size(), 0);
    EXPECT_TRUE(places_told([&] { EXPECT_TRUE(fill()); }).empty());
}

TEST(Log, WhatACallbackThrowsIsDropped) {
    int calls = 0;
    set_log([&](const char*) {
        ++calls;
        throw 1;
    });
    say("ddt: a line");
    set_log({});
    EXPECT_EQ(calls, 1);
}

} // namespace
} // namespace ddt
