// SPDX-License-Identifier: Apache-2.0
// Many flips at once are the same flips one by one.
#include "tests/core/triangulate/each_mesh.h"

namespace ddt::test {
namespace {

/// Some flippable edges, chosen at random, outside each other's 2-regions.
std::vector<int> edges_apart(const Lattice& lattice, Random& random) {
    std::vector<int> left = flippable_edges(lattice), apart;
    std::set<int> near;
    while (!left.empty()) {
        const size_t at = size_t(random.below(int(left.size())));
        const int m = left[at];
        left.erase(left.begin() + ptrdiff_t(at));
        if (near.count(m))
            continue;
        apart.push_back(m);
        lattice.each_of_region(m, [&](int other) { near.insert(other); });
    }
    return apart;
}

/// Whether two lattices of one size have the same edges, gains among them.
bool same_edges(const Lattice& a, const Lattice& b) {
    bool same = true;
    a.each_edge([&](int m) {
        same &= vectors_of(a.edge(m)) == vectors_of(b.edge(m)) && a.gain(m) == b.gain(m);
    });
    return same;
}

TEST(Flips, ManyAtOnceAreThoseOneByOne) {
    size_t flips = 0, steep = 0, longest = 0;
    each_mesh([&](Lattice& lattice) {
        Random random(lattice.size());
        float gain = 0;
        for (const int m : flippable_edges(lattice))
            lattice.set_gain(m, ++gain);
        const std::vector<int> all = edges_apart(lattice, random);
        on_each_target([&] {
            // From every number of edges that are left over by vectors.
            for (size_t n = all.size() - std::min<size_t>(all.size(), 17); n <= all.size(); ++n) {
                Lattice one_by_one = lattice, at_once = lattice;
                for (size_t i = 0; i < n; ++i)
                    one_by_one.flip(all[i]);
                at_once.flip_all(all.data(), n);
                ASSERT_TRUE(same_edges(one_by_one, at_once)) << n << " of " << all.size();
                ASSERT_EQ(one_by_one.longest(), at_once.longest());
                ASSERT_EQ(one_by_one.fresh(), at_once.fresh());
                for (int y = 0; y < 2 * lattice.height() - 1; ++y)
                    ASSERT_EQ(one_by_one.longest_down(y), at_once.longest_down(y)) << "row " << y;
                flips += n;
                for (size_t i = 0; i < n; ++i)
                    steep += std::abs(at_once.edge(all[i]).v.y) > 1;
                longest = std::max(longest, size_t(at_once.longest()));
            }
        });
    });
    EXPECT_GT(flips, 10000u);
    EXPECT_GT(steep, 1000u);
    EXPECT_EQ(longest, size_t(longest_edge));
}

} // namespace
} // namespace ddt::test
