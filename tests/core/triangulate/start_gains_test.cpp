// SPDX-License-Identifier: Apache-2.0
#include "core/triangulate/start_gains.h"

#include <algorithm>

#include "core/guide/guide.h"
#include "core/triangulate/gain.h"
#include "tests/core/helpers.h"
#include "tests/core/triangulate/slow_mesh.h"

namespace ddt::test {
namespace {

std::vector<float> stepped(std::vector<float> guide, float scale) {
    for (float& v : guide)
        v = guide_step(v * scale);
    return guide;
}

/// Compare with the scalar twin, edge by edge.
void check(Lattice lattice, const Criterion& by, float min_gain) {
    Workspace w;
    Statistics statistics;
    ASSERT_TRUE(start_gains(lattice, by, min_gain, w, statistics));
    int64_t flippable = 0;
    ArenaVector<int> candidates;
    lattice.each_edge([&](int m) {
        float gain = no_gain;
        if (lattice.edge(m).flippable()) {
            ++flippable;
            gain = dispatch(
                by.cost, [&](auto c) { return scalar::gain<decltype(c)>(lattice, m, by.contour); });
            if (gain > min_gain)
                candidates.push_back(m);
        }
        ASSERT_EQ(bits_of(lattice.gain(m)), bits_of(gain))
            << "edge at " << m % lattice.stride() << ", " << m / lattice.stride();
    });
    std::sort(w.candidates.begin(), w.candidates.end());
    EXPECT_EQ(w.candidates, candidates);
    EXPECT_EQ(statistics.evaluations, flippable);
}

TEST(StartGains, AreThoseOfEveryEdge) {
    on_each_target([] {
        for (const auto& size : {Pixel{2, 2}, Pixel{2, 9}, Pixel{3, 3}, Pixel{9, 2}, Pixel{4, 5},
                                 Pixel{19, 7}, Pixel{35, 6}, Pixel{70, 9}})
            for (const bool flat : {false, true})
                for (const Kind kind : all_kinds)
                    for (const Cost cost : all_costs) {
                        const auto guide = stepped(make_guide(kind, size.x, size.y, 5), 1.0f);
                        Lattice lattice;
                        lattice.start(size.x, size.y, guide.data(), flat, true);
                        SCOPED_TRACE(::testing::Message()
                                     << size.x << " x " << size.y << ", flat " << flat << ", kind "
                                     << int(kind) << ", cost " << int(cost));
                        for (const float contour : {0.0f, 0.8f})
                            check(lattice, {cost, contour}, 5e-3f);
                    }
    });
}

/// Differences over the guide's whole range are exact still.
TEST(StartGains, AreExactAtTheEndsOfTheGuidesRange) {
    std::vector<float> guide;
    Random random(3);
    for (int i = 0; i < 40 * 12; ++i)
        guide.push_back(guide_step((random.unit() - 0.5f) * 8192.0f));
    Lattice lattice;
    lattice.start(40, 12, guide.data(), true, true);
    for (const Cost cost : all_costs)
        for (const float contour : {0.0f, most_contour})
            check(lattice, {cost, contour}, 0.1f);
}

TEST(StartGains, RefuseWhatIsNotInSteps) {
    auto guide = stepped(make_guide(Kind::noise, 21, 8, 5), 1.0f);
    Workspace w;
    Statistics statistics;
    Lattice lattice;
    for (const float odd : {0.1f, 2048.0f, -1024.5f}) {
        for (const size_t at : {size_t(0), size_t(21 * 8 - 1), size_t(70)}) {
            auto other = guide;
            other[at] = odd;
            lattice.start(21, 8, other.data(), true);
            EXPECT_FALSE(start_gains(lattice, Cost::abn, 0.0f, w, statistics)) << odd << " " << at;
        }
    }
    EXPECT_EQ(statistics.evaluations, 0);
}

TEST(StartGains, RefuseAMeshThatWasFlipped) {
    const auto guide = stepped(make_guide(Kind::noise, 21, 8, 5), 1.0f);
    Workspace w;
    Statistics statistics;
    Lattice lattice;
    lattice.start(21, 8, guide.data(), true);
    ASSERT_TRUE(start_gains(lattice, Cost::abn, 0.0f, w, statistics));
    lattice.flip(lattice.site(5, 5));
    EXPECT_FALSE(start_gains(lattice, Cost::abn, 0.0f, w, statistics));
    lattice.start(21, 8, guide.data(), true);
    EXPECT_TRUE(start_gains(lattice, Cost::abn, 0.0f, w, statistics));
}

} // namespace
} // namespace ddt::test
