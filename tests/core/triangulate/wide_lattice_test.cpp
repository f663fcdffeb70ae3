// SPDX-License-Identifier: Apache-2.0
// Lattices wider than those whose sites are worked on several at a time.
#include <algorithm>
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
        ASSERT_TRUE(lattice.flippable(m));
    }
    const Criterion by(Cost::abn, 0.8f);
    const std::vector<int> ends = edges_at_the_ends(lattice);
    std::vector<int> candidates = ends, blockers(ends.size());
    candidates.resize(ends.size() + candidate_padding);
    const size_t found = find_candidates(lattice, by, 0, candidates.data(), ends.size());
    EXPECT_GT(found, 10u);
    find_all_gains(lattice, by);
    find_blockers(lattice, ends.data(), ends.size(), blockers.data());
    size_t good = 0;
    for (size_t i = 0; i < ends.size(); ++i) {
        const int m = ends[i];
        const float g = scalar::gain<scalar::Abn<float>>(lattice, m, by.contour);
        ASSERT_EQ(bits_of(lattice.gain(m)), bits_of(g));
        if (g > 0) {
            ASSERT_EQ(candidates[good++], m);
        }
        std::set<int> region{m};
        bool best = true;
        lattice.each_of_region(m, [&](int other) {
            region.insert(other);
            best &= !goes_before(lattice, other, m);
        });
        ASSERT_EQ(blockers[i] < 0, best);
        ASSERT_TRUE(best || region.count(blockers[i]));
        int settled[most_in_region + region_padding];
        const size_t number = find_settled(lattice, &m, 1, settled);
        for (const int other : region)
            ASSERT_TRUE(!lattice.settled(other) ||
                        std::count(settled, settled + number, other) > 0);
        for (size_t k = 0; k < number; ++k)
            ASSERT_TRUE(region.count(settled[k]));
    }
    EXPECT_EQ(good, found);
    EXPECT_TRUE(is_triangulation(lattice));
}

INSTANTIATE_TEST_SUITE_P(BothSidesOfTheLimit, WideLattice,
                         ::testing::Values(widest_lanes, widest_lanes + 1, 40000));

} // namespace
} // namespace ddt::test
