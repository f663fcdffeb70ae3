// SPDX-License-Identifier: Apache-2.0
#include "core/lattice/divisions.h"

#include "tests/core/helpers.h"

namespace ddt::test {
namespace {

TEST(Divisions, EachCellsIsThatOfItsCentralEdge) {
    constexpr int most = 70;
    on_each_target([] {
        Random random(3);
        int seen[3] = {};
        for (int n = 0; n <= most; ++n) {
            // Edges of cells divided either way, by an edge either way round, and of flipped ones;
            // gains beside the vectors are of no account.
            std::vector<Site> sites(size_t(2 * most));
            for (Site& s : sites) {
                const int way = random.below(2) ? 1 : -1, up = random.below(2) ? -1 : 1;
                const Vec left(-way, way * up);
                Vec vectors[] = {Vec(way * up, way), left, -left};
                Vec& other = vectors[random.below(3)];
                if (!random.below(3))
                    (random.below(2) ? other.x : other.y) = int8_t(random.between(-127, 127));
                s.edge = Edge(vectors[0], vectors[1], vectors[2]);
                if (s.edge.flippable())
                    s.edge.set_gain(random.unit() - 0.5f);
            }
            constexpr auto canary = Division(77);
            std::vector<Division> found(size_t(most) + 1, canary);
            find_divisions(sites.data(), n, found.data());
            for (int k = 0; k < n; ++k) {
                const Division expected = division(sites[size_t(2 * k)].edge);
                ASSERT_EQ(found[size_t(k)], expected) << n << ' ' << k;
                ++seen[int(expected)];
            }
            for (int k = n; k <= most; ++k)
                ASSERT_EQ(found[size_t(k)], canary) << n << ' ' << k;
        }
        for (const int times : seen)
            EXPECT_GT(times, 300);
    });
}

} // namespace
} // namespace ddt::test
