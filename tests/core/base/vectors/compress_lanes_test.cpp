// SPDX-License-Identifier: Apache-2.0
#include "core/base/vectors/compress_lanes.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace ddt::test {
namespace {

TEST(CompressLanes, AreThoseOfTheMaskThenTheOthers) {
    for (int mask = 0; mask < 256; ++mask) {
        const uint8_t* of = compress_lanes.of[mask];
        const auto is_set = [&](uint8_t lane) { return (mask >> lane & 1) != 0; };
        const auto* others = std::find_if_not(of, of + 8, is_set);
        EXPECT_TRUE(std::none_of(others, of + 8, is_set)) << mask;
        EXPECT_TRUE(std::is_sorted(of, others)) << mask;
        int all = 0;
        for (int k = 0; k < 8; ++k)
            all |= 1 << of[k];
        EXPECT_EQ(all, 255) << mask;
    }
}

} // namespace
} // namespace ddt::test
