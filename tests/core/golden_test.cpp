// Hashes of results, so that a change of arithmetic is noticed. When one is meant, run the test
// with --gtest_filter='Golden.*' and put in the numbers it prints.
#include "ddt/core.h"

#include "core/triangulate/triangulate.h"
#include "tests/core/helpers.h"

namespace ddt::test {
namespace {

struct Case {
    Kind kind;
    Cost cost;
    Scheme scheme;
    Surface surface;
    int channels;
    uint64_t expected;
};

TEST(Golden, EnlargedPicturesHaveTheseBits) {
    constexpr Case cases[] = {
        {Kind::shapes, Cost::abn, Scheme::one_round, Surface::patch, 3, 1},
        {Kind::shapes, Cost::abn, Scheme::one_round, Surface::linear, 3, 2},
        {Kind::shapes, Cost::scf, Scheme::one_round, Surface::patch, 1, 3},
        {Kind::shapes, Cost::abn, Scheme::lawson, Surface::patch, 4, 4},
        {Kind::shapes, Cost::abn, Scheme::pixel, Surface::linear, 1, 5},
        {Kind::noise, Cost::abn, Scheme::one_round, Surface::patch, 5, 6},
        {Kind::few, Cost::scf, Scheme::lawson, Surface::linear, 1, 7},
        {Kind::few, Cost::abn, Scheme::one_round, Surface::patch, 1, 8},
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
        MeshOptions mesh;
        mesh.cost = c.cost;
        mesh.scheme = c.scheme;
        for (const int threads : {1, 3}) {
            ASSERT_EQ(enlarge(values.data(), w, h, c.channels, guide.data(), out.data(), out_w,
                              out_h, c.surface, mesh, threads),
                      Outcome::done);
            EXPECT_EQ(hash(out), c.expected)
                << "case " << &c - cases << ": 0x" << std::hex << hash(out) << 'u';
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
        MeshOptions options;
        options.cost = cost;
        options.scheme = scheme;
        lattice.start(w, h, guide.data(), true);
        triangulate(lattice, options, workspace, statistics);
        std::vector<float> numbers;
        for (const int n : records(lattice))
            numbers.push_back(float(n));
        numbers.push_back(float(statistics.flips));
        numbers.push_back(float(statistics.iterations));
        return hash(numbers);
    };
    EXPECT_EQ(of(Cost::abn, Scheme::one_round), 0x1u);
    EXPECT_EQ(of(Cost::scf, Scheme::one_round), 0x2u);
    EXPECT_EQ(of(Cost::abn, Scheme::lawson), 0x3u);
    EXPECT_EQ(of(Cost::scf, Scheme::lawson), 0x4u);
}

} // namespace
} // namespace ddt::test
