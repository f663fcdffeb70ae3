// SPDX-License-Identifier: Apache-2.0
#include "core/tin/step_grid.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace ddt::test {
namespace {

TEST(StepGrid, ThePointsSpanHalfOfTheStepsThereAreOrMore) {
    for (const double extent : {1.0, 1.0000001, 1.9999999, 2.0, 3.0, 1e-30, 1e30})
        for (const bool turned : {false, true}) {
            const std::vector<double> along{-0.25 * extent, 0.75 * extent}, across{0, 0.1 * extent};
            StepGrid grid;
            std::string error;
            ASSERT_TRUE(grid.fit(turned ? across : along, turned ? along : across, error)) << error;
            const double x = turned ? 0.1 * extent : 0.75 * extent,
                         y = turned ? 0.75 * extent : 0.1 * extent;
            const Steps last = grid.steps(x, y);
            EXPECT_GE(std::max(last.x, last.y), most_steps / 2) << extent;
            EXPECT_LE(std::max(last.x, last.y), most_steps) << extent;
        }
}

} // namespace
} // namespace ddt::test
