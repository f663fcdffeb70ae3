// SPDX-License-Identifier: Apache-2.0
#include "core/base/log.h"

#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "ddt/core.h"
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
