// SPDX-License-Identifier: Apache-2.0
// Sizes, channels, tiles and mappings on the GPU against the CPU, bit for bit.
#include "core/tiles/grid.h"
#include "ddt/names.h"
#include "tests/core/gl/devices.h"
#include "tests/core/gl/pictures.h"
#include "tests/core/mirrored.h"
#include "tests/core/turned.h"

namespace ddt::test {
namespace {

class Shapes : public OnDevice {};

Order order_for(int width, int height) {
    Order order;
    order.out_width = width;
    order.out_height = height;
    order.job.surface.consistency = 1;
    order.job.surface.soft = 0.3f;
    order.job.mesh.contour = 0.4f;
    order.job.threads = 2;
    return order;
}

TEST_P(Shapes, EverySize) {
    constexpr int sizes[][2] = {{1, 1},  {1, 7},   {9, 1},   {2, 2},   {3, 5},
                                {64, 1}, {257, 2}, {1, 300}, {258, 31}};
    for (const auto& size : sizes) {
        const Picture p = make_picture(Content::photo, size[0], size[1], 3, 5);
        expect_same(GetParam(), p, order_for(2 * size[0] + 1, 3 * size[1]),
                    std::to_string(size[0]) + " x " + std::to_string(size[1]));
    }
}

// Annealing keeps a number a site where others keep two an edge: more, in pictures so narrow.
TEST_P(Shapes, NarrowOnesOfSeveralMeshesAnnealed) {
    for (const int width : {1, 2})
        for (const int height : {1, 2, 9, 40}) {
            const Picture p = make_picture(Content::noise, width, height, 1, 3);
            Order order = order_for(2 * width + 1, 2 * height + 1);
            order.job.mesh.scheme = Scheme::annealing;
            order.job.mesh.max_iterations = 6;
            order.job.mesh.contour = 0;
            order.job.mesh.blur = 0.05f;
            order.job.mesh.meshes = 4;
            for (const uint32_t seed : {1u, 2u, 3u}) {
                order.job.mesh.seed = seed;
                expect_same(GetParam(), p, order,
                            std::to_string(width) + " x " + std::to_string(height) + ", seed " +
                                std::to_string(seed));
            }
        }
}

TEST_P(Shapes, EveryNumberOfChannels) {
    for (int channels = 1; channels <= 9; ++channels) {
        const Picture p = make_picture(Content::nonfinite, 30, 20, channels, unsigned(channels));
        Order order = order_for(67, 45);
        for (int c = 0; c < channels; ++c)
            order.job.kinds.push_back(Channel(c % 3));
        expect_same(GetParam(), p, order, std::to_string(channels) + " channels");
    }
}

TEST_P(Shapes, SeveralTiles) {
    const Picture p = make_picture(Content::photo, 531, 290, 4, 3);
    expect_same(GetParam(), p, order_for(1301, 601), "531 x 290");
}

// Gradients and corrections are made no further into a tile's halo than its edges reach.
TEST_P(Shapes, SeveralTilesWithLongEdgesAndSeveralRounds) {
    for (const Content content : {Content::drawing, Content::noise, Content::hdr})
        for (const int rounds : {0, 1, 3}) {
            const Picture p = make_picture(content, 420, 61, 4, 11);
            Order order = order_for(841, 122);
            order.job.surface.consistency = rounds;
            expect_same(GetParam(), p, order,
                        std::string(name_of(content)) + ", rounds " + std::to_string(rounds));
        }
}

TEST_P(Shapes, SeveralTilesOfSeveralMeshes) {
    const Picture p = make_picture(Content::photo, 531, 40, 5, 3);
    Order order = order_for(801, 60);
    order.job.mesh.meshes = 3;
    expect_same(GetParam(), p, order, "531 x 40");
}

TEST_P(Shapes, IdentitySizeGivesThePicture) {
    const Picture p = make_picture(Content::noise, 40, 30, 4, 3);
    Order order;
    order.out_width = 40;
    order.out_height = 30;
    const Result result = enlarge_on(GetParam(), p, order);
    ASSERT_EQ(result.outcome, Outcome::done);
    EXPECT_EQ(result.statistics.device, GetParam());
    std::vector<uint32_t> bits(p.values.size());
    std::memcpy(bits.data(), p.values.data(), bits.size() * 4);
    EXPECT_EQ(result.bits, bits);
}

TEST_P(Shapes, PartsOfTheOutputAndWindowsThatDoNotBeginAtZero) {
    const Picture p = make_picture(Content::photo, 300, 50, 2, 8);
    ResizeMapping::Axis x, y;
    x.from_size = x.window1 = 300;
    x.to_size = 900;
    x.out0 = 0, x.out1 = 500;
    y.from_size = y.window1 = 50;
    y.to_size = 100;
    y.to0 = -10;
    y.out0 = 0, y.out1 = 60;
    const ResizeMapping mapping(x, y);
    Order order = order_for(500, 60);
    order.mapping = &mapping;
    expect_same(GetParam(), p, order, "part");
}

TEST_P(Shapes, TurnedPictures) {
    for (const int degrees : {17, 115}) {
        const Picture p = make_picture(Content::photo, 300, 60, 4, 9);
        const Turned turned({0, 0, p.width, p.height}, degrees, 1.7);
        Order order = order_for(turned.out().x1, turned.out().y1);
        order.mapping = &turned;
        order.job.mesh.meshes = degrees < 90 ? 1 : 2;
        expect_same(GetParam(), p, order, "turned by " + std::to_string(degrees));
    }
}

TEST_P(Shapes, MirroredPictures) {
    const Picture p = make_picture(Content::photo, 270, 60, 4, 9);
    const Rect out{0, 0, 520, 130};
    ResizeMapping::Axis x, y;
    x.from_size = x.window1 = p.width;
    x.to_size = x.out1 = out.x1;
    y.from_size = y.window1 = p.height;
    y.to_size = y.out1 = out.y1;
    const ResizeMapping straight(x, y);
    for (const bool both : {false, true}) {
        const Mirrored mirrored(straight, out, true, both);
        Order order = order_for(out.x1, out.y1);
        order.mapping = &mirrored;
        expect_same(GetParam(), p, order, both ? "both axes" : "x");
    }
}

TEST_P(Shapes, RandomJobs) {
    std::mt19937 random(20262);
    const auto below = [&](int n) { return int(random() % unsigned(n)); };
    const std::vector<MeshOptions> meshes = every_scheme_and_cost();
    int of_several_tiles = 0;
    for (int i = 0; i < 60; ++i) {
        // Now and then more than a tile.
        const int width = below(6) ? 1 + below(90) : tile_size + 1 + below(90);
        const auto content = Content(below(int(Content::count)));
        const int height = 1 + below(70), channels = 1 + below(6);
        const Picture p = make_picture(content, width, height, channels, unsigned(random()));
        of_several_tiles += width > tile_size;
        Order order;
        MeshOptions& mesh = order.job.mesh;
        mesh = meshes[size_t(below(int(meshes.size())))];
        if (below(3))
            mesh.scheme = Scheme::one_round;
        mesh.start = Start(below(2));
        mesh.max_iterations = below(3) ? 64 : below(12);
        mesh.min_gain = below(2) ? -1.0f : 0.01f * float(below(10));
        mesh.wide_iterations = 1 + below(4);
        mesh.blur = below(2) ? 0.0f : 0.05f * float(below(6));
        mesh.meshes = below(3) ? 1 : 1 + below(most_meshes);
        mesh.seed = uint32_t(random());
        mesh.contour = below(2) ? 0.0f : 0.2f * float(below(6));
        SurfaceOptions& surface = order.job.surface;
        surface.kind = Surface(below(2));
        surface.consistency = below(4);
        surface.limit = 0.25f * float(below(3));
        surface.clipped = below(2) != 0;
        surface.soft = below(2) ? 0.0f : 0.1f * float(below(8));
        for (int c = 0; c < p.channels; ++c)
            order.job.kinds.push_back(Channel(below(3)));
        order.out_width = p.width + below(200);
        order.out_height = p.height + below(200);
        const double degrees = 6 * below(60);
        const Turned turned({0, 0, p.width, p.height}, degrees, 1.0 + 0.1 * below(20));
        if (below(4) == 0) {
            order.mapping = &turned;
            order.out_width = turned.out().x1;
            order.out_height = turned.out().y1;
        }
        expect_same(GetParam(), p, order,
                    "job " + std::to_string(i) + ", " + scheme_name(mesh) + " " +
                        cost_name(mesh.cost));
    }
    EXPECT_GT(of_several_tiles, 3);
}

INSTANTIATE_TEST_SUITE_P(Devices, Shapes, testing::Values(Device::egl, Device::osmesa),
                         device_name);

} // namespace
} // namespace ddt::test
