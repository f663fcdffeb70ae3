// SPDX-License-Identifier: Apache-2.0
#include "core/triangulate/regions.h"

#include <algorithm>
#include <set>

#include "core/triangulate/triangulate.h"
#include "tests/core/triangulate/each_mesh.h"

namespace ddt::test {
namespace {

std::vector<int> region_of(const Lattice& lattice, int m) {
    std::vector<int> region;
    lattice.each_of_region(m, [&](int other) { region.push_back(other); });
    return region;
}

/// Of the edge at m and its region the one that no other goes before.
int best_of(const Lattice& lattice, const std::vector<float>& gain, int m) {
    int best = m;
    for (const int other : region_of(lattice, m))
        if (goes_before(gain, other, best))
            best = other;
    return best;
}

TEST(Regions, BlockAllCandidatesButTheBest) {
    size_t blocked = 0, free = 0, ties = 0;
    each_mesh([&](Lattice& lattice) {
        Workspace w;
        find_gains(lattice, Criterion(Cost::abn), w);
        // Few different ones, so that some are equal.
        for (float& gain : w.gain)
            gain = gain == no_gain ? no_gain : std::round(4 * gain) / 4;
        const std::vector<int> sites = flippable_edges(lattice);
        on_each_target([&] {
            // From every number of edges that are left over by vectors.
            for (size_t n = sites.size() - std::min<size_t>(sites.size(), 17); n <= sites.size();
                 ++n) {
                std::vector<int> blockers(n + 1, -7);
                find_blockers(lattice, w.gain, sites.data(), n, blockers.data());
                ASSERT_EQ(blockers[n], -7);
                for (size_t i = 0; i < n; ++i) {
                    const int m = sites[i], best = best_of(lattice, w.gain, m);
                    ASSERT_EQ(blockers[i], best == m ? -1 : best) << "edge " << m;
                    blocked += best != m;
                    free += best == m;
                    ties += best != m && w.gain[size_t(best)] == w.gain[size_t(m)];
                }
            }
        });
    });
    EXPECT_GT(blocked, 1000u);
    EXPECT_GT(free, 1000u);
    EXPECT_GT(ties, 100u);
}

TEST(Regions, AreThoseThatTheLatticeTells) {
    size_t regions_found = 0, fewer = 0;
    each_mesh([&](Lattice& lattice) {
        const std::vector<int> sites = flippable_edges(lattice);
        on_each_target([&] {
            size_t n = 0;
            for (size_t i = 0; i < sites.size(); i += n) {
                // Some vectors, whole or not, and more than are looked at together.
                n = std::min(sites.size() - i, i % (2 * regions_at_once) + 1);
                std::vector<int> found(n * most_in_region + 1, -7);
                find_regions(lattice, &sites[i], n, found.data());
                ASSERT_EQ(found.back(), -7);
                for (size_t k = 0; k < n; ++k) {
                    const int* begin = found.data() + k * most_in_region;
                    const std::set<int> region(begin, begin + most_in_region);
                    std::vector<int> all = region_of(lattice, sites[i + k]);
                    all.push_back(sites[i + k]);
                    ASSERT_EQ(region, std::set<int>(all.begin(), all.end())) << sites[i + k];
                    fewer += region.size() < most_in_region;
                }
                regions_found += n;
            }
        });
    });
    EXPECT_GT(regions_found, 1000u);
    EXPECT_GT(fewer, 100u);
}

} // namespace
} // namespace ddt::test
