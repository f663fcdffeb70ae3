// SPDX-License-Identifier: Apache-2.0
#include "core/triangulate/gain.h"

#include <cmath>
#include <cstring>
#include <limits>

#include "core/triangulate/triangulate.h"
#include "tests/core/triangulate/each_mesh.h"
#include "tests/core/triangulate/slow_mesh.h"

namespace ddt::test {
namespace {

/// Every cost alone, and some with contours.
std::vector<Criterion> criteria() {
    std::vector<Criterion> all(std::begin(all_costs), std::end(all_costs));
    all.emplace_back(Cost::abn, 0.8f);
    all.emplace_back(Cost::dp, most_contour);
    return all;
}

float scalar_gain(const Lattice& lattice, const Criterion& by, int m) {
    return dispatch(by.cost,
                    [&](auto c) { return scalar::gain<decltype(c)>(lattice, m, by.contour); });
}

bool same_records(const Lattice& a, const Lattice& b) {
    return a.size() == b.size() && !std::memcmp(a.sites(), b.sites(), a.size() * sizeof(Site));
}

TEST(Gain, IsWhatTheTotalCostFallsBy) {
    for (const Cost cost : all_costs)
        each_mesh([&](Lattice& lattice) {
            for (const int m : flippable_edges(lattice)) {
                const double before = total_cost(lattice, cost);
                const double gain = double(scalar_gain(lattice, cost, m));
                lattice.flip(m);
                const double after = total_cost(lattice, cost);
                ASSERT_NEAR(gain, before - after, 2e-6 * (1 + before));
                // Flipped again: all is as before but for the edge's direction.
                ASSERT_NEAR(double(scalar_gain(lattice, cost, m)), -gain, 2e-6 * (1 + before));
                lattice.flip(m);
            }
        });
}

TEST(Gain, TotalCostIsTheFormulasInDouble) {
    for (const Cost cost : {Cost::abn, Cost::scf}) // whose formulas SlowMesh has in double
        each_mesh([&](Lattice& lattice) {
            const double exact = SlowMesh(lattice, cost).total_cost();
            // Each edge is off by a few units of the last place of 1.
            ASSERT_NEAR(total_cost(lattice, cost), exact,
                        2e-7 * double(lattice.size()) + 1e-7 * exact);
        });
}

TEST(Gain, IsThatOfTheSlowMesh) {
    for (const Cost cost : all_costs)
        each_mesh([&](Lattice& lattice) {
            const SlowMesh slow(lattice, cost);
            for (const int m : flippable_edges(lattice)) {
                const Pixel middle{m % lattice.stride(), m / lattice.stride()};
                ASSERT_TRUE(slow.flippable(middle));
                ASSERT_EQ(bits_of(scalar_gain(lattice, cost, m)), bits_of(slow.gain(middle)));
            }
        });
}

/// v' N v in steps, N the mean of the words of the cells at the edge's midpoint.
double contour_of(const Lattice& lattice, int m, Vec v) {
    const int x = m % lattice.stride(), y = m / lattice.stride();
    double sum = 0;
    for (const int cell_x : {(x - 1) / 2, x / 2})
        for (const int cell_y : {(y - 1) / 2, y / 2}) {
            const uint32_t word = lattice.vertex(lattice.vertex_site(cell_x, cell_y)).contour;
            const int xx = int(word) & contour_mask, yy = int(word >> contour_bits) & contour_mask,
                      xy = contour_xy(word);
            sum += double(xx * v.x * v.x + yy * v.y * v.y + 2 * xy * v.x * v.y);
        }
    return sum / 4;
}

TEST(Gain, OfContoursIsWhatTheirFormFallsBy) {
    each_mesh([&](Lattice& lattice) {
        for (const int m : flippable_edges(lattice)) {
            const Edge& e = lattice.edge(m);
            const double fall =
                (contour_of(lattice, m, e.v) - contour_of(lattice, m, e.left)) / contour_steps;
            const float cost = scalar_gain(lattice, Cost::abn, m);
            const float both = scalar_gain(lattice, {Cost::abn, 0.8f}, m);
            ASSERT_NEAR(double(both), double(cost) + 0.8 * fall, 1e-6 * (1 + std::abs(fall)));
        }
    });
}

TEST(Gain, EveryInstructionSetGivesTheScalarBits) {
    on_each_target([&] {
        for (const Criterion& by : criteria())
            each_mesh([&](Lattice& lattice) {
                Lattice before = lattice;
                const auto sites = flippable_edges(lattice);
                find_gains(lattice, by, sites.data(), sites.size());
                for (const int m : sites) {
                    const float gain = scalar_gain(lattice, by, m);
                    ASSERT_EQ(bits_of(lattice.gain(m)), bits_of(gain));
                    before.set_gain(m, gain);
                }
                // Nothing else was written.
                ASSERT_TRUE(same_records(lattice, before));
            });
    });
}

TEST(Gain, AnyNumberOfEdgesIsPossible) {
    Lattice lattice;
    const auto guide = make_guide(Kind::noise, 12, 12, 4);
    lattice.start(12, 12, guide.data(), true);
    const auto sites = flippable_edges(lattice);
    on_each_target([&] {
        for (size_t n = 0; n <= 35; ++n) {
            Lattice some = lattice;
            find_gains(some, Cost::abn, sites.data() + 3, n);
            for (size_t i = 0; i < sites.size(); ++i) {
                const int m = sites[i];
                const bool found = i >= 3 && i < 3 + n;
                const float gain = found ? scalar_gain(lattice, Cost::abn, m) : no_gain;
                ASSERT_EQ(bits_of(some.gain(m)), bits_of(gain));
            }
        }
    });
}

TEST(Gain, CandidatesAreThoseThatGainEnough) {
    size_t all = 0, some = 0;
    each_mesh([&](Lattice& lattice) {
        const Criterion by(Cost::abn);
        const std::vector<int> edges = flippable_edges(lattice);
        for (const float least : {-100.0f, 0.0f, 0.3f})
            on_each_target([&] {
                // From every number of edges that are left over by vectors.
                for (size_t n = edges.size() - std::min<size_t>(edges.size(), 17);
                     n <= edges.size(); ++n) {
                    std::vector<int> found = edges, wanted;
                    found.resize(n + candidate_padding);
                    Lattice other = lattice;
                    found.resize(find_candidates(other, by, least, found.data(), n));
                    for (size_t i = 0; i < n; ++i) {
                        const int m = edges[i];
                        const float gain = scalar_gain(lattice, by, m);
                        ASSERT_EQ(bits_of(other.gain(m)), bits_of(gain)) << "edge " << m;
                        if (gain > least)
                            wanted.push_back(m);
                    }
                    ASSERT_EQ(found, wanted);
                    all += n;
                    some += wanted.size();
                }
            });
    });
    EXPECT_GT(some, 10000u);
    EXPECT_GT(all, some + 10000u);
}

TEST(Gain, NoNumberThatIsStoredIsTakenForSomethingElse) {
    for (const float gain : {-std::numeric_limits<float>::infinity(), std::nanf(""), -std::nanf(""),
                             -3.39e38f, std::numeric_limits<float>::infinity(), -0.0f}) {
        Edge e({1, 1}, {-1, 1}, {1, -1});
        e.set_gain(gain);
        EXPECT_TRUE(e.flippable());
        EXPECT_LT(e.word, least_unsettled);
        EXPECT_EQ(e.right(), Vec(1, -1));
        if (gain < least_gain) {
            EXPECT_EQ(e.gain(), no_gain);
        } else if (gain == gain) {
            EXPECT_EQ(bits_of(e.gain()), bits_of(gain));
        } else {
            EXPECT_TRUE(std::isnan(e.gain()));
        }
    }
}

TEST(Gain, NothingToGainOnAPlane) {
    std::vector<float> guide;
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 10; ++x)
            guide.push_back(float(30 * x - 17 * y) * (1.0f / 4096.0f));
    Lattice lattice;
    lattice.start(10, 9, guide.data(), true);
    Random random(1);
    flip_at_random(lattice, 100, random);
    for (const int m : flippable_edges(lattice)) {
        ASSERT_NEAR(scalar_gain(lattice, Cost::abn, m), 0.0f, 1e-6f);
        ASSERT_NEAR(scalar_gain(lattice, Cost::scf, m), 0.0f, 1e-6f);
    }
}

} // namespace
} // namespace ddt::test
