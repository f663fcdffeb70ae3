// SPDX-License-Identifier: Apache-2.0
// Meshes of any points: the same triangles and counts on every device.
#include "ddt/names.h"
#include "ddt/points.h"
#include "tests/core/gl/devices.h"
#include "tests/core/gl/shaken_grid.h"

namespace ddt::test {
namespace {

using TinOnDevice = OnDevice;

TEST_P(TinOnDevice, SameTrianglesAndCountsAsTheCpu) {
    uint64_t seed = 0;
    for (const std::string& cost : cost_names())
        for (const std::string& scheme : scheme_names()) {
            SCOPED_TRACE(cost + " " + scheme);
            MeshOptions options;
            ASSERT_TRUE(find_cost(cost, options.cost));
            ASSERT_TRUE(find_scheme(scheme, options));
            // As ddt/points.h says.
            const bool cpu_alone =
                options.scheme == Scheme::lawson || options.scheme == Scheme::look_ahead;
            options.min_gain = -1;
            options.max_iterations = ++seed % 3 == 0                       ? 4
                                     : options.scheme == Scheme::annealing ? 7
                                                                           : 64;
            std::vector<float> guide;
            PointMesh cpu = shaken_grid(23, 19, seed, guide), device = cpu;
            MeshReport on_cpu, on_device;
            std::string error;
            ASSERT_TRUE(optimise(cpu, guide.data(), options, &on_cpu, &error, {}, Device::cpu))
                << error;
            ASSERT_TRUE(optimise(device, guide.data(), options, &on_device, &error, {}, GetParam()))
                << error;
            ASSERT_EQ(cpu.triangles, device.triangles);
            EXPECT_EQ(on_cpu.cost, on_device.cost);
            EXPECT_EQ(on_cpu.statistics.evaluations, on_device.statistics.evaluations);
            EXPECT_EQ(on_cpu.statistics.flips, on_device.statistics.flips);
            EXPECT_EQ(on_cpu.statistics.rounds, on_device.statistics.rounds);
            EXPECT_EQ(on_cpu.statistics.iterations, on_device.statistics.iterations);
            EXPECT_EQ(on_cpu.statistics.pixels, on_device.statistics.pixels);
            EXPECT_EQ(on_device.statistics.device, cpu_alone ? Device::cpu : GetParam());
        }
}

/// A preview drawn meanwhile is on the device that the edges are flipped on.
TEST_P(TinOnDevice, WhoIsToldOfProgressMayUseTheDevice) {
    for (const Scheme scheme : {Scheme::one_round, Scheme::annealing}) {
        MeshOptions options;
        options.scheme = scheme;
        options.max_iterations = 3;
        std::vector<float> guide;
        PointMesh alone = shaken_grid(23, 19, 1, guide), told = alone, inner = alone;
        std::string error;
        ASSERT_TRUE(optimise(alone, guide.data(), options, nullptr, &error, {}, GetParam()))
            << error;
        int calls = 0;
        const auto progress = [&](float) {
            ++calls;
            PointMesh mesh = inner;
            MeshReport report;
            EXPECT_TRUE(optimise(mesh, guide.data(), options, &report, &error, {}, GetParam()))
                << error;
            EXPECT_EQ(report.statistics.device, GetParam());
            EXPECT_EQ(mesh.triangles, alone.triangles);
            return true;
        };
        ASSERT_TRUE(optimise(told, guide.data(), options, nullptr, &error, progress, GetParam()))
            << error;
        EXPECT_GT(calls, 1);
        EXPECT_EQ(told.triangles, alone.triangles);
    }
}

INSTANTIATE_TEST_SUITE_P(Devices, TinOnDevice, testing::Values(Device::egl, Device::osmesa),
                         ddt::test::device_name);

} // namespace
} // namespace ddt::test
