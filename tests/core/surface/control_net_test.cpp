// SPDX-License-Identifier: Apache-2.0
#include "core/surface/control_net.h"

#include "core/base/float_mode.h"
#include "core/surface/edge_maker.h"
#include "core/triangulate/triangulate.h"
#include "tests/core/helpers.h"
#include "tests/core/surface/scene.h"
#include "tests/core/surface/slow_surface.h"
#include "tests/core/surface/whole_net.h"

namespace ddt::test {
namespace {

ControlNet make(const Scene& scene, Surface surface, const std::vector<float>& values,
                int channels = 1, int first = 0, int count = 1) {
    const DenormalsAreZero zero;
    ControlNet net;
    WholeEdges edges;
    set_all_vertices(scene.lattice, {values.data(), channels, first, count}, net);
    if (surface == Surface::patch)
        edges.make(scene.lattice, scene.all(), true, false, 0, net);
    return net;
}

std::vector<float> channel_of(const std::vector<float>& values, int channels, int channel) {
    std::vector<float> one;
    for (size_t i = size_t(channel); i < values.size(); i += size_t(channels))
        one.push_back(values[i]);
    return one;
}

TEST(ControlNet, EveryInstructionSetGivesTheBitsOfTheFormulas) {
    on_each_target([] {
        each_scene([](const Scene& scene, Random& random) {
            for (const Values kind : all_values) {
                const int channels = 6, first = 2, count = 4;
                const auto values = make_values(kind, scene.pixels() * channels, random);
                const ControlNet net = make(scene, Surface::patch, values, channels, first, count);
                for (int c = 0; c < count; ++c) {
                    const DenormalsAreZero zero;
                    const Lattice& l = scene.lattice;
                    const SlowSurface slow(scene.faces, l.width(), l.height(), Surface::patch,
                                           channel_of(values, channels, first + c));
                    for (int y = 0; y < l.height(); ++y)
                        for (int x = 0; x < l.width(); ++x)
                            ASSERT_EQ(bits_of(net.at(l.vertex_site(x, y))[c]),
                                      bits_of(slow.z({x, y})));
                    l.each_edge([&](int m) {
                        const EdgeView e = view(l, m);
                        const float expected = slow.e(e.a, e.b);
                        // The sign of a zero bend depends on the edge's direction and adds nothing.
                        if (expected == 0.0f)
                            ASSERT_EQ(net.at(m)[c], 0.0f);
                        else
                            ASSERT_EQ(bits_of(net.at(m)[c]), bits_of(expected));
                    });
                }
            }
        });
    });
}

TEST(ControlNet, SoftEdgesHaveTheBitsOfTheFormulas) {
    on_each_target([] {
        int some = 0;
        each_scene([&](const Scene& scene, Random& random) {
            const auto compare = [&](Values kind, Surface surface, float tau, Bounds bounds) {
                const Lattice& l = scene.lattice;
                const auto values = make_values(kind, scene.pixels(), random);
                ControlNet net = make(scene, Surface::linear, values);
                net.bounds = bounds;
                for (SiteRows* rows : {&net.soft.even, &net.soft.odd})
                    rows->numbers.assign(l.size(), 99.0f);
                const DenormalsAreZero zero;
                WholeEdges edges;
                edges.make(l, scene.all(), surface == Surface::patch, true, tau, net);
                SlowSurface slow(scene.faces, l.width(), l.height(), surface, values);
                slow.soften(l, tau, bounds);
                l.each_edge([&](int m) {
                    const EdgeView e = view(l, m);
                    ASSERT_EQ(net.soft_at(m)[0], slow.q(e.a, e.b));
                    some += slow.q(e.a, e.b) != 0.0f;
                });
            };
            for (const Values kind : all_values)
                for (const Surface surface : both_surfaces)
                    for (const Bounds bounds : all_bounds)
                        for (const float tau : {0.3f, 100.0f})
                            compare(kind, surface, tau, bounds);
        });
        EXPECT_GT(some, 1000);
    });
}

TEST(ControlNet, AGroupHasAsManyNumbersAsItHasChannels) {
    each_scene([](const Scene& scene, Random& random) {
        for (int count = 1; count <= group_size; ++count) {
            const auto values = make_values(Values::hdr, scene.pixels() * size_t(count), random);
            const ControlNet net = make(scene, Surface::patch, values, count, 0, count);
            const ControlNet linear = make(scene, Surface::linear, values, count, 0, count);
            const int first = scene.lattice.vertex_site(0, 0);
            ASSERT_EQ(net.at(first + 2) - net.at(first), count);
            ASSERT_EQ(net.at(first + 3) - net.at(first + 1), count);
            for (int c = 0; c < count; ++c) {
                const ControlNet one = make(scene, Surface::patch, channel_of(values, count, c));
                const auto check = [&](int s) {
                    ASSERT_EQ(bits_of(net.at(s)[c]), bits_of(one.at(s)[0]));
                };
                scene.lattice.each_edge(check);
                for (int y = 0; y < scene.lattice.height(); ++y)
                    for (int x = 0; x < scene.lattice.width(); ++x) {
                        const int s = scene.lattice.vertex_site(x, y);
                        check(s);
                        ASSERT_EQ(bits_of(linear.at(s)[c]), bits_of(net.at(s)[c]));
                    }
            }
        }
    });
}

TEST(ControlNet, BendsStayWithinTheirEdge) {
    int bent = 0, clamped = 0;
    each_scene([&](const Scene& scene, Random& random) {
        for (const Values kind : all_values) {
            const auto values = make_values(kind, scene.pixels(), random);
            const ControlNet net = make(scene, Surface::patch, values);
            scene.lattice.each_edge([&](int m) {
                const DenormalsAreZero zero;
                const Vec v = scene.lattice.edge(m).v;
                const float difference =
                    net.at(m + scene.lattice.offset(v))[0] - net.at(m - scene.lattice.offset(v))[0];
                const float e = net.at(m)[0];
                if (std::isfinite(difference))
                    ASSERT_LE(std::fabs(e), std::fabs(difference));
                else
                    ASSERT_EQ(e, 0.0f);
                bent += e != 0.0f;
                clamped += e != 0.0f && std::fabs(e) == std::fabs(difference);
            });
        }
    });
    EXPECT_GT(clamped, 100);
    EXPECT_GT(bent, clamped);
}

TEST(ControlNet, APlaneHasNoBends) {
    each_scene([](const Scene& scene, Random& random) {
        const float gx = float(random.between(-99, 99)), gy = float(random.between(-99, 99));
        std::vector<float> values;
        for (int y = 0; y < scene.lattice.height(); ++y)
            for (int x = 0; x < scene.lattice.width(); ++x)
                values.push_back((gx * float(x) + gy * float(y) + 3.0f) / 64.0f);
        const ControlNet net = make(scene, Surface::patch, values);
        scene.lattice.each_edge([&](int m) { ASSERT_EQ(net.at(m)[0], 0.0f); });
    });
}

TEST(ControlNet, NonFiniteValuesBendNothingFartherThanTheNextTriangle) {
    Random random(5);
    Scene scene(16, 14, 500, random);
    const auto clean = make_values(Values::unit, scene.pixels(), random);
    const ControlNet before = make(scene, Surface::patch, clean);
    const Pixel bad{7, 6};
    // A vertex that shares a triangle with the bad one has another gradient; edges that end in
    // such a vertex may bend otherwise, all others not.
    std::vector<Pixel> near;
    for (const Face& f : scene.faces)
        if (std::count(f.begin(), f.end(), bad))
            near.insert(near.end(), f.begin(), f.end());
    const auto is_near = [&](Pixel p) { return std::count(near.begin(), near.end(), p) != 0; };
    for (const float x : {std::nanf(""), std::numeric_limits<float>::infinity(), 3e38f}) {
        auto values = clean;
        values[size_t(bad.y * 16 + bad.x)] = x;
        const ControlNet after = make(scene, Surface::patch, values);
        int changed = 0;
        scene.lattice.each_edge([&](int m) {
            const EdgeView e = view(scene.lattice, m);
            ASSERT_TRUE(std::isfinite(after.at(m)[0]));
            const bool differs = bits_of(after.at(m)[0]) != bits_of(before.at(m)[0]);
            ASSERT_TRUE(!differs || is_near(e.a) || is_near(e.b));
            changed += differs;
        });
        EXPECT_GT(changed, 5);
    }
}

TEST(ControlNet, APartsEdgesBendAsInTheWhole) {
    Random random(7);
    Scene scene(20, 17, 800, random);
    const auto values = make_values(Values::unit, scene.pixels(), random);
    const ControlNet whole = make(scene, Surface::patch, values);
    for (int k = 0; k < 40; ++k) {
        Rect part;
        part.x0 = random.below(19);
        part.y0 = random.below(16);
        part.x1 = random.between(part.x0 + 1, 20);
        part.y1 = random.between(part.y0 + 1, 17);
        ControlNet net;
        WholeEdges edges;
        set_all_vertices(scene.lattice, {values.data(), 1, 0, 1}, net);
        edges.make(scene.lattice, part, true, false, 0, net);
        const auto inside = [&](Pixel p) {
            return p.x >= part.x0 && p.x < part.x1 && p.y >= part.y0 && p.y < part.y1;
        };
        scene.lattice.each_edge([&](int m) {
            const EdgeView e = view(scene.lattice, m);
            ASSERT_TRUE(!inside(e.a) || !inside(e.b) ||
                        bits_of(net.at(m)[0]) == bits_of(whole.at(m)[0]));
        });
        for (int y = 0; y < 17; ++y)
            for (int x = 0; x < 20; ++x)
                ASSERT_EQ(net.at(scene.lattice.vertex_site(x, y))[0], values[size_t(20 * y + x)]);
    }
}

TEST(ControlNet, RowsThatComeAsTheyAreNeededHaveTheBitsOfTheWhole) {
    constexpr int count = 3;
    on_each_target([] {
        each_scene([](const Scene& scene, Random& random) {
            Lattice l = scene.lattice;
            const EdgeRecipe recipe{true, true, 0.3f};
            for (const Values kind : all_values)
                for (const float last : {0.5f, 0x1p70f, std::nanf("")}) {
                    // What is made before a value that is not tame turns up need not know of it.
                    auto values = make_values(kind, scene.pixels() * count, random);
                    values.back() = last;
                    const DenormalsAreZero zero;
                    ControlNet whole, rows;
                    const GroupValues group{values.data(), count, 0, count};
                    WholeEdges of_whole;
                    EdgeMaker of_rows;
                    set_all_vertices(l, group, whole);
                    of_whole.make(l, scene.all(), recipe.bend, recipe.soft, recipe.tau, whole);
                    of_rows.begin_rows(l, scene.all(), recipe, group, rows);
                    for (int y = 0; y <= l.height(); ++y)
                        of_rows.to_row(y, 0);
                    for (int c = 0; c < count; ++c) {
                        l.each_edge([&](int m) {
                            ASSERT_EQ(bits_of(rows.at(m)[c]), bits_of(whole.at(m)[c]));
                            // 0 of edges that cannot be flipped has the sign of anything.
                            ASSERT_EQ(rows.soft_at(m)[c], whole.soft_at(m)[c]);
                        });
                        for (int y = 0; y < l.height(); ++y)
                            for (int x = 0; x < l.width(); ++x) {
                                const int s = l.vertex_site(x, y);
                                ASSERT_EQ(bits_of(rows.at(s)[c]), bits_of(whole.at(s)[c]));
                            }
                    }
                }
        });
    });
}

TEST(ControlNet, WhatTheMemoryHeldBeforeDoesNotMatter) {
    Random random(6);
    ControlNet net;
    WholeEdges edges;
    for (const Pixel size : {Pixel{9, 12}, Pixel{4, 3}, Pixel{12, 9}}) {
        Scene scene(size.x, size.y, 100, random);
        const auto values = make_values(Values::unit, scene.pixels(), random);
        set_all_vertices(scene.lattice, {values.data(), 1, 0, 1}, net);
        edges.make(scene.lattice, scene.all(), true, false, 0, net);
        const ControlNet fresh = make(scene, Surface::patch, values);
        scene.lattice.each_edge(
            [&](int m) { ASSERT_EQ(bits_of(net.at(m)[0]), bits_of(fresh.at(m)[0])); });
    }
}

} // namespace
} // namespace ddt::test
