// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/resize/size.h"

#include <gtest/gtest.h>

namespace ddt::tool {
namespace {

struct Case {
    const char* text;
    int width, height, x, y;
};

TEST(Size, IsWhatOiiotoolMakesOfIt) {
    const Size from{200, 150, 3, -4};
    for (const Case& c : {Case{"640x480", 640, 480, 3, -4}, Case{"0x300", 400, 300, 3, -4},
                          Case{"100x0", 100, 75, 3, -4}, Case{"64x48+10-20", 64, 48, 10, -20},
                          Case{"64x48-1+2", 64, 48, -1, 2}, Case{"50%", 100, 75, 3, -4},
                          Case{"33.3%", 67, 50, 3, -4}, Case{"50%x200%", 100, 300, 3, -4},
                          Case{"0%x200%", 400, 300, 3, -4}, Case{"50%x0%", 100, 75, 3, -4},
                          Case{"2.5", 500, 375, 3, -4}, Case{"3", 600, 450, 3, -4}}) {
        Size to;
        ASSERT_TRUE(parse_size(c.text, from, to)) << c.text;
        EXPECT_EQ(to.width, c.width) << c.text;
        EXPECT_EQ(to.height, c.height) << c.text;
        EXPECT_EQ(to.x, c.x) << c.text;
        EXPECT_EQ(to.y, c.y) << c.text;
    }
}

TEST(Size, AnythingElseIsRefused) {
    for (const char* text :
         {"",         "x",          "64x", "x48",  "64X48",       "0x0",  "-4x3",       "64x48+1",
          "64x48+1+", "64x48+1+2 ", " 2",  "0",    "-1",          "0%",   "-50%",       "50%x",
          "50%x20",   "nan",        "inf", "1e30", "100000000x1", "50 %", "64x48+-1+2", "2,3"}) {
        Size to{1, 2, 3, 4};
        EXPECT_FALSE(parse_size(text, {200, 150, 0, 0}, to)) << text;
        EXPECT_EQ(to.width, 1);
    }
}

TEST(Size, AShapeThatIsKeptIsNotTooLarge) {
    Size to{1, 2, 3, 4};
    for (const char* text : {"0x2000000000", "2147483647x0", "0x16777216"})
        EXPECT_FALSE(parse_size(text, {200000, 1, 0, 0}, to)) << text;
    EXPECT_FALSE(parse_size("2000000x0", {1, 200000, 0, 0}, to));
    EXPECT_EQ(to.width, 1);
}

TEST(Size, IsOfSomeImage) {
    for (const char* text : {"640x480", "0x480", "64x48+10-20", "2000000%x100%", "20000", "0.04%",
                             "0.04%x1000000%", "16777216", "0.00001%"})
        EXPECT_TRUE(is_size(text)) << text;
    for (const char* text : {"", "large", "0", "-1", "16777220", "16777217x1", "0.000001%", "1e30",
                             "2147483648%", "nan"})
        EXPECT_FALSE(is_size(text)) << text;
}

TEST(Size, WhatIsAllowedIsToldWithItsBound) {
    for (const char* text : {"large", "100000000x3", "0x0", "0%"}) {
        const std::string said = wrong_size(text);
        EXPECT_EQ(said.find("size \"" + std::string(text) + "\" is not allowed"), 0u) << said;
        EXPECT_NE(said.find("WxH, "), std::string::npos) << said;
        EXPECT_NE(said.find(", 1 to 16777216 pixels a side"), std::string::npos) << said;
    }
}

} // namespace
} // namespace ddt::tool
