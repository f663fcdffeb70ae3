// SPDX-License-Identifier: Apache-2.0
// Meshes of any points: the same triangles and counts on every device.
#include "ddt/names.h"
#include "ddt/points.h"
#include "tests/core/gl/devices.h"
#include "tests/core/helpers.h"

namespace ddt::test {
namespace {

using TinOnDevice = OnDevice;

/// A grid whose points are moved about, with two triangles a cell, and values of a slanting step
/// with noise. No Delaunay is needed for it.
PointMesh shaken_grid(int width, int height, uint64_t seed, std::vector<float>& guide) {
    Random random(seed);
    PointMesh mesh;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            mesh.x.push_back(x + 0.001 * random.below(400));
            mesh.y.push_back(y + 0.001 * random.below(400));
            guide.push_back((3 * x + 7 * y) % 29 < 13 ? 0.8f : 0.003f * float(random.below(100)));
        }
    for (int32_t y = 0; y + 1 < height; ++y)
        for (int32_t x = 0; x + 1 < width; ++x) {
            const int32_t v = y * width + x;
            mesh.triangles.push_back({v, v + 1, v + width});
            mesh.triangles.push_back({v + 1, v + width + 1, v + width});
        }
    return mesh;
}

TEST_P(TinOnDevice, SameTrianglesAndCountsAsTheCpu) {
    uint64_t seed = 0;
    for (const std::string& cost : cost_names())
        for (const char* scheme : {"one-round", "basic", "exproi", "maxgain", "exproi-maxgain",
                                   "exproi2-maxgain", "pixel", "lawson"}) {
            SCOPED_TRACE(cost + " " + scheme);
            MeshOptions options;
            find_cost(cost, options.cost);
            find_scheme(scheme, options);
            options.min_gain = -1;
            options.max_iterations = ++seed % 3 == 0 ? 4 : 64;
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
            EXPECT_EQ(on_device.statistics.device,
                      options.scheme == Scheme::lawson ? Device::cpu : GetParam());
        }
}

INSTANTIATE_TEST_SUITE_P(Devices, TinOnDevice, testing::Values(Device::egl, Device::osmesa),
                         ddt::test::device_name);

} // namespace
} // namespace ddt::test
