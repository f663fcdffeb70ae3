// SPDX-License-Identifier: Apache-2.0
#include "core/lattice/lattice.h"

#include <numeric>
#include <set>

#include "tests/core/helpers.h"

namespace ddt::test {
namespace {

constexpr Pixel sizes[] = {{2, 2}, {2, 3}, {2, 9}, {11, 2}, {3, 3}, {5, 8}, {13, 7}};

/// Call f(lattice, random) for lattices of all sizes with both starts.
template <class F>
void each_start(F&& f) {
    uint64_t seed = 1;
    for (const Pixel size : sizes)
        for (const bool flat : {false, true}) {
            SCOPED_TRACE(::testing::Message() << size.x << " x " << size.y << ", flat " << flat);
            Lattice lattice;
            const auto guide = make_guide(Kind::noise, size.x, size.y, ++seed);
            lattice.start(size.x, size.y, guide.data(), flat);
            Random random(seed);
            f(lattice, random);
        }
}

TEST(Lattice, StartIsATriangulation) {
    each_start([](Lattice& lattice, Random&) { EXPECT_TRUE(is_triangulation(lattice)); });
}

TEST(Lattice, StartPutsTheDiagonalWhereItsEndsDifferLess) {
    for (const Kind kind : {Kind::noise, Kind::few}) {
        const int w = 17, h = 12;
        const auto guide = make_guide(kind, w, h, 5);
        const auto z = [&](int x, int y) { return guide[size_t(y * w + x)]; };
        Lattice flat, diagonal;
        flat.start(w, h, guide.data(), true);
        diagonal.start(w, h, guide.data(), false);
        int ties = 0;
        for (int y = 0; y + 1 < h; ++y)
            for (int x = 0; x + 1 < w; ++x) {
                const int m = flat.site(2 * x + 1, 2 * y + 1);
                const float down = std::fabs(z(x, y) - z(x + 1, y + 1));
                const float up = std::fabs(z(x + 1, y) - z(x, y + 1));
                const auto is_down = [&](const Lattice& l) {
                    return l.edge(m).v.x * l.edge(m).v.y > 0;
                };
                EXPECT_EQ(is_down(flat), down <= up) << x << ' ' << y;
                EXPECT_TRUE(is_down(diagonal));
                ties += down == up;
            }
        EXPECT_TRUE(kind == Kind::noise || ties > 10);
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x)
                EXPECT_EQ(flat.guide(flat.vertex_site(x, y)), z(x, y));
    }
}

TEST(Lattice, StartForgetsWhatWasBefore) {
    const auto large = make_guide(Kind::noise, 20, 15, 1), small = make_guide(Kind::noise, 7, 9, 2);
    Lattice used, fresh;
    used.start(20, 15, large.data(), true);
    Random random(3);
    flip_at_random(used, 300, random);
    used.start(7, 9, small.data(), true);
    fresh.start(7, 9, small.data(), true);
    EXPECT_EQ(used.size(), fresh.size());
    EXPECT_EQ(records(used), records(fresh));
    used.each_edge([&](int m) { EXPECT_EQ(used.gain(m), no_gain); });
}

TEST(Lattice, EachEdgeVisitsEveryHalfIntegerPointOnceInAddressOrder) {
    each_start([](Lattice& lattice, Random&) {
        std::vector<int> seen, expected;
        lattice.each_edge([&](int m) { seen.push_back(m); });
        for (int y = 0; y <= 2 * lattice.height() - 2; ++y)
            for (int x = 0; x <= 2 * lattice.width() - 2; ++x)
                if (x % 2 || y % 2)
                    expected.push_back(y * lattice.stride() + x);
        EXPECT_EQ(seen, expected);
        EXPECT_LT(size_t(seen.back()), lattice.size());
    });
}

TEST(Lattice, StaysATriangulationAfterEveryFlip) {
    each_start([](Lattice& lattice, Random& random) {
        for (int i = 0; i < 400; ++i) {
            const auto before = faces_of(lattice);
            const auto sites = flippable_edges(lattice);
            ASSERT_FALSE(sites.empty());
            const int m = sites[size_t(random.below(int(sites.size())))];
            const EdgeView e = view(lattice, m);
            lattice.flip(m);
            ASSERT_TRUE(is_triangulation(lattice)) << "after flip " << i;
            // The flipped edge joins the old apexes, and two triangles changed, no more.
            const EdgeView f = view(lattice, m);
            ASSERT_EQ(std::minmax(f.a, f.b), std::minmax(e.left, e.right));
            if (i % 16 == 0) {
                const auto after = faces_of(lattice);
                std::vector<Face> gone;
                std::set_difference(before.begin(), before.end(), after.begin(), after.end(),
                                    std::back_inserter(gone));
                ASSERT_EQ(gone.size(), 2u);
                ASSERT_EQ(after.size(), before.size());
            }
        }
    });
}

TEST(Lattice, FlippableMeansParallelogram) {
    each_start([](Lattice& lattice, Random& random) {
        flip_at_random(lattice, 150, random);
        lattice.each_edge([&](int m) {
            const EdgeView e = view(lattice, m);
            const bool both = e.has_left && e.has_right;
            EXPECT_EQ(lattice.edge(m).flippable(), both && e.a + e.b == e.left + e.right);
        });
    });
}

TEST(Lattice, FlippingTwiceRestores) {
    each_start([](Lattice& lattice, Random& random) {
        flip_at_random(lattice, 100, random);
        for (const int m : flippable_edges(lattice)) {
            const auto faces = faces_of(lattice);
            const auto before = records(lattice);
            lattice.flip(m);
            ASSERT_NE(faces_of(lattice), faces);
            lattice.flip(m);
            ASSERT_EQ(faces_of(lattice), faces);
            lattice.flip(m); // twice turns the edge's direction round,
            lattice.flip(m); // four times is the identity
            ASSERT_EQ(records(lattice), before);
        }
    });
}

TEST(Lattice, RegionIsTheTrianglesAroundAndSymmetric) {
    each_start([](Lattice& lattice, Random& random) {
        flip_at_random(lattice, 150, random);
        const auto faces = faces_of(lattice);
        const auto sites = flippable_edges(lattice);
        for (const int m : sites) {
            int calls = 0;
            std::set<int> region;
            lattice.each_of_region(m, [&](int other) {
                ++calls;
                region.insert(other);
            });
            ASSERT_EQ(region, slow_region(lattice, faces, m, 1));
            // Each triangle beyond the two has its other two sides told.
            const size_t beyond = slow_surroundings(lattice, faces, m, 1).size() - 2;
            ASSERT_EQ(size_t(calls), 4 + 2 * beyond);
            for (const int other : region)
                if (lattice.edge(other).flippable()) {
                    bool back = false;
                    lattice.each_of_region(other, [&](int x) { back |= x == m; });
                    ASSERT_TRUE(back);
                }
        }
    });
}

TEST(Lattice, OuterApexIsTheOtherEndBeyondTheSide) {
    each_start([](Lattice& lattice, Random& random) {
        flip_at_random(lattice, 100, random);
        for (const int m : flippable_edges(lattice)) {
            const Quad q(lattice.edge(m));
            ASSERT_EQ(det(q.v, q.w), 1);
            for (int k = 0; k < 4; ++k) {
                const int middle = m + lattice.offset(q.middle[k]);
                const EdgeView e = view(lattice, middle);
                const int x = middle % lattice.stride(), y = middle / lattice.stride();
                const Pixel inner{(x + q.inner[k].x) / 2, (y + q.inner[k].y) / 2};
                const bool left = e.has_left && e.left == inner;
                ASSERT_TRUE(left || (e.has_right && e.right == inner));
                const Vec outer = lattice.outer_apex(m, q, k);
                ASSERT_EQ(outer, left ? lattice.edge(middle).right() : lattice.edge(middle).left);
                ASSERT_TRUE(outer.zero() || det(q.side[k], outer) > 0);
            }
        }
    });
}

TEST(Lattice, FirstEdgeIsTheIncidentOneWithTheSmallestAddress) {
    each_start([](Lattice& lattice, Random& random) {
        flip_at_random(lattice, 200, random);
        std::vector<int> smallest(lattice.size(), std::numeric_limits<int>::max());
        lattice.each_edge([&](int m) {
            const EdgeView e = view(lattice, m);
            for (const Pixel p : {e.a, e.b}) {
                int& s = smallest[size_t(lattice.vertex_site(p.x, p.y))];
                s = std::min(s, m);
            }
        });
        lattice.find_first_edges(lattice.all());
        lattice.find_first_edges(lattice.all()); // what an earlier call found must not matter
        const auto check = [&](const Rect& part) {
            for (int y = part.y0; y < part.y1; ++y)
                for (int x = part.x0; x < part.x1; ++x) {
                    const int s = lattice.vertex_site(x, y);
                    ASSERT_EQ(s + lattice.offset(lattice.vertex(s).first), smallest[size_t(s)]);
                }
        };
        check(lattice.all());
        for (int y = 0; y < lattice.height(); ++y)
            for (int x = 0; x < lattice.width(); ++x)
                lattice.vertex(lattice.vertex_site(x, y)).first = {99, 99};
        const Rect part{lattice.width() / 3, lattice.height() / 4, lattice.width() / 2 + 1,
                        lattice.height() - 1};
        lattice.find_first_edges(part);
        check(part);
    });
}

TEST(Lattice, FirstEdgesThatAreWalkedFromAreFound) {
    each_start([](Lattice& lattice, Random& random) {
        const int w = lattice.width(), h = lattice.height();
        // From none to most of the cells crossed.
        for (const int flips : {0, 1, 3, 200}) {
            flip_at_random(lattice, flips, random);
            Lattice whole = lattice;
            whole.find_first_edges(whole.all());
            whole.find_divisions(whole.all());
            const auto is_walked = [&](int x, int y) {
                for (int cy = y - 1; cy <= y; ++cy)
                    for (int cx = x - 1; cx <= x; ++cx)
                        if (cx < 0 || cy < 0 || cx == w - 1 || cy == h - 1 ||
                            whole.divisions(cy)[cx] == Division::crossed)
                            return true;
                return false;
            };
            const auto check = [&](const Rect& part) {
                Lattice again = lattice;
                // What was found in another tile must not matter.
                again.find_divisions(again.all());
                std::fill_n(const_cast<Division*>(again.divisions(0)), (w - 1) * (h - 1),
                            Division::down);
                again.find_divisions(part);
                again.find_walked_first_edges(part);
                for (int y = part.y0; y < part.y1; ++y)
                    for (int x = part.x0; x < part.x1; ++x) {
                        const int s = whole.vertex_site(x, y);
                        if (is_walked(x, y)) {
                            ASSERT_EQ(again.vertex(s).first, whole.vertex(s).first);
                        }
                    }
            };
            on_each_target([&] {
                check(whole.all());
                check({w / 3, h / 4, w / 2 + 1, h - 1});
            });
        }
    });
}

TEST(Lattice, DivisionsOfAPartAreThoseOfTheWhole) {
    each_start([](Lattice& lattice, Random& random) {
        flip_at_random(lattice, 200, random);
        const Rect part{lattice.width() / 3, lattice.height() / 4, lattice.width() / 2 + 1,
                        lattice.height()};
        Lattice again = lattice;
        lattice.find_divisions(lattice.all());
        again.find_divisions(part);
        for (int y = std::max(part.y0 - 1, 0); y < std::min(part.y1, lattice.height() - 1); ++y)
            for (int x = std::max(part.x0 - 1, 0); x < std::min(part.x1, lattice.width() - 1); ++x)
                ASSERT_EQ(again.divisions(y)[x], lattice.divisions(y)[x]);
    });
}

TEST(Lattice, EdgesEndAtTheLongestThatFits) {
    for (const Pixel size : {Pixel{150, 2}, Pixel{2, 150}}) {
        Lattice lattice;
        const auto guide = make_guide(Kind::noise, size.x, size.y, 1);
        lattice.start(size.x, size.y, guide.data(), true);
        flip_to_longest(lattice);
        ASSERT_TRUE(is_triangulation(lattice));
        int longest = 0, refused = 0;
        lattice.each_edge([&](int m) {
            const Edge& e = lattice.edge(m);
            longest = std::max({longest, std::abs(int(e.v.x)), std::abs(int(e.v.y))});
            refused += !e.left.zero() && e.left == -e.right() && !e.flippable();
        });
        EXPECT_GE(longest, longest_edge - 1);
        EXPECT_GT(refused, 0);
    }
}

} // namespace
} // namespace ddt::test
