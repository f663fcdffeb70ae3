// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include <gtest/gtest.h>

#include "ddt/option_table.h"

namespace ddt::test {
namespace {

TEST(OptionText, NumbersAreTextsThatGiveThemBack) {
    EXPECT_EQ(number_text(0.07f), "0.07");
    EXPECT_EQ(number_text(1e6f), "1000000");
    EXPECT_EQ(number_text(0), "0");
    EXPECT_EQ(number_text(1.5e-5f), "1.5e-05");
    EXPECT_EQ(number_text(1e-40f), "subnormal");
    EXPECT_EQ(number_text(-1e-40f), "subnormal");
    EXPECT_EQ(number_text(std::numeric_limits<float>::min()), "1.1754944e-38");
}

} // namespace
} // namespace ddt::test
