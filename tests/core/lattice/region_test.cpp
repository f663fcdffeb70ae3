// SPDX-License-Identifier: Apache-2.0
#include "core/lattice/region.h"

#include <set>
#include <vector>

#include "tests/core/triangulate/run.h"
#include "tests/core/triangulate/slow_mesh.h"

namespace ddt::test {
namespace {

TEST(Region, TheWideOneHasAllEdgesOfTheNextRingOfTriangles) {
    const auto guide = make_guide(Kind::noise, 9, 8, 5);
    MeshOptions o = plain_mesh();
    o.cost = Cost::scf;
    const Result r = run(guide, 9, 8, o);
    const std::vector<Face> faces = faces_of(r.lattice);
    r.lattice.each_edge([&](int m) {
        if (!r.lattice.edge(m).flippable())
            return;
        std::set<int> narrow, wide;
        r.lattice.each_of_region(m, [&](int e) { narrow.insert(e); });
        any_of_wide_region(r.lattice, m, [&](int e) {
            wide.insert(e);
            return false;
        });
        wide.erase(m);
        ASSERT_EQ(narrow, slow_region(r.lattice, faces, m, 1));
        ASSERT_EQ(wide, slow_region(r.lattice, faces, m, 2));
    });
}

TEST(Region, FarFromTheRimThereAre12And28Edges) {
    const std::vector<float> guide(12 * 12, 0.0f);
    Lattice lattice;
    lattice.start(12, 12, guide.data(), false);
    const int m = lattice.site(11, 11);
    std::set<int> narrow;
    lattice.each_of_region(m, [&](int e) { narrow.insert(e); });
    EXPECT_EQ(narrow.size(), 12u);
    int visits = 0;
    any_of_wide_region(lattice, m, [&](int) {
        ++visits;
        return false;
    });
    EXPECT_EQ(visits, 28);
}

} // namespace
} // namespace ddt::test
