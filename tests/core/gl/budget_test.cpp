// SPDX-License-Identifier: Apache-2.0
#include "core/gl/budget.h"

#include <gtest/gtest.h>

#include "core/gl/context/context.h"
#include "core/gl/context/failure.h"

namespace ddt::test {
namespace {

TEST(Budget, OneTileThatIsMoreThanIsTakenOfAGpuIsTheCpus) {
    auto& gpu = *new gl::Gpu; // none ends before its process
    gpu.context = std::make_unique<gl::Context>();
    gpu.block_limit = size_t(1) << 31;
    const gl::SlotShape shape = gl::shape_for({0, 0, 1000, 1000});
    SurfaceOptions surface;
    EXPECT_GE(gl::affordable_tiles(gpu, shape, 1, surface, 100), 1u);
    EXPECT_THROW(gl::affordable_tiles(gpu, shape, 1000, surface, 100), gl::Failure);
    EXPECT_EQ(gl::affordable_tiles(gpu, shape, 1, surface, 100), 20u);
    // Numbers and guides of two batches wait in memory of the host.
    const size_t tiles = gl::affordable_tiles(gpu, shape, 10, surface, 100);
    const auto waiting = [&](size_t n) { return 2 * n * shape.pixels() * 41 * sizeof(float); };
    EXPECT_LE(waiting(tiles), size_t(128) << 20);
    EXPECT_GT(waiting(tiles + 1), size_t(128) << 20);
    gpu.context->software = true; // whose memory is the machine's
    EXPECT_EQ(gl::affordable_tiles(gpu, shape, 1000, surface, 100), 1u);
}

} // namespace
} // namespace ddt::test
