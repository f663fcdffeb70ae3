// SPDX-License-Identifier: Apache-2.0
#include "core/lattice/fans.h"

#include "tests/core/lattice/flipped_meshes.h"

namespace ddt::test {
namespace {

/// The spokes of a vertex within the hull's rim, one after the other.
std::vector<Vec> walk_round(const Lattice& lattice, int vertex) {
    std::vector<Vec> spokes;
    Vec at = lattice.vertex(vertex).first;
    do {
        spokes.push_back(at);
        const Edge& e = lattice.edge(vertex + lattice.offset(at));
        at = half(at + (e.v == at ? e.left : e.right()));
    } while (at != spokes[0]);
    return spokes;
}

/// Find the fans in these columns and compare them with walks. Returns the most edges of a vertex.
int check(const Lattice& lattice, int y, const std::vector<int>& columns, Fans& fans) {
    const auto n = int(columns.size());
    static std::vector<Vec> walked; // what was found before must not matter
    find_fans(lattice, y, columns.data(), n, walked, fans);
    EXPECT_EQ(int(fans.groups.size()), (n + fans_side_by_side - 1) / fans_side_by_side);
    int most = 0;
    for (int i = 0; i < int(fans.groups.size()) * fans_side_by_side; ++i) {
        const Fans::Group& group = fans.groups[size_t(i / fans_side_by_side)];
        const int k = i % fans_side_by_side;
        EXPECT_EQ(group.x[k], columns[size_t(std::min(i, n - 1))]);
        const auto expected = walk_round(lattice, lattice.vertex_site(group.x[k], y));
        const auto degree = int(expected.size());
        EXPECT_EQ(int(group.degree[k]), degree);
        EXPECT_LE(int(group.least), degree);
        EXPECT_GE(int(group.most), degree);
        // As far as anyone reads, also beyond a fan's end.
        for (int spoke = 0; spoke <= group.most; ++spoke)
            EXPECT_EQ(fans.spokes[size_t(int(group.first) + spoke * fans_side_by_side + k)],
                      expected[size_t(spoke % degree)]);
        most = std::max(most, degree);
    }
    for (const Fans::Group& group : fans.groups) {
        EXPECT_EQ(group.least, *std::min_element(group.degree, std::end(group.degree)));
        EXPECT_EQ(group.most, *std::max_element(group.degree, std::end(group.degree)));
        EXPECT_LE(group.first + size_t(group.most + 1) * fans_side_by_side + Fans::padding,
                  fans.spokes.size());
    }
    return most;
}

TEST(Fans, AreThoseOfWalksRoundEachVertex) {
    on_each_target([] {
        int most = 0;
        Fans fans;
        each_flipped_mesh([&](const Lattice& flipped, const std::vector<Face>&, Random& random) {
            Lattice lattice = flipped;
            lattice.find_first_edges(lattice.all());
            for (int y = 1; y + 1 < lattice.height(); ++y) {
                std::vector<int> all, some;
                for (int x = 1; x + 1 < lattice.width(); ++x) {
                    all.push_back(x);
                    if (random.below(3))
                        some.push_back(x);
                }
                most = std::max(most, check(lattice, y, all, fans));
                check(lattice, y, some, fans);
                check(lattice, y, {}, fans);
            }
        });
        EXPECT_GT(most, 12);
    });
}

TEST(Fans, OfLongRowsAreFound) {
    on_each_target([] {
        Random random(7);
        Lattice lattice;
        const int w = 150, h = 5;
        const auto guide = make_guide(Kind::noise, w, h, 7);
        lattice.start(w, h, guide.data(), true);
        flip_at_random(lattice, 600, random);
        lattice.find_first_edges(lattice.all());
        Fans fans;
        for (int n = 1; n <= w - 2; ++n) {
            std::vector<int> columns;
            for (int x = w - 1 - n; x < w - 1; ++x)
                columns.push_back(x);
            check(lattice, 1 + n % (h - 2), columns, fans);
        }
    });
}

} // namespace
} // namespace ddt::test
