// SPDX-License-Identifier: Apache-2.0
#include "core/triangulate/schemes.h"

#include "core/triangulate/gain.h"
#include "ddt/names.h"
#include "tests/core/triangulate/run.h"
#include "tests/core/triangulate/slow_mesh.h"

namespace ddt::test {
namespace {

TEST(Schemes, EveryOneEndsInACheaperTriangulation) {
    uint64_t seed = 1;
    for (const Pixel size : {Pixel{2, 2}, Pixel{2, 9}, Pixel{11, 2}, Pixel{19, 14}})
        for (const Kind kind : all_kinds)
            for (const Cost cost : all_costs)
                for (const Scheme scheme : all_schemes) {
                    if (scheme == Scheme::pixel)
                        continue;
                    MeshOptions o = plain_mesh();
                    o.scheme = scheme;
                    o.cost = cost;
                    o.start = ++seed % 2 ? Start::flat : Start::diagonal;
                    SCOPED_TRACE(scheme_name(o) + " " + cost_name(cost));
                    const Result r = run(make_guide(kind, size.x, size.y, seed), size.x, size.y, o);
                    ASSERT_TRUE(is_triangulation(r.lattice));
                    ASSERT_LE(r.cost, r.cost_start + 1e-6 * size.x * size.y);
                    ASSERT_EQ(r.statistics.pixels, size.x * size.y);
                    ASSERT_TRUE(r.statistics.flips > 0 || r.cost == r.cost_start);
                }
}

TEST(Schemes, NoFlipThatGainsIsLeft) {
    for (const Scheme scheme : all_schemes)
        for (const Cost cost : all_costs) {
            if (scheme == Scheme::pixel)
                continue;
            MeshOptions o = plain_mesh();
            o.scheme = scheme;
            o.cost = cost;
            o.max_iterations = most_iterations;
            SCOPED_TRACE(scheme_name(o) + " " + cost_name(cost));
            const Result r = run(make_guide(Kind::shapes, 30, 22, 8), 30, 22, o);
            dispatch(cost, [&](auto which) {
                for (const int m : flippable_edges(r.lattice))
                    ASSERT_LE(scalar::gain<decltype(which)>(r.lattice, m), min_gain(o));
            });
        }
}

/// One accept/reject iteration as the paper words it, without haste: candidates in order of
/// priority, each accepted unless the region of one accepted before holds it.
std::vector<int> slow_accepted(const Lattice& lattice, Cost cost, float min_gain, bool by_gain,
                               int steps) {
    std::vector<std::pair<float, int>> candidates;
    dispatch(cost, [&](auto which) {
        for (const int m : flippable_edges(lattice)) {
            const float g = scalar::gain<decltype(which)>(lattice, m);
            if (g > min_gain)
                candidates.push_back({by_gain ? -g : 0.0f, m});
        }
    });
    std::sort(candidates.begin(), candidates.end());
    const std::vector<Face> faces = faces_of(lattice);
    std::set<int> barred;
    std::vector<int> accepted;
    for (const auto& [priority, m] : candidates) {
        if (barred.count(m))
            continue;
        accepted.push_back(m);
        barred.merge(slow_region(lattice, faces, m, steps));
    }
    std::sort(accepted.begin(), accepted.end());
    return accepted;
}

TEST(AcceptReject, FlipsWhatTheSlowReferenceAccepts) {
    for (const Kind kind : {Kind::noise, Kind::few, Kind::shapes})
        for (const bool by_gain : {false, true})
            for (const int wide : {0, 2, int(Rules::always)}) {
                const auto guide = make_guide(kind, 11, 9, 77);
                const Rules rules{by_gain, wide};
                Lattice slow;
                slow.start(11, 9, guide.data(), false);
                for (int iteration = 1; iteration <= 3; ++iteration) {
                    for (const int m :
                         slow_accepted(slow, Cost::scf, 1e-6f, by_gain, iteration <= wide ? 2 : 1))
                        slow.flip(m);
                    Lattice fast;
                    fast.start(11, 9, guide.data(), false);
                    Workspace w;
                    Statistics s;
                    accept_reject(fast, Cost::scf, 1e-6f, iteration, rules, w, s);
                    ASSERT_EQ(records(fast), records(slow))
                        << by_gain << " " << wide << " " << iteration;
                }
            }
}

TEST(LookAhead, NoPairThatGainsIsLeft) {
    for (const Kind kind : {Kind::noise, Kind::shapes}) {
        MeshOptions o = plain_mesh();
        o.scheme = Scheme::look_ahead;
        o.cost = Cost::scf;
        o.max_iterations = most_iterations;
        Result r = run(make_guide(kind, 25, 20, 8), 25, 20, o);
        using C = scalar::Scf<float>;
        for (const int m : flippable_edges(r.lattice)) {
            Lattice other = r.lattice;
            const float first = scalar::gain<C>(other, m);
            other.flip(m);
            const Quad q(other.edge(m));
            for (const Vec middle : q.middle) {
                const int side = m + other.offset(middle);
                if (!other.edge(side).flippable())
                    continue;
                // The last bits depend on which way round the first edge is stored.
                ASSERT_LE(first + scalar::gain<C>(other, side), min_gain(o) + 1e-6f);
            }
        }
    }
}

TEST(LookAhead, EndsBelowLawson) {
    MeshOptions o = plain_mesh();
    o.cost = Cost::scf;
    const auto guide = make_guide(Kind::shapes, 80, 60, 9);
    o.scheme = Scheme::lawson;
    const double lawson = run(guide, 80, 60, o).cost;
    o.scheme = Scheme::look_ahead;
    EXPECT_LT(run(guide, 80, 60, o).cost, lawson);
}

TEST(Annealing, DependsOnTheSeedAndOnNothingElse) {
    const auto guide = make_guide(Kind::shapes, 60, 40, 9);
    MeshOptions o = plain_mesh();
    o.scheme = Scheme::annealing;
    o.max_iterations = 10;
    const auto once = records(run(guide, 60, 40, o).lattice);
    on_each_target([&] { EXPECT_EQ(records(run(guide, 60, 40, o).lattice), once); });
    o.seed = 2;
    EXPECT_NE(records(run(guide, 60, 40, o).lattice), once);
}

TEST(Annealing, EndsBelowOneRound) {
    MeshOptions o = plain_mesh();
    o.cost = Cost::scf;
    const auto guide = make_guide(Kind::shapes, 80, 60, 9);
    const double before = run(guide, 80, 60, o).cost;
    o.scheme = Scheme::annealing;
    EXPECT_LT(run(guide, 80, 60, o).cost, before);
}

TEST(Annealing, ThePictureIsTheSameForAnyNumberOfThreads) {
    // Wider than a tile, so that tiles overlap.
    const int w = 300, h = 20;
    const auto guide = make_guide(Kind::shapes, w, h, 9);
    MeshOptions o = plain_mesh();
    o.scheme = Scheme::annealing;
    o.max_iterations = 5;
    const auto picture = [&](int threads) {
        std::vector<float> out(size_t(2 * w) * size_t(2 * h));
        EXPECT_TRUE(enlarge(guide.data(), w, h, 1, guide.data(), out.data(), 2 * w, 2 * h,
                            plain_surface(Surface::linear), o, threads) == Outcome::done);
        return out;
    };
    EXPECT_EQ(differing(picture(1), picture(3)), 0u);
}

} // namespace
} // namespace ddt::test
