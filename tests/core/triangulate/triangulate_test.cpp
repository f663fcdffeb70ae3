// SPDX-License-Identifier: Apache-2.0
#include "core/triangulate/triangulate.h"

#include <cmath>

#include "core/guide/guide.h"
#include "core/triangulate/gain.h"
#include "tests/core/triangulate/run.h"
#include "tests/core/triangulate/slow_mesh.h"

namespace ddt::test {
namespace {

MeshOptions options_of(Scheme scheme, Cost cost, float gain = -1.0f, int iterations = 64) {
    MeshOptions o = plain_mesh();
    o.scheme = scheme;
    o.cost = cost;
    o.min_gain = gain;
    o.max_iterations = iterations;
    return o;
}

/// Call f(guide, width, height, options) for all kinds of guide and the schemes and costs that
/// slow_mesh.h has.
template <class F>
void each_case(F&& f) {
    uint64_t seed = 21;
    for (const Pixel size : {Pixel{2, 2}, Pixel{2, 13}, Pixel{15, 2}, Pixel{13, 11}, Pixel{24, 17}})
        for (const Kind kind : all_kinds)
            for (const Cost cost : {Cost::abn, Cost::scf})
                for (const Scheme scheme : {Scheme::one_round, Scheme::lawson})
                    for (const Start start : {Start::flat, Start::diagonal}) {
                        SCOPED_TRACE(::testing::Message()
                                     << size.x << " x " << size.y << ", kind " << int(kind)
                                     << ", cost " << int(cost) << ", scheme " << int(scheme)
                                     << ", start " << int(start));
                        MeshOptions o = options_of(scheme, cost);
                        o.start = start;
                        f(make_guide(kind, size.x, size.y, ++seed), size.x, size.y, o);
                    }
}

TEST(Triangulate, TheMeshIsThatOfTheSlowReferenceFlipForFlip) {
    each_case([](const std::vector<float>& guide, int w, int h, MeshOptions o) {
        Lattice start;
        start.start(w, h, guide.data(), o.start == Start::flat);
        for (const float gain : {-1.0f, 0.0f, 0.1f})
            for (const int iterations : {1, 2, 3, 7, 64}) {
                if (gain >= 0 && iterations != 64)
                    continue;
                o.min_gain = gain;
                o.max_iterations = iterations;
                const Result r = run(guide, w, h, o);
                SlowMesh slow(start, o.cost);
                const SlowCounts counts = o.scheme == Scheme::lawson
                                              ? slow_lawson(slow, min_gain(o), iterations)
                                              : slow_one_round(slow, min_gain(o), iterations);
                ASSERT_EQ(records(r.lattice), slow.records());
                ASSERT_EQ(r.statistics.flips, counts.flips);
                ASSERT_EQ(r.statistics.iterations, counts.iterations);
                // Gains are computed for what a flip touched, never for more.
                ASSERT_LE(r.statistics.evaluations, counts.evaluations);
                ASSERT_EQ(r.statistics.pixels, w * h);
                ASSERT_TRUE(is_triangulation(r.lattice));
            }
    });
}

TEST(Triangulate, OnALargerPictureToo) {
    // Enough candidates that long chains of them wait for one another.
    for (const Kind kind : {Kind::few, Kind::shapes}) {
        const int w = 60, h = 41;
        const auto guide = make_guide(kind, w, h, 77);
        const auto o = options_of(Scheme::one_round, Cost::abn, 1e-5f, 250);
        const Result r = run(guide, w, h, o);
        Lattice start;
        start.start(w, h, guide.data(), true);
        SlowMesh slow(start, o.cost);
        const SlowCounts counts = slow_one_round(slow, o.min_gain, o.max_iterations);
        EXPECT_EQ(records(r.lattice), slow.records());
        EXPECT_EQ(r.statistics.flips, counts.flips);
        EXPECT_EQ(r.statistics.iterations, counts.iterations);
        EXPECT_GT(counts.iterations, 5);
        EXPECT_GT(counts.flips, w * h / 4);
    }
}

TEST(Triangulate, TheCostNeverRisesFromIterationToIteration) {
    each_case([](const std::vector<float>& guide, int w, int h, MeshOptions o) {
        o.max_iterations = 0;
        double before = run(guide, w, h, o).cost;
        int64_t flips_before = 0;
        for (int i = 1;; ++i) {
            o.max_iterations = i;
            const Result r = run(guide, w, h, o);
            const double cost = r.cost;
            const auto flips = double(r.statistics.flips - flips_before);
            // Each flip gains more than min_gain; rounding apart.
            ASSERT_LE(cost, before - flips * double(min_gain(o)) + 1e-6 * (1 + before));
            if (flips == 0)
                break;
            before = cost;
            flips_before = r.statistics.flips;
            ASSERT_LT(i, 100);
        }
    });
}

TEST(Triangulate, OneRoundLeavesTheGainsOfTheFinishedMesh) {
    each_case([](const std::vector<float>& guide, int width, int height, MeshOptions o) {
        o.scheme = Scheme::one_round;
        for (const int iterations : {0, 1, 3, 64}) {
            o.max_iterations = iterations;
            o.contour = iterations == 3 ? 0.0f : 0.8f;
            Lattice lattice;
            Workspace workspace;
            Statistics statistics;
            start(lattice, width, height, guide.data(), o);
            triangulate(lattice, o, workspace, statistics);
            Lattice found = lattice;
            find_all_gains(found, criterion(o));
            lattice.each_edge([&](int m) {
                if (lattice.edge(m).flippable()) {
                    ASSERT_EQ(bits_of(lattice.gain(m)), bits_of(found.gain(m)));
                }
            });
        }
    });
}

TEST(Triangulate, NoGainIsLeftAtTheEnd) {
    each_case([](const std::vector<float>& guide, int w, int h, MeshOptions o) {
        for (const float gain : {-1.0f, 0.05f}) {
            o.min_gain = gain;
            o.max_iterations = 250;
            o.contour = gain > 0 ? 0.4f : 0.0f;
            const Result r = run(guide, w, h, o);
            for (const int m : flippable_edges(r.lattice)) {
                const float left = dispatch(o.cost, [&](auto c) {
                    return scalar::gain<decltype(c)>(r.lattice, m, o.contour);
                });
                ASSERT_LE(left, min_gain(o));
            }
        }
    });
}

/// Of the edges whose midpoints are within a pixel of the line through the middle along (dx, dy),
/// away from the picture's rim, the share that goes at less than 15 degrees from it.
double share_along(const Lattice& lattice, int size, double dx, double dy) {
    int near = 0, along = 0;
    const double length = std::hypot(dx, dy);
    lattice.each_edge([&](int m) {
        const double x = m % lattice.stride() * 0.5, y = m / lattice.stride() * 0.5;
        const double c = size / 2;
        if (std::max(std::abs(x - c), std::abs(y - c)) > size / 2 - 8 ||
            std::abs((x - c) * dy - (y - c) * dx) > length)
            return;
        const Vec v = lattice.edge(m).v;
        ++near;
        along += std::abs(v.x * dy - v.y * dx) < 0.26 * length * std::hypot(v.x, v.y);
    });
    return double(along) / near;
}

// A third of a mesh's edges can go along a contour. Under noise the cost alone loses many of them.
TEST(Triangulate, WithContoursEdgesFollowAStraightLineUnderNoise) {
    const int size = 64;
    Random random(3);
    double gained = 0;
    for (const auto& d : {Pixel{3, 1}, Pixel{5, 2}, Pixel{-4, 3}, Pixel{1, 6}}) {
        std::vector<float> guide;
        const double length = std::hypot(d.x, d.y);
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const double across = ((x - size / 2) * d.y - (y - size / 2) * d.x) / length;
                const double level = 0.4 + 0.3 * std::clamp(0.5 + across / 2, 0.0, 1.0);
                guide.push_back(guide_step(float(level) + 0.08f * (random.unit() - 0.5f)));
            }
        MeshOptions o = options_of(Scheme::one_round, Cost::abn);
        const double before = share_along(run(guide, size, size, o).lattice, size, d.x, d.y);
        o.contour = 0.8f;
        const double after = share_along(run(guide, size, size, o).lattice, size, d.x, d.y);
        EXPECT_GT(after, 0.3) << d.x << ", " << d.y;
        gained += after - before;
    }
    EXPECT_GT(gained / 4, 0.05);
}

TEST(Triangulate, AFlipMustGainMoreThanMinGain) {
    // The only edge there is to flip, on 2 x 2 pixels with one corner raised.
    const std::vector<float> guide{1.0f, 0.0f, 0.0f, 0.0f};
    Lattice lattice;
    lattice.start(2, 2, guide.data(), false);
    MeshOptions o = options_of(Scheme::one_round, Cost::abn);
    o.start = Start::diagonal;
    const float gain = scalar::gain<scalar::Abn<float>>(lattice, lattice.site(1, 1));
    ASSERT_GT(gain, 0.1f);
    for (const Scheme scheme : {Scheme::one_round, Scheme::lawson}) {
        o.scheme = scheme;
        o.min_gain = gain;
        EXPECT_EQ(run(guide, 2, 2, o).statistics.flips, 0);
        o.min_gain = std::nextafter(gain, 0.0f);
        EXPECT_EQ(run(guide, 2, 2, o).statistics.flips, 1);
    }
}

TEST(Triangulate, NegativeMinGainIsTheCostsDefault) {
    EXPECT_EQ(min_gain(options_of(Scheme::one_round, Cost::abn)), traits(Cost::abn).min_gain);
    EXPECT_EQ(min_gain(options_of(Scheme::one_round, Cost::scf)), traits(Cost::scf).min_gain);
    EXPECT_EQ(min_gain(options_of(Scheme::lawson, Cost::abn)), 1e-6f);
    EXPECT_EQ(min_gain(options_of(Scheme::exproi_n_maxgain, Cost::abn)), 1e-6f);
    EXPECT_EQ(min_gain(options_of(Scheme::one_round, Cost::scf, 0.0f)), 0.0f);
    EXPECT_EQ(min_gain(options_of(Scheme::one_round, Cost::abn, 0.3f)), 0.3f);
}

TEST(Triangulate, PixelSchemeAndZeroIterationsLeaveTheStart) {
    const auto guide = make_guide(Kind::noise, 14, 9, 3);
    Lattice start;
    start.start(14, 9, guide.data(), true);
    for (const auto& o :
         {options_of(Scheme::pixel, Cost::abn), options_of(Scheme::one_round, Cost::abn, -1.0f, 0),
          options_of(Scheme::lawson, Cost::abn, -1.0f, 0)}) {
        const Result r = run(guide, 14, 9, o);
        EXPECT_EQ(records(r.lattice), records(start));
        EXPECT_EQ(r.statistics.flips, 0);
        EXPECT_EQ(r.statistics.iterations, 0);
        EXPECT_EQ(r.statistics.pixels, 14 * 9);
    }
}

TEST(Triangulate, StatisticsAddUp) {
    const auto guide = make_guide(Kind::noise, 14, 9, 3);
    for (const Scheme scheme : {Scheme::one_round, Scheme::lawson}) {
        const auto o = options_of(scheme, Cost::abn);
        const Statistics once = run(guide, 14, 9, o).statistics;
        Statistics sum;
        Workspace workspace;
        for (int i = 0; i < 3; ++i) {
            Lattice lattice;
            lattice.start(14, 9, guide.data(), true);
            triangulate(lattice, o, workspace, sum);
        }
        EXPECT_EQ(sum.pixels, 3 * once.pixels);
        EXPECT_EQ(sum.evaluations, 3 * once.evaluations);
        EXPECT_EQ(sum.flips, 3 * once.flips);
        EXPECT_EQ(sum.iterations, once.iterations); // the largest
        EXPECT_GT(once.flips, 0);
        EXPECT_GT(once.iterations, 1);
    }
}

TEST(Triangulate, WhatTheWorkspaceWasUsedForBeforeDoesNotMatter) {
    Lattice lattice;
    Workspace workspace;
    Statistics statistics;
    for (const Pixel size : {Pixel{31, 22}, Pixel{6, 9}, Pixel{22, 31}, Pixel{2, 2}, Pixel{31, 22}})
        for (const Kind kind : {Kind::noise, Kind::few}) {
            const auto o = options_of(Scheme::one_round, Cost::abn);
            const auto guide = make_guide(kind, size.x, size.y, 8);
            lattice.start(size.x, size.y, guide.data(), true);
            triangulate(lattice, o, workspace, statistics);
            ASSERT_EQ(records(lattice), records(run(guide, size.x, size.y, o).lattice));
        }
}

TEST(Triangulate, EveryInstructionSetMakesTheSameMesh) {
    const auto guide = make_guide(Kind::shapes, 40, 33, 6);
    const auto o = options_of(Scheme::one_round, Cost::abn);
    const auto expected = records(run(guide, 40, 33, o).lattice);
    on_each_target([&] { EXPECT_EQ(records(run(guide, 40, 33, o).lattice), expected); });
}

TEST(Triangulate, AGuideOfAnyNumbersEndsInAMesh) {
    Random random(12);
    const float inf = std::numeric_limits<float>::infinity();
    const float odd[] = {inf, -inf, std::nanf(""), 1e38f, -1e38f, 3e38f, 1e-40f, 0.0f, 1.0f};
    for (const Scheme scheme : all_schemes)
        for (const Cost cost : all_costs) {
            const auto guide = fill(400, [&] { return odd[random.below(9)]; });
            const Result r = run(guide, 20, 20, options_of(scheme, cost));
            EXPECT_TRUE(is_triangulation(r.lattice));
        }
}

} // namespace
} // namespace ddt::test
