// SPDX-License-Identifier: Apache-2.0
#include "core/surface/consistency/consistency.h"

#include "core/base/float_mode.h"
#include "core/surface/fitted/scalar.h"
#include "core/triangulate/triangulate.h"
#include "tests/core/helpers.h"
#include "tests/core/surface/consistency/whole_rounds.h"
#include "tests/core/surface/scene.h"
#include "tests/core/surface/slow_surface.h"
#include "tests/core/surface/whole_net.h"

namespace ddt::test {
namespace {

struct Shape {
    Surface surface = Surface::patch;
    float tau = 0;
    float limit = 0.25f;
    bool clipped = false;
    float strength = 1;
};

/// The vertices after some rounds; values: `count` channels a pixel, as what is returned.
std::vector<float> corrected(const Scene& scene, const std::vector<float>& values, Shape shape,
                             int rounds, int count = 1) {
    const DenormalsAreZero zero;
    const Lattice& l = scene.lattice;
    ControlNet net;
    net.bounds = Bounds::dark;
    WholeEdges edges;
    WholeRounds consistency;
    set_all_vertices(l, {values.data(), count, 0, count}, net);
    consistency.begin(l, net, {shape.limit, shape.clipped, shape.strength});
    for (int i = 0; i < rounds; ++i) {
        const bool bend = shape.surface == Surface::patch, soft = shape.tau > 0;
        if (bend || soft)
            edges.make(l, scene.all(), bend, soft, shape.tau, net);
        consistency.correct(l, shape.surface, net);
    }
    std::vector<float> result;
    for (int y = 0; y < l.height(); ++y)
        for (int x = 0; x < l.width(); ++x)
            result.insert(result.end(), net.at(l.vertex_site(x, y)),
                          net.at(l.vertex_site(x, y)) + count);
    return result;
}

/// One round by the definition: the mean over each inner pixel's area at 16 positions.
std::vector<float> slow_round(const Scene& scene, const std::vector<float>& source,
                              const std::vector<float>& values, Shape shape) {
    const DenormalsAreZero zero;
    const Lattice& l = scene.lattice;
    SlowSurface slow(scene.faces, l.width(), l.height(), shape.surface, values);
    if (shape.tau > 0)
        slow.soften(l, shape.tau, Bounds::dark);
    auto result = values;
    for (int y = 1; y + 1 < l.height(); ++y)
        for (int x = 1; x + 1 < l.width(); ++x) {
            double sum = 0;
            for (const int dy : {-3, -1, 1, 3})
                for (const int dx : {-3, -1, 1, 3}) {
                    const Point p{x * position_one + dx * position_one / 8,
                                  y * position_one + dy * position_one / 8};
                    const Face& f = scene.faces[size_t(find_face(scene.faces, p))];
                    int32_t w[3];
                    for (size_t k = 0; k < 3; ++k) {
                        const Pixel a = f[(k + 1) % 3], d = f[(k + 2) % 3] - a;
                        w[k] = d.x * (p.y - a.y * position_one) - d.y * (p.x - a.x * position_one);
                    }
                    sum += double(slow.at(f, w));
                }
            const auto at = [&](int i, int j) { return size_t(j * l.width() + i); };
            float low = HUGE_VALF, high = -HUGE_VALF;
            for (int j = y - 1; j <= y + 1; ++j)
                for (int i = x - 1; i <= x + 1; ++i) {
                    low = std::min(low, source[at(i, j)]);
                    high = std::max(high, source[at(i, j)]);
                }
            const float margin = shape.limit * (high - low);
            const auto z = double(values[at(x, y)]);
            const double to = double(source[at(x, y)]) - double(shape.strength) * (sum / 16 - z);
            result[at(x, y)] =
                float(std::clamp(to, double(low) - double(margin), double(high) + double(margin)));
        }
    return result;
}

/// Values well above 0, so that the rule about negative ones has nothing to do.
std::vector<float> bright(const Scene& scene, Random& random) {
    return fill(scene.pixels(), [&] { return 2.0f + random.unit(); });
}

TEST(Consistency, ARoundIsWhatItsDefinitionSays) {
    each_scene([](const Scene& scene, Random& random) {
        for (const Surface surface : both_surfaces)
            for (const float tau : {0.0f, 0.5f})
                for (const auto& [limit, strength] :
                     {std::pair(0.25f, 1.0f), {0.0f, 1.0f}, {10.0f, 0.3f}, {10.0f, 1.0f}}) {
                    const Shape shape{surface, tau, limit, false, strength};
                    const auto source = bright(scene, random);
                    auto expected = source;
                    for (int rounds = 1; rounds <= 2; ++rounds) {
                        expected = slow_round(scene, source, expected, shape);
                        const auto got = corrected(scene, source, shape, rounds);
                        for (size_t i = 0; i < got.size(); ++i)
                            ASSERT_NEAR(got[i], expected[i], 2e-5f);
                    }
                }
    });
}

TEST(Consistency, EveryInstructionSetGivesTheSameBits) {
    Random random(2);
    Scene scene(17, 13, 300, random);
    for (const Surface surface : both_surfaces)
        for (const float tau : {0.0f, 0.5f})
            for (const Values kind : all_values) {
                const auto source = make_values(kind, scene.pixels(), random);
                const Shape shape{surface, tau, 0.25f};
                const auto expected = corrected(scene, source, shape, 2);
                on_each_target([&] {
                    ASSERT_EQ(differing(corrected(scene, source, shape, 2), expected), 0u);
                });
            }
}

/// Values of other channels, finite or not, change nothing.
TEST(Consistency, EveryChannelIsWorkedOnAsIfAlone) {
    Random random(3);
    Scene scene(19, 12, 400, random);
    for (const Surface surface : both_surfaces)
        for (const float tau : {0.0f, 0.5f})
            for (int count = 2; count <= group_size; ++count) {
                const Shape shape{surface, tau, 0.25f};
                std::vector<float> together(scene.pixels() * size_t(count)), expected = together;
                for (int c = 0; c < count; ++c) {
                    const Values kind = all_values[random.below(int(std::size(all_values)))];
                    const auto source = make_values(kind, scene.pixels(), random);
                    const auto alone = corrected(scene, source, shape, 2);
                    for (size_t i = 0; i < source.size(); ++i) {
                        together[i * size_t(count) + size_t(c)] = source[i];
                        expected[i * size_t(count) + size_t(c)] = alone[i];
                    }
                }
                on_each_target([&] {
                    ASSERT_EQ(differing(corrected(scene, together, shape, 2, count), expected), 0u);
                });
            }
}

TEST(Consistency, AreaMeansComeCloserToThePixels) {
    Random random(3);
    Scene scene(20, 20, 0, random);
    const auto source = bright(scene, random);
    Shape shape;
    shape.limit = 100.0f;
    const auto error = [&](int rounds) {
        // What the next round would still move.
        const auto now = corrected(scene, source, shape, rounds);
        const auto next = corrected(scene, source, shape, rounds + 1);
        double sum = 0;
        for (size_t i = 0; i < now.size(); ++i)
            sum += std::fabs(double(next[i]) - double(now[i]));
        return sum;
    };
    EXPECT_LT(error(1), 0.7 * error(0));
    EXPECT_LT(error(2), 0.7 * error(1));
}

TEST(Consistency, APlaneIsLeftAlone) {
    each_scene([](const Scene& scene, Random& random) {
        const float gx = float(random.between(-9, 9)), gy = float(random.between(-9, 9));
        std::vector<float> plane;
        for (int y = 0; y < scene.lattice.height(); ++y)
            for (int x = 0; x < scene.lattice.width(); ++x)
                plane.push_back((gx * float(x) + gy * float(y) + 3.0f) / 8.0f);
        for (const Surface surface : both_surfaces)
            for (const float tau : {0.0f, 0.5f})
                ASSERT_EQ(differing(corrected(scene, plane, {surface, tau, 0.25f}, 2), plane), 0u);
    });
}

TEST(Consistency, TheRimStaysAndTheRestIsLimited) {
    each_scene([](const Scene& scene, Random& random) {
        const int w = scene.lattice.width(), h = scene.lattice.height();
        for (const float limit : {0.0f, 0.25f}) {
            // Some of it black: nothing gets negative there.
            const auto source =
                fill(scene.pixels(), [&] { return random.below(2) ? 0.0f : random.unit(); });
            const auto moved = corrected(scene, source, {Surface::patch, 0, limit}, 3);
            for (int y = 0; y < h; ++y)
                for (int x = 0; x < w; ++x) {
                    const float v = moved[size_t(y * w + x)];
                    if (x == 0 || y == 0 || x + 1 == w || y + 1 == h) {
                        ASSERT_EQ(v, source[size_t(y * w + x)]);
                        continue;
                    }
                    float low = HUGE_VALF, high = -HUGE_VALF;
                    for (int j = y - 1; j <= y + 1; ++j)
                        for (int i = x - 1; i <= x + 1; ++i) {
                            low = std::min(low, source[size_t(j * w + i)]);
                            high = std::max(high, source[size_t(j * w + i)]);
                        }
                    const float margin = limit * (high - low);
                    ASSERT_GE(v, std::max(0.0f, low - margin));
                    ASSERT_LE(v, high + margin);
                }
        }
    });
}

TEST(Consistency, WhatWillBeCutOffMayGetNegativeWithinTheLimit) {
    each_scene([](const Scene& scene, Random& random) {
        const int w = scene.lattice.width(), h = scene.lattice.height();
        const auto source =
            fill(scene.pixels(), [&] { return random.below(2) ? 0.0f : random.unit(); });
        for (const float limit : {0.0f, 0.25f}) {
            Shape shape{Surface::patch, 0, limit};
            const auto kept = corrected(scene, source, shape, 1);
            shape.clipped = true;
            const auto moved = corrected(scene, source, shape, 1);
            int negative = 0;
            for (int y = 1; y + 1 < h; ++y)
                for (int x = 1; x + 1 < w; ++x) {
                    const auto at = size_t(y * w + x);
                    float low = HUGE_VALF, high = -HUGE_VALF;
                    for (int j = y - 1; j <= y + 1; ++j)
                        for (int i = x - 1; i <= x + 1; ++i) {
                            low = std::min(low, source[size_t(j * w + i)]);
                            high = std::max(high, source[size_t(j * w + i)]);
                        }
                    ASSERT_GE(moved[at], low - limit * (high - low));
                    // One round starts from the same vertices: only the bound differs.
                    ASSERT_EQ(kept[at], std::max(moved[at], low - limit * low));
                    negative += moved[at] < 0;
                }
            if (limit == 0.0f || (w > 8 && h > 8)) {
                EXPECT_EQ(negative > 0, limit > 0.0f);
            }
        }
    });
}

// Cut off or not: greys beside white got specks of black, and only outlines in black are steeper by
// it.
TEST(Consistency, GreysKeepHalfOfTheDarkestOfThem) {
    each_scene([](const Scene& scene, Random& random) {
        const int w = scene.lattice.width(), h = scene.lattice.height();
        const auto source =
            fill(scene.pixels(), [&] { return random.below(2) ? 0.02f : random.unit() + 0.02f; });
        Shape shape;
        shape.clipped = true;
        const auto moved = corrected(scene, source, shape, 1);
        int at_bound = 0;
        for (int y = 1; y + 1 < h; ++y)
            for (int x = 1; x + 1 < w; ++x) {
                float low = HUGE_VALF;
                for (int j = y - 1; j <= y + 1; ++j)
                    for (int i = x - 1; i <= x + 1; ++i)
                        low = std::min(low, source[size_t(j * w + i)]);
                ASSERT_GE(moved[size_t(y * w + x)], 0.5f * low);
                at_bound += moved[size_t(y * w + x)] == 0.5f * low;
            }
        if (w > 8 && h > 8) {
            EXPECT_GT(at_bound, 0);
        }
    });
}

TEST(Consistency, ThereIsARampFromGreysToBlack) {
    for (const auto& [darkest, want] : {std::pair{0.5f, 0.25f},
                                        {1.0f / 64, 1.0f / 128},
                                        {1.0f / 128, 1.0f / 256 - 0.625f},
                                        {0.0f, -1.25f}}) {
        float low = darkest, high = 1.0f;
        scalar::widen(100.0f, true, 0.5f, low, high);
        EXPECT_EQ(low, want) << darkest;
    }
}

// What else gets a rim of another colour: here red falls further than green, by their neighbours.
TEST(Consistency, BesideALightHalfOfEachColourIsLeft) {
    Random random(5);
    Scene scene(12, 12, 60, random);
    std::vector<float> source;
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 12; ++x) {
            const bool light = x < 6, beside = x == 6;
            source.push_back(light ? 30.0f : beside ? 4.0f : 0.02f);
            source.push_back(light ? 30.0f : beside ? 2.5f : 0.5f);
        }
    const auto moved = corrected(scene, source, {Surface::patch, 0.3f}, 2, 2);
    int sunk = 0;
    for (int y = 1; y < 11; ++y)
        for (size_t c = 0; c < 2; ++c) {
            const size_t at = (size_t(y) * 12 + 6) * 2 + c;
            EXPECT_GE(moved[at], source[at] / 2);
            sunk += moved[at] == source[at] / 2;
        }
    EXPECT_GT(sunk, 10);
}

// Scene light has some that are a little below 0.
TEST(Consistency, BesideALightAPixelJustBelowZeroChangesLittle) {
    Random random(7);
    Scene scene(12, 12, 60, random);
    const auto beside = [&](float light, float dark) {
        std::vector<float> source;
        for (int y = 0; y < 12; ++y)
            for (int x = 0; x < 12; ++x)
                source.push_back(x < 6 ? light : x == 6 ? 4.0f : dark);
        return corrected(scene, source, {Surface::patch, 0.3f}, 2);
    };
    for (const float light : {30.0f, 3e4f, 3e7f, 3e10f}) {
        const auto black = beside(light, 0), negative = beside(light, -1e-6f);
        for (int y = 1; y < 11; ++y) {
            const size_t at = size_t(y) * 12 + 6;
            EXPECT_GE(negative[at], 1.9f) << light;
            EXPECT_NEAR(negative[at], black[at], 1e-4f) << light;
        }
    }
}

// At 1 an output pixel is as large as a source pixel, whose value it then has.
TEST(Consistency, IsStrongerTheSmallerOutputPixelsAre) {
    EXPECT_EQ(correction_strength({1, 1}), 0.0f);
    EXPECT_EQ(correction_strength({0.5, 0.9}), 0.0f);
    EXPECT_FLOAT_EQ(correction_strength({1.25, 1.25}), 0.4f);
    EXPECT_EQ(correction_strength({1, 4}), 0.5f);
    EXPECT_EQ(correction_strength({2, 2}), 1.0f);
    EXPECT_EQ(correction_strength({64, 3}), 1.0f);
    EXPECT_EQ(correction_strength({std::nan(""), std::nan("")}), 1.0f);
    Random random(6);
    Scene scene(12, 12, 60, random);
    const auto source = bright(scene, random);
    EXPECT_EQ(corrected(scene, source, {Surface::patch, 0.3f, 0.25f, false, 0}, 2), source);
}

TEST(Consistency, NonFiniteValuesMoveNothing) {
    Random random(4);
    Scene scene(12, 12, 100, random);
    auto source = bright(scene, random);
    const auto clean = corrected(scene, source, {}, 1);
    source[6 * 12 + 6] = std::nanf("");
    const auto moved = corrected(scene, source, {}, 1);
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 12; ++x) {
            const float v = moved[size_t(y * 12 + x)];
            if (x == 6 && y == 6)
                EXPECT_NE(v, v);
            else
                EXPECT_TRUE(std::isfinite(v));
        }
    EXPECT_EQ(bits_of(moved[12 + 1]), bits_of(clean[12 + 1]));
}

} // namespace
} // namespace ddt::test
