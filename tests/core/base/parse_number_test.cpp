// SPDX-License-Identifier: Apache-2.0
#include "core/base/parse_number.h"

#include <gtest/gtest.h>

namespace ddt {
namespace {

TEST(ParseNumber, ASizeIsTwoWholeNumbersAndNothingElse) {
    int width = 0, height = 0;
    EXPECT_TRUE(parse_sides("48x32", 2, 100, width, height));
    EXPECT_EQ(width, 48);
    EXPECT_EQ(height, 32);
    for (const char* text :
         {"", "48", "x32", "48x", "48x32x", "48x32junk", "4.5x32", "48 x32", "1x32", "48x101"})
        EXPECT_FALSE(parse_sides(text, 2, 100, width, height)) << text;
    EXPECT_EQ(width, 48);
    EXPECT_EQ(height, 32);
}

} // namespace
} // namespace ddt
