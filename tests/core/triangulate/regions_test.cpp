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
int best_of(const Lattice& lattice, int m) {
    int best = m;
    for (const int other : region_of(lattice, m))
        if (goes_before(lattice, other, best))
            best = other;
    return best;
}

TEST(Regions, BlockAllCandidatesButTheBest) {
    size_t blocked = 0, free = 0, ties = 0;
    each_mesh([&](Lattice& lattice) {
        find_all_gains(lattice, Cost::abn);
        const std::vector<int> sites = flippable_edges(lattice);
        // Few different ones, so that some are equal.
        for (const int m : sites)
            lattice.set_gain(m, std::round(4 * lattice.gain(m)) / 4);
        on_each_target([&] {
            // From every number of edges that are left over by vectors.
            for (size_t n = sites.size() - std::min<size_t>(sites.size(), 17); n <= sites.size();
                 ++n) {
                std::vector<int> blockers(n + 1, -7);
                find_blockers(lattice, sites.data(), n, blockers.data());
                ASSERT_EQ(blockers[n], -7);
                for (size_t i = 0; i < n; ++i) {
                    const int m = sites[i], best = best_of(lattice, m);
                    ASSERT_EQ(blockers[i], best == m ? -1 : best) << "edge " << m;
                    blocked += best != m;
                    free += best == m;
                    ties += best != m && lattice.gain(best) == lattice.gain(m);
                }
            }
        });
    });
    EXPECT_GT(blocked, 1000u);
    EXPECT_GT(free, 1000u);
    EXPECT_GT(ties, 100u);
}

TEST(Regions, SettledEdgesAreFoundAndThoseThatTheLatticeTells) {
    size_t regions_found = 0, touched = 0;
    each_mesh([&](Lattice& lattice) {
        const std::vector<int> sites = flippable_edges(lattice);
        find_all_gains(lattice, Cost::abn);
        Random random(lattice.size());
        for (const int m : sites)
            touched += random.below(3) == 0 && lattice.touch(m);
        on_each_target([&] {
            size_t n = 0;
            for (size_t i = 0; i < sites.size(); i += n) {
                // Some vectors, whole or not, and more than are looked at together.
                n = std::min(sites.size() - i, i % (2 * regions_at_once) + 1);
                std::vector<int> found(n * most_in_region + region_padding + 1, -7);
                const size_t number = find_settled(lattice, &sites[i], n, found.data());
                ASSERT_EQ(found.back(), -7);
                ASSERT_LE(number, n * most_in_region);
                std::set<int> wanted;
                const auto want = [&](int m) {
                    if (lattice.settled(m))
                        wanted.insert(m);
                };
                for (size_t k = 0; k < n; ++k) {
                    want(sites[i + k]);
                    lattice.each_of_region(sites[i + k], want);
                }
                ASSERT_EQ(std::set<int>(found.begin(), found.begin() + ptrdiff_t(number)), wanted);
                regions_found += n;
            }
        });
    });
    EXPECT_GT(regions_found, 1000u);
    EXPECT_GT(touched, 100u);
}

} // namespace
} // namespace ddt::test
