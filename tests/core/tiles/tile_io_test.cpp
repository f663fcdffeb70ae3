// SPDX-License-Identifier: Apache-2.0
#include "core/tiles/tile_io.h"

#include <cfloat>
#include <iterator>
#include <limits>

#include "core/guide/guide.h"
#include "ddt/points.h"
#include "tests/core/job_helpers.h"

namespace ddt::test {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity(),
                nan = std::numeric_limits<float>::quiet_NaN();
/// What a guide has none of.
const float unusual[] = {
    nan, -nan, infinity, -infinity, -0x1p-25f, 0x1p-25f, float_of(0x7fffffff), float_of(1)};

TEST(TileIo, GuidesAreCleaned) {
    on_each_target([&] {
        // By vectors and alone.
        for (const size_t n : {size_t(1), size_t(3), std::size(unusual), size_t(100)}) {
            std::vector<float> guide;
            for (size_t i = 0; i < n; ++i)
                guide.push_back(unusual[i % std::size(unusual)]);
            clean_guide(guide.data(), n);
            for (const float z : guide)
                EXPECT_EQ(bits_of(z), 0u);
        }
        std::vector<float> usual = {0x1p-24f, -0x1p-24f, 1.0f, -0.25f, FLT_MAX, -FLT_MAX};
        const std::vector<float> before = usual;
        clean_guide(usual.data(), usual.size());
        EXPECT_EQ(usual, before);
    });
}

/// The same guide, and with what counts as 0 in place of some of its numbers; and with 0 there.
void spoil(std::vector<float>& guide, std::vector<float>& zeroed) {
    Random random(5);
    zeroed = guide;
    for (size_t i = 0; i < guide.size(); ++i)
        if (random.below(9) == 0) {
            guide[i] = unusual[size_t(random.below(int(std::size(unusual))))];
            zeroed[i] = 0;
        }
}

TEST(TileIo, WhatIsNotFiniteInAGuideCountsAs0) {
    const int w = 70, h = 40, out_w = 150, out_h = 90;
    std::vector<float> guide = make_guide(Kind::shapes, w, h, 1), zeroed;
    const std::vector<float> values = guide;
    spoil(guide, zeroed);
    MeshOptions mesh;
    for (const float blur : {0.0f, 0.2f}) {
        mesh.blur = blur;
        std::vector<float> results[2];
        for (const bool zero : {false, true}) {
            results[zero].resize(size_t(out_w) * out_h);
            EXPECT_EQ(enlarge(values.data(), w, h, 1, (zero ? zeroed : guide).data(),
                              results[zero].data(), out_w, out_h, {}, mesh),
                      Outcome::done);
        }
        EXPECT_EQ(results[0], results[1]) << blur;
    }
}

TEST(TileIo, OfPointsToo) {
    PointMesh mesh;
    const int n = 30;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            mesh.x.push_back(x + 0.3 * (y % 2));
            mesh.y.push_back(y);
            if (x == 0 || y == 0)
                continue;
            const int32_t d = y * n + x, c = d - 1, b = d - n, a = b - 1;
            mesh.triangles.push_back({a, b, d});
            mesh.triangles.push_back({a, d, c});
        }
    std::vector<float> guide = make_guide(Kind::shapes, n, n, 1), zeroed;
    spoil(guide, zeroed);
    PointMesh other = mesh;
    const auto before = mesh.triangles;
    std::string error;
    EXPECT_TRUE(optimise(mesh, guide.data(), {}, nullptr, &error, {}, Device::cpu)) << error;
    EXPECT_TRUE(optimise(other, zeroed.data(), {}, nullptr, &error, {}, Device::cpu)) << error;
    EXPECT_NE(mesh.triangles, before);
    EXPECT_EQ(mesh.triangles, other.triangles);
}

} // namespace
} // namespace ddt::test
