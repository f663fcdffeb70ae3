// SPDX-License-Identifier: Apache-2.0
// Lattices wider than those whose sites are worked on several at a time.
#include <set>

#include "core/triangulate/gain.h"
#include "core/triangulate/regions.h"
#include "core/triangulate/triangulate.h"
#include "tests/core/helpers.h"

namespace ddt::test {
namespace {

/// The left and the right end of a lattice, where the smallest and the largest sites of a row are.
std::vector<int> edges_at_the_ends(const Lattice& lattice) {
    std::vector<int> ends;
    for (const int m : flippable_edges(lattice)) {
        const int x = m % lattice.stride() / 2;
        if (std::min(x, lattice.width() - 1 - x) < 20)
            ends.push_back(m);
    }
    return ends;
}

class WideLattice : public ::testing::TestWithParam<int> {};

TEST_P(WideLattice, IsWorkedOnAsAnyOther) {
    Random random(3);
    Lattice lattice;
    const int width = GetParam(), height = 3;
    const auto guide = make_guide(Kind::noise, width, height, 5);
    lattice.start(width, height, guide.data(), true, true);
    for (int i = 0; i < 100; ++i) {
        const auto ends = edges_at_the_ends(lattice);
        const int m = ends[size_t(random.below(int(ends.size())))];
        lattice.flip_all(&m, 1);
        ASSERT_EQ(lattice.edge(m).left, -lattice.edge(m).right);
    }
    const Criterion by(Cost::abn, 0.8f);
    Workspace w;
    find_gains(lattice, by, w);
    const std::vector<int> ends = edges_at_the_ends(lattice);
    std::vector<int> candidates(ends.size() + candidate_padding), blockers(ends.size());
    std::vector<float> gain(lattice.size());
    const Evaluated found =
        find_candidates(lattice, by, 0, ends.data(), ends.size(), gain, candidates.data());
    EXPECT_EQ(found.flippable, ends.size());
    EXPECT_GT(found.candidates, 10u);
    find_blockers(lattice, w.gain, ends.data(), ends.size(), blockers.data());
    size_t good = 0;
    for (size_t i = 0; i < ends.size(); ++i) {
        const int m = ends[i];
        const float g = scalar::gain<scalar::Abn<float>>(lattice, m, by.contour);
        ASSERT_EQ(bits_of(gain[size_t(m)]), bits_of(g));
        ASSERT_EQ(bits_of(w.gain[size_t(m)]), bits_of(g));
        if (g > 0) {
            ASSERT_EQ(candidates[good++], m);
        }
        std::set<int> region{m};
        bool best = true;
        lattice.each_of_region(m, [&](int other) {
            region.insert(other);
            best &= !goes_before(w.gain, other, m);
        });
        ASSERT_EQ(blockers[i] < 0, best);
        ASSERT_TRUE(best || region.count(blockers[i]));
        int regions[most_in_region];
        find_regions(lattice, &m, 1, regions);
        ASSERT_EQ(std::set<int>(regions, regions + most_in_region), region);
    }
    EXPECT_EQ(good, found.candidates);
    EXPECT_TRUE(is_triangulation(lattice));
}

INSTANTIATE_TEST_SUITE_P(BothSidesOfTheLimit, WideLattice,
                         ::testing::Values(widest_lanes, widest_lanes + 1, 40000));

} // namespace
} // namespace ddt::test
