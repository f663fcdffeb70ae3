// SPDX-License-Identifier: Apache-2.0
#include "core/surface/fitted/fitted_maker.h"

#include <cmath>
#include <functional>

#include "core/base/float_mode.h"
#include "core/surface/fitted/scalar.h"
#include "core/triangulate/triangulate.h"
#include "ddt/option_table.h"
#include "tests/core/helpers.h"
#include "tests/core/surface/consistency/whole_rounds.h"
#include "tests/core/surface/scene.h"
#include "tests/core/surface/whole_net.h"

namespace ddt::test {
namespace {

using Edge1 = scalar::EdgeFeatures<float>;
using scalar::Place;

/// The features of an edge of a picture without a rim.
Edge1 features_of(Vec v, Vec left, Vec right, float e, const std::function<float(int, int)>& tap) {
    Edge1 f;
    const auto at = [&](Place p) { return tap(p.x, p.y); };
    f.find(Place{3, 5}, {v.x, v.y}, {left.x, left.y}, {right.x, right.y}, e, at);
    return f;
}

/// Something like noise, of both coordinates.
float noise(int x, int y) {
    Random random(uint64_t(x + 1000) * 4001 + uint64_t(y + 1000));
    return random.unit();
}

/// An edge of a mesh with the same diagonal everywhere; the right apex is opposite to the left.
struct Regular {
    Vec v, left;
};
constexpr int regular_count = 6;
Regular regular(int i) {
    // In cells divided from the upper left to the lower right, then in the others.
    const Regular all[regular_count] = {{{1, 0}, {1, 2}},  {{0, 1}, {-2, -1}}, {{1, 1}, {-1, 1}},
                                        {{1, 0}, {-1, 2}}, {{0, 1}, {-2, 1}},  {{1, -1}, {1, 1}}};
    return all[i];
}

TEST(Fitted, NullFeaturesVanishWhereThePictureVariesAlongOneAxisOnly) {
    for (int i = 0; i < regular_count; ++i) {
        const Regular e = regular(i);
        const bool down = i < regular_count / 2;
        const std::function<float(int, int)> pictures[] = {
            [](int x, int) { return noise(x, 0); },
            [](int, int y) { return noise(0, y); },
            // Along the cells' diagonals: where the picture runs the other way, so do they.
            [=](int x, int y) { return noise(down ? x - y : x + y, 0); },
        };
        for (const auto& picture : pictures) {
            const Edge1 f = features_of(e.v, e.left, -e.left, 0, picture);
            for (const float g : f.null)
                EXPECT_NEAR(g, 0.0f, 1e-6f) << i;
        }
        const Edge1 f = features_of(e.v, e.left, -e.left, 0, noise);
        for (const float g : f.null)
            EXPECT_GT(std::fabs(g), 1e-3f) << i;
    }
}

TEST(Fitted, AnEdgeIsTheSameFromItsOtherEnd) {
    const Vec v(2, 1), left(0, 1), right(2, -1);
    Edge1 there, back;
    const auto at = [](Place p) { return noise(p.x, p.y); };
    const Place l{left.x, left.y}, r{right.x, right.y};
    there.find(Place{3, 5}, {v.x, v.y}, l, r, 0.5f, at);
    back.find(Place{5, 6}, {-v.x, -v.y}, r, l, 0.5f, at);
    for (int k = 0; k < fitted_edge_null; ++k)
        EXPECT_EQ(bits_of(there.null[k]), bits_of(back.null[k]));
    for (int k = 0; k < fitted_edge_shared; ++k)
        EXPECT_EQ(bits_of(there.shared[k]), bits_of(back.shared[k]));
    EXPECT_EQ(there.range, back.range);
}

/// A net's vertices and edges.
struct NetValues {
    std::vector<float> z, e;
};

/// Of each of some channels, which are made together.
std::vector<NetValues> fitted(const Scene& scene, const std::vector<std::vector<float>>& channels,
                              bool clipped) {
    const DenormalsAreZero zero;
    const Lattice& l = scene.lattice;
    ControlNet net;
    FittedMaker maker;
    const auto count = int(channels.size());
    std::vector<float> values;
    for (size_t i = 0; i < scene.pixels(); ++i)
        for (const auto& channel : channels)
            values.push_back(channel[i]);
    values.resize(values.size() + group_size);
    maker.begin(l, scene.all(), {0, Bounds::dark, {0.25f, clipped}},
                {values.data(), count, 0, count}, net);
    maker.to_row(l.height(), 0);
    std::vector<NetValues> results(channels.size());
    for (size_t c = 0; c < channels.size(); ++c) {
        for (int y = 0; y < l.height(); ++y)
            for (int x = 0; x < l.width(); ++x)
                results[c].z.push_back(net.at(l.vertex_site(x, y))[c]);
        l.each_edge([&](int m) { results[c].e.push_back(net.at(m)[c]); });
    }
    return results;
}

NetValues fitted(const Scene& scene, const std::vector<float>& values, bool clipped) {
    return fitted(scene, std::vector<std::vector<float>>{values}, clipped)[0];
}

/// The same one number after the other, from the formulas for scalars.
NetValues slow(const Scene& scene, const std::vector<float>& values, bool clipped) {
    const DenormalsAreZero zero;
    const FittedTable& table = fitted_table();
    const Lattice& l = scene.lattice;
    const int w = l.width(), h = l.height();
    ControlNet net;
    WholeEdges edges;
    WholeRounds consistency;
    set_all_vertices(l, {values.data(), 1, 0, 1}, net);
    consistency.begin(l, net, {0.25f, clipped});
    edges.make(l, scene.all(), true, false, 0, net);
    consistency.measure(l, Surface::patch, net);
    const auto inside = [&](int x, int y) { return values[size_t(y * w + x)]; };
    const auto tap = [&](int x, int y) {
        return scalar::odd_mirror_tap<float>(x, y, w, h, inside);
    };
    NetValues r;
    std::vector<float> index;
    const Correction limits{0.25f, clipped};
    for (int y = 0; y < h; ++y) {
        for (int x = 0; x < w; ++x) {
            const size_t at = size_t(y * w + x);
            const auto near = [&](int i, int j) { return tap(x + i, y + j); };
            scalar::VertexFeatures<float> v;
            v.find(0.0f - consistency.sum()[at] * 0.25f,
                   scalar::all_pixels(x, y, w, h) && limits.clipped, table, near);
            float low, high;
            scalar::find_limits({-1, -1, 2, 2}, scalar::fitted_limit(limits.limit, v.bound, table),
                                limits.clipped, near, low, high);
            const float moved = scalar::fitted_vertex(inside(x, y), 1.0f, low, high, v, table);
            const bool rim = x == 0 || y == 0 || x + 1 == w || y + 1 == h;
            r.z.push_back(rim ? inside(x, y) : moved);
            index.push_back(v.index);
        }
    }
    l.each_edge([&](int m) {
        const Edge& e = l.edge(m);
        const EdgeView ends = view(l, m);
        const Vec other = e.right(), left = e.left.zero() ? -other : e.left,
                  right = other.zero() ? -e.left : other;
        Edge1 f;
        f.find(Place{ends.a.x, ends.a.y}, {e.v.x, e.v.y}, {left.x, left.y}, {right.x, right.y},
               net.at(m)[0], [&](Place p) { return tap(p.x, p.y); });
        const auto& kinds = table.null[fitted_length(e.v.x, e.v.y)];
        const float gain = l.gain(m);
        const float t = 1.0f + (gain < 0.0f ? gain : 0.0f) * table.gain_scale;
        const float near = t > 0.0f ? t : 0.0f;
        const auto null = [&](int k, int i) {
            return e.flippable() ? kinds[1][k][i] + near * kinds[2][k][i] : kinds[0][k][i];
        };
        const float mean =
            (index[size_t(ends.a.y * w + ends.a.x)] + index[size_t(ends.b.y * w + ends.b.x)]) *
            0.5f;
        r.e.push_back(scalar::fitted_bend(f, mean, null, table));
    });
    return r;
}

TEST(Fitted, EveryInstructionSetGivesTheBitsOfTheDefinition) {
    each_scene([](const Scene& scene, Random& random) {
        for (const Values kind : all_values)
            for (const bool clipped : {true, false}) {
                const auto values = make_values(kind, scene.pixels(), random);
                const NetValues expected = slow(scene, values, clipped);
                on_each_target([&] {
                    const NetValues got = fitted(scene, values, clipped);
                    ASSERT_EQ(differing(got.z, expected.z), 0u);
                    ASSERT_EQ(differing(got.e, expected.e), 0u);
                });
            }
    });
}

TEST(Fitted, NeighbouringEdgesThatAreMadeTogetherHaveTheBitsOfTheDefinition) {
    Random random(17);
    for (const int flips : {0, 40, 2000})
        for (const size_t count : {1, 2, 3, 4})
            for (const Values kind : all_values) {
                SCOPED_TRACE(::testing::Message() << flips << " flips, " << count << " channels");
                const Scene scene(61, 15, flips, random);
                std::vector<std::vector<float>> channels;
                std::vector<NetValues> expected;
                for (size_t c = 0; c < count; ++c) {
                    channels.push_back(make_values(kind, scene.pixels(), random));
                    expected.push_back(slow(scene, channels[c], true));
                }
                on_each_target([&] {
                    const auto got = fitted(scene, channels, true);
                    for (size_t c = 0; c < count; ++c) {
                        ASSERT_EQ(differing(got[c].z, expected[c].z), 0u);
                        ASSERT_EQ(differing(got[c].e, expected[c].e), 0u);
                    }
                });
            }
}

// Beyond the rim, where the picture goes on as its odd mirror image, there is black and white.
TEST(Fitted, GreyAtTheRimDoesNotStandAtABound) {
    Random random(8);
    const Scene scene(16, 14, 60, random);
    const auto values = fill(scene.pixels(), [&] { return random.below(2) ? 0.7f : 0.4f; });
    for (const float z : fitted(scene, values, true).z) {
        EXPECT_GE(z, 0.4f - 0.25f * 0.3f - 1e-6f);
        EXPECT_LE(z, 0.7f + 0.25f * 0.3f + 1e-6f);
    }
}

TEST(Fitted, WhatIsNotFiniteKeepsThePlainValue) {
    Random random(4);
    Scene scene(16, 14, 100, random);
    auto values = fill(scene.pixels(), [&] { return 2.0f + random.unit(); });
    values[7 * 16 + 8] = std::nanf("");
    values[3 * 16 + 3] = HUGE_VALF;
    const NetValues r = fitted(scene, values, true);
    for (size_t i = 0; i < values.size(); ++i)
        if (std::isfinite(values[i]))
            EXPECT_TRUE(std::isfinite(r.z[i])) << i;
        else
            EXPECT_EQ(std::isnan(r.z[i]), std::isnan(values[i])) << i;
    for (const float e : r.e)
        EXPECT_TRUE(std::isfinite(e));
}

/// Straight contours: where u is the same.
struct Contour {
    const char* name;
    int (*u)(int x, int y);
};

/// Values along such a contour differ by less, however they are rounded: numbers are about 1.
constexpr float unevenness = 1e-6f;

TEST(Fitted, AContourThatIsLevelUprightOrDiagonalStaysEven) {
    constexpr int size = 48, factor = 4;
    const Contour contours[] = {
        {"horizontal", [](int, int y) { return y; }},
        {"vertical", [](int x, int) { return x; }},
        {"falling", [](int x, int y) { return x - y + 24; }},
        {"rising", [](int x, int y) { return x + y - 24; }},
    };
    const std::function<float(int)> profiles[] = {
        [](int u) { return u < 24 ? 0.2f : 0.9f; }, // a step
        [](int u) { return u < 24   ? 0.1f
                           : u > 24 ? 0.8f
                                    : 0.5f; }, // a soft one
        [](int u) { return u == 24 ? 0.0f : 1.0f; },                // a line
        [](int u) { return u == 24 || u == 25 ? 0.9f
                           : u == 26          ? 0.6f
                                              : 0.2f; }, // a wider one
        [](int u) { return std::min(1.0f, std::max(0.0f, float(u - 20) / 8)); }, // a ramp
    };
    FilterOptions options;
    std::string error;
    ASSERT_TRUE(parse_filter("ddt-sharp,fitted=1,clipped=1", options, error)) << error;
    for (const Contour& contour : contours)
        for (size_t k = 0; k < std::size(profiles); ++k) {
            std::vector<float> values, large(size * factor * size * factor);
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x)
                    values.push_back(profiles[k](contour.u(x, y)));
            ASSERT_EQ(enlarge(values.data(), size, size, 1, nullptr, large.data(), size * factor,
                              size * factor, options.surface, options.mesh, 1, nullptr),
                      Outcome::done);
            // By where a position lies across the contour, away from the picture's rim.
            std::map<int, std::pair<float, float>> ranges;
            constexpr int rim = 10 * factor;
            for (int y = rim; y < (size - 10) * factor; ++y)
                for (int x = rim; x < (size - 10) * factor; ++x) {
                    const float v = large[size_t(y * size * factor + x)];
                    const auto range = ranges.emplace(contour.u(x, y), std::make_pair(v, v)).first;
                    range->second.first = std::min(range->second.first, v);
                    range->second.second = std::max(range->second.second, v);
                }
            for (const auto& range : ranges)
                EXPECT_LT(range.second.second - range.second.first, unevenness)
                    << contour.name << " profile " << k << " at " << range.first;
        }
}

} // namespace
} // namespace ddt::test
