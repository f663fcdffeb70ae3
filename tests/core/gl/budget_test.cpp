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
    const auto affordable = [&](int groups, const MeshOptions& mesh = {}) {
        return gl::affordable_tiles(gpu, shape, groups, mesh, SurfaceOptions(), 100);
    };
    EXPECT_GE(affordable(1), 1u);
    EXPECT_THROW(affordable(1000), gl::Failure);
    EXPECT_EQ(affordable(1), 20u);
    // Numbers and guides of two batches wait in memory of the host.
    const size_t tiles = affordable(10);
    const auto waiting = [&](size_t n) { return 2 * n * shape.pixels() * 41 * sizeof(float); };
    EXPECT_LE(waiting(tiles), size_t(128) << 20);
    EXPECT_GT(waiting(tiles + 1), size_t(128) << 20);
    gpu.context->software = true; // whose memory is the machine's
    EXPECT_EQ(affordable(1000), 1u);
    // The paper's schemes take more, and one that the CPU works by does not.
    MeshOptions mesh;
    mesh.contour = 0;
    mesh.scheme = Scheme::lawson;
    EXPECT_EQ(affordable(1, mesh), affordable(1));
    mesh.scheme = Scheme::maxgain;
    EXPECT_LT(affordable(1, mesh), affordable(1));
    mesh = {};
    mesh.meshes = 2;
    EXPECT_LE(affordable(1, mesh), affordable(1) / 2);
}

} // namespace
} // namespace ddt::test
