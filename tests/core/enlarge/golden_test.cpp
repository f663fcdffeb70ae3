// SPDX-License-Identifier: Apache-2.0
// Hashes of results, so that a change of arithmetic is noticed. When one is meant, run the test
// with --gtest_filter='Golden.*' and put in the numbers it prints.
#include "ddt/core.h"

#include "core/triangulate/triangulate.h"
#include "tests/core/helpers.h"
#include "tests/fnv.h"

namespace ddt::test {
namespace {

struct Case {
    Kind kind;
    Cost cost;
    Scheme scheme;
    Surface surface;
    int channels;
    float soft;
    int consistency;
    uint64_t expected;
    float contour = 0;
    bool clipped = false, fitted = false;
    int meshes = 1;
};

TEST(Golden, EnlargedPicturesHaveTheseBits) {
    constexpr Case cases[] = {
        {Kind::shapes, Cost::abn, Scheme::one_round, Surface::patch, 3, 0, 0, 0xc96d80f32ae18201u},
        {Kind::shapes, Cost::abn, Scheme::one_round, Surface::linear, 3, 0, 0, 0x34cac6bbea815b28u},
        {Kind::shapes, Cost::scf, Scheme::one_round, Surface::patch, 1, 0, 0, 0x5760bdf4d09f357du},
        {Kind::shapes, Cost::abn, Scheme::lawson, Surface::patch, 4, 0, 0, 0x5c2921c6164ed927u},
        {Kind::shapes, Cost::abn, Scheme::pixel, Surface::linear, 1, 0, 0, 0x72f4aec70a82b7f1u},
        {Kind::noise, Cost::abn, Scheme::one_round, Surface::patch, 5, 0, 0, 0x86e81c83cc32b8e7u},
        {Kind::few, Cost::scf, Scheme::lawson, Surface::linear, 1, 0, 0, 0xc1f30eb8c13aaf80u},
        {Kind::few, Cost::abn, Scheme::one_round, Surface::patch, 1, 0, 0, 0x27bc160c619b19d0u},
        {Kind::shapes, Cost::abn, Scheme::one_round, Surface::patch, 3, 0.3f, 0,
         0x6ca6b29b7e88f98eu},
        {Kind::shapes, Cost::abn, Scheme::one_round, Surface::patch, 3, 0, 2, 0x57c884f2221246e7u},
        {Kind::noise, Cost::abn, Scheme::one_round, Surface::linear, 1, 0.3f, 1,
         0x537fd445025bd931u},
        {Kind::shapes, Cost::abn, Scheme::one_round, Surface::patch, 3, 0.3f, 0,
         0x625185f61cddafe0u, 0.8f},
        {Kind::noise, Cost::dlp, Scheme::lawson, Surface::patch, 1, 0.3f, 2, 0xc07af7b9f1a0ba73u,
         0.4f},
        {Kind::shapes, Cost::abn, Scheme::one_round, Surface::patch, 3, 0.3f, 2,
         0x3e8d842c4b4ba8eau, 0.4f, true},
        {Kind::shapes, Cost::abn, Scheme::one_round, Surface::patch, 3, 0.3f, 2,
         0xdef66a176d5a542au, 0.4f, true, true},
        {Kind::noise, Cost::abn, Scheme::one_round, Surface::patch, 1, 0.3f, 2, 0xda7a4fb3e260d6bcu,
         0.4f, false, true},
        {Kind::shapes, Cost::abn, Scheme::one_round, Surface::patch, 3, 0.4f, 0,
         0xe8b22bfb4534e602u, 0.8f, false, false, 3},
    };
    for (const Case& c : cases) {
        // More than a tile wide; an odd factor, another one down.
        const int w = 300, h = 70, out_w = 811, out_h = 150;
        const auto guide = make_guide(c.kind, w, h, 1234);
        std::vector<float> values, out(size_t(out_w * out_h * c.channels));
        Random random(4321);
        for (const float z : guide)
            for (int k = 0; k < c.channels; ++k)
                values.push_back(k == 0 ? z * z : z + 0.25f * random.unit());
        SurfaceOptions surface = plain_surface(c.surface);
        surface.soft = c.soft;
        surface.consistency = c.consistency;
        surface.clipped = c.clipped;
        surface.fitted = c.fitted;
        MeshOptions mesh = plain_mesh();
        mesh.cost = c.cost;
        mesh.scheme = c.scheme;
        mesh.contour = c.contour;
        mesh.meshes = c.meshes;
        for (const int threads : {1, 3}) {
            ASSERT_EQ(enlarge(values.data(), w, h, c.channels, guide.data(), out.data(), out_w,
                              out_h, surface, mesh, threads),
                      Outcome::done);
            EXPECT_EQ(fnv(out), c.expected)
                << "case " << &c - cases << ": 0x" << std::hex << fnv(out) << 'u';
        }
    }
}

TEST(Golden, MeshesAreThese) {
    const int w = 97, h = 83;
    const auto guide = make_guide(Kind::shapes, w, h, 55);
    const auto of = [&](Cost cost, Scheme scheme) {
        Lattice lattice;
        Workspace workspace;
        Statistics statistics;
        MeshOptions options = plain_mesh();
        options.cost = cost;
        options.scheme = scheme;
        lattice.start(w, h, guide.data(), true);
        triangulate(lattice, options, workspace, statistics);
        std::vector<float> numbers;
        for (const int n : records(lattice))
            numbers.push_back(float(n));
        numbers.push_back(float(statistics.flips));
        numbers.push_back(float(statistics.iterations));
        return fnv(numbers);
    };
    EXPECT_EQ(of(Cost::abn, Scheme::one_round), 0xfcad4041de4e43a5u);
    EXPECT_EQ(of(Cost::scf, Scheme::one_round), 0x887de0870dc41727u);
    EXPECT_EQ(of(Cost::abn, Scheme::lawson), 0x854baf2e8d2b3a9cu);
    EXPECT_EQ(of(Cost::scf, Scheme::lawson), 0x3fcfc0c0f747640u);
}

} // namespace
} // namespace ddt::test
