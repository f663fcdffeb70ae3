// SPDX-License-Identifier: Apache-2.0
// On the pixel lattice a Tin becomes the Lattice's mesh, edge for edge.
#include "core/lattice/each_triangle.h"
#include "core/tin/tin_mesh.h"
#include "core/triangulate/gain.h"
#include "ddt/names.h"
#include "tests/core/helpers.h"

namespace ddt::test {
namespace {

/// The Tin of a lattice's mesh, with positions in steps of 1 / `step`.
Tin tin_of(const Lattice& lattice, int step) {
    Tin tin;
    const int stride = lattice.stride();
    for (int y = 0; y < lattice.height(); ++y)
        for (int x = 0; x < lattice.width(); ++x)
            tin.vertices.push_back(
                {{x * step, y * step}, lattice.guide(lattice.vertex_site(x, y))});
    std::vector<std::array<int32_t, 3>> triangles;
    const auto vertex = [&](int site) {
        return int32_t(site / stride / 2 * lattice.width() + site % stride / 2);
    };
    each_triangle(lattice, 0, 2 * lattice.height() - 1, [&](int a, int b, int c) {
        triangles.push_back({vertex(a), vertex(c), vertex(b)});
    });
    std::string error;
    EXPECT_TRUE(connect(tin, triangles, error)) << error;
    return tin;
}

/// The lattice edge's ends as numbers of vertices, in its direction.
std::array<int, 2> ends_of(const Lattice& lattice, int m) {
    const Vec v = lattice.edge(m).v;
    const auto vertex = [&](int site) {
        return site / lattice.stride() / 2 * lattice.width() + site % lattice.stride() / 2;
    };
    return {vertex(m - lattice.offset(v)), vertex(m + lattice.offset(v))};
}

void expect_same_edges(const Lattice& lattice, const Tin& tin) {
    int i = 0;
    lattice.each_edge([&](int m) { ASSERT_EQ(ends_of(lattice, m), tin.ends(i++)) << m; });
    EXPECT_EQ(size_t(i), tin.edges.size());
}

std::vector<MeshOptions> all_options() {
    std::vector<MeshOptions> all;
    for (const std::string& scheme : scheme_names())
        for (const std::string& cost : cost_names()) {
            MeshOptions o;
            EXPECT_TRUE(find_scheme(scheme, o)) << scheme;
            EXPECT_TRUE(find_cost(cost, o.cost)) << cost;
            o.min_gain = -1;
            all.push_back(o);
        }
    return all;
}

TEST(TinOnALattice, EveryEdgeIsTheLatticesWithEverySchemeAndCost) {
    uint64_t seed = 3;
    for (MeshOptions o : all_options())
        for (const Kind kind : all_kinds) {
            SCOPED_TRACE(scheme_name(o) + " " + cost_name(o.cost));
            o.seed = uint32_t(++seed);
            o.contour = 0; // pixels alone have contours
            o.max_iterations = o.scheme == Scheme::annealing ? 6 : 64;
            const int width = 17 + int(seed % 5), height = 13;
            const auto guide = make_guide(kind, width, height, seed);
            Lattice lattice;
            lattice.start(width, height, guide.data(), seed % 2);
            Tin tin = tin_of(lattice, 1);
            expect_same_edges(lattice, tin);
            Workspace w, v;
            Statistics on_lattice, on_tin;
            const double cost = total_cost(TinMesh(tin, o.cost));
            EXPECT_EQ(total_cost(lattice, o.cost), cost);
            triangulate(lattice, o, w, on_lattice);
            triangulate(tin, o, v, on_tin);
            expect_same_edges(lattice, tin);
            EXPECT_EQ(on_lattice.flips, on_tin.flips);
            EXPECT_EQ(on_lattice.evaluations, on_tin.evaluations);
            EXPECT_EQ(on_lattice.iterations, on_tin.iterations);
            EXPECT_EQ(on_lattice.rounds, on_tin.rounds);
            EXPECT_TRUE(o.scheme == Scheme::pixel || kind == Kind::flat || on_tin.flips > 0);
            if (HasFatalFailure())
                return;
        }
}

TEST(TinOnALattice, TheUnitIsThePixelWhateverTheSteps) {
    const auto guide = make_guide(Kind::noise, 20, 11, 5);
    Lattice lattice;
    lattice.start(20, 11, guide.data(), true);
    Tin tin = tin_of(lattice, 1), fine = tin_of(lattice, 1 << 20);
    EXPECT_EQ(tin.pixel, 1.0f);
    EXPECT_EQ(fine.pixel, 1.0f / float(1 << 20));
    Workspace w;
    Statistics statistics;
    triangulate(tin, {}, w, statistics);
    triangulate(fine, {}, w, statistics);
    for (size_t m = 0; m < tin.edges.size(); ++m)
        ASSERT_EQ(tin.ends(int(m)), fine.ends(int(m)));
}

} // namespace
} // namespace ddt::test
