// SPDX-License-Identifier: Apache-2.0
#include "core/sample/evaluate.h"

#include <algorithm>
#include <cfloat>

#include "core/base/float_mode.h"
#include "core/triangulate/triangulate.h"
#include "tests/core/helpers.h"
#include "tests/core/sample/surface_reader.h"
#include "tests/core/surface/scene.h"
#include "tests/core/surface/slow_surface.h"

namespace ddt::test {
namespace {

/// A triangle whose closed area holds p: by the tie rule, on the hull's rim the first there is.
const Face& closed_face(const Scene& scene, Point p) {
    const int i = find_face(scene.faces, p);
    if (i >= 0)
        return scene.faces[size_t(i)];
    for (const Face& f : scene.faces) {
        bool holds = true;
        for (size_t k = 0; k < 3; ++k) {
            const Pixel a = f[k], d = f[(k + 1) % 3] - a;
            holds = holds && int64_t(d.x) * (p.y - a.y * position_one) >=
                                 int64_t(d.y) * (p.x - a.x * position_one);
        }
        if (holds)
            return f;
    }
    ADD_FAILURE() << "no triangle holds " << p.x << ' ' << p.y;
    return scene.faces[0];
}

/// The triangle that p is evaluated in. On the rim there may be several; which, locate() says.
Face face_at(const Scene& scene, Point p) {
    const int i = find_face(scene.faces, p);
    return i >= 0 ? scene.faces[size_t(i)]
                  : face_of_triangle(scene.lattice, locate(scene.lattice, p));
}

void weights_in(const Face& f, Point p, int32_t w[3]) {
    for (size_t k = 0; k < 3; ++k) {
        const Pixel a = f[(k + 1) % 3], d = f[(k + 2) % 3] - a;
        w[k] = d.x * (p.y - a.y * position_one) - d.y * (p.x - a.x * position_one);
    }
}

TEST(Evaluate, EveryInstructionSetGivesTheBitsOfTheFormulas) {
    on_each_target([] {
        each_scene([](const Scene& scene, Random& random) {
            const Lattice& l = scene.lattice;
            for (const Surface surface : both_surfaces)
                for (const Values kind : all_values) {
                    const auto values = make_values(kind, scene.pixels(), random);
                    SurfaceReader reader(scene, surface, values);
                    const DenormalsAreZero zero;
                    const SlowSurface slow(scene.faces, l.width(), l.height(), surface, values);
                    for (const Point p : make_points(l, 150, random)) {
                        const Face f = face_at(scene, p);
                        int32_t w[3];
                        weights_in(f, p, w);
                        const float r = reader.at(p), expected = slow.at(f, w);
                        ASSERT_EQ(bits_of(r), bits_of(expected)) << r << " not " << expected;
                    }
                }
        });
    });
}

/// A denormal as the zero it counts as: one may come through where a value is clamped to it.
float flushed(float x) {
    return std::fabs(x) < FLT_MIN ? std::copysign(0.0f, x) : x;
}

TEST(Evaluate, SoftEdgesHaveTheBitsOfTheFormulas) {
    on_each_target([] {
        int different = 0;
        each_scene([&](const Scene& scene, Random& random) {
            const Lattice& l = scene.lattice;
            for (const Surface surface : both_surfaces)
                for (const Values kind : all_values)
                    for (const Bounds bounds : all_bounds) {
                        const float tau = 1.0f;
                        const auto values = make_values(kind, scene.pixels(), random);
                        SurfaceReader reader(scene, surface, values, 1, 0, tau, bounds);
                        const DenormalsAreZero zero;
                        SlowSurface slow(scene.faces, l.width(), l.height(), surface, values);
                        const SlowSurface hard = slow;
                        slow.soften(l, tau, bounds);
                        for (const Point p : make_points(l, 100, random)) {
                            const Face f = face_at(scene, p);
                            int32_t w[3];
                            weights_in(f, p, w);
                            const float r = reader.at(p), expected = slow.at(f, w);
                            ASSERT_EQ(bits_of(flushed(r)), bits_of(flushed(expected)))
                                << r << " not " << expected;
                            different += bits_of(expected) != bits_of(hard.at(f, w));
                        }
                    }
        });
        EXPECT_GT(different, 1000);
    });
}

// Both triangles of an edge show the same in its middle, whatever else they are bounded by.
TEST(Evaluate, SoftEdgesDoNotJump) {
    each_scene([](const Scene& scene, Random& random) {
        const Lattice& l = scene.lattice;
        for (const Surface surface : both_surfaces)
            for (const Bounds bounds : all_bounds) {
                const float lowest = float(random.below(3) - 1) * 0.4f;
                const auto values = fill(scene.pixels(), [&] {
                    return random.below(3) ? 0.1f : random.below(2) ? lowest : 1.0f;
                });
                SurfaceReader reader(scene, surface, values, 1, 0, 1.0f, bounds);
                for (const int m : flippable_edges(l)) {
                    const EdgeView e = view(l, m);
                    const Point middle{(e.a.x + e.b.x) * position_one / 2,
                                       (e.a.y + e.b.y) * position_one / 2};
                    // Towards its apexes.
                    const Pixel across = e.left - e.right;
                    const float one = reader.at({middle.x + across.x, middle.y + across.y});
                    const float other = reader.at({middle.x - across.x, middle.y - across.y});
                    ASSERT_NEAR(one, other, 2e-3f) << m;
                }
            }
    });
}

TEST(Evaluate, SoftEdgesAtNoGainShowBothDiagonalsAlike) {
    // The middle of a cell: the mean of its four corners.
    Random random(3);
    Scene scene(2, 2, 0, random);
    scene.lattice.set_gain(scene.lattice.site(1, 1), 0.0f);
    SurfaceReader reader(scene, Surface::linear, {1, 2, 4, 16}, 1, 0, 0.3f, Bounds::dark);
    EXPECT_EQ(reader.at({position_one / 2, position_one / 2}), 5.75f);
}

TEST(Evaluate, AtAPixelThePixelComesBackWithSoftEdgesToo) {
    each_scene([](const Scene& scene, Random& random) {
        for (const Surface surface : both_surfaces) {
            auto values = make_values(Values::nonfinite, scene.pixels(), random);
            for (size_t i = 0; i < values.size(); i += 2)
                values[i] = -values[i];
            SurfaceReader reader(scene, surface, values, 1, 0, 10.0f, Bounds::none);
            for (int y = 0; y < scene.lattice.height(); ++y)
                for (int x = 0; x < scene.lattice.width(); ++x) {
                    const float z = values[size_t(y * scene.lattice.width() + x)];
                    const float r = reader.at({x * position_one, y * position_one});
                    ASSERT_TRUE(z == z ? r == z : bits_of(r) == 0x7fc00000u) << r << ' ' << z;
                }
        }
    });
}

TEST(Evaluate, StaysBetweenTheTrianglesThreeValues) {
    each_scene([](const Scene& scene, Random& random) {
        for (const Surface surface : both_surfaces)
            for (const Values kind : {Values::unit, Values::hdr, Values::wild}) {
                auto values = make_values(kind, scene.pixels(), random);
                if (kind == Values::wild)
                    for (size_t i = 0; i < values.size(); i += 5)
                        values[i] = i % 2 ? 1e38f : -1e38f;
                SurfaceReader reader(scene, surface, values);
                // Denormals count as 0.
                const auto z = [&](Pixel p) {
                    const float x = values[size_t(p.y * scene.lattice.width() + p.x)];
                    return std::fabs(x) < FLT_MIN ? 0.0f : x;
                };
                for (const Point p : make_points(scene.lattice, 400, random)) {
                    const Face& f = closed_face(scene, p);
                    float low = HUGE_VALF, high = -HUGE_VALF;
                    for (size_t k = 0; k < 3; ++k) {
                        low = std::min(low, z(f[k]));
                        high = std::max(high, z(f[k]));
                    }
                    const float r = reader.at(p);
                    ASSERT_GE(r, low);
                    ASSERT_LE(r, high);
                }
            }
    });
}

TEST(Evaluate, ThePatchIsNotThePlane) {
    // So that the tests of both surfaces do test two.
    Random random(8);
    Scene scene(12, 12, 100, random);
    const auto values = make_values(Values::unit, scene.pixels(), random);
    SurfaceReader linear(scene, Surface::linear, values), patch(scene, Surface::patch, values);
    int different = 0;
    for (const Point p : make_points(scene.lattice, 600, random))
        different += bits_of(linear.at(p)) != bits_of(patch.at(p));
    EXPECT_GT(different, 250);
}

TEST(Evaluate, APlaneIsReproducedExactly) {
    each_scene([](const Scene& scene, Random& random) {
        for (const Surface surface : both_surfaces) {
            // Few enough bits that weight times value and all sums fit a float.
            const int w = scene.lattice.width(), h = scene.lattice.height();
            const int gx = random.between(-1, 1), gy = random.between(-3, 3), c = 5;
            std::vector<float> values;
            for (int y = 0; y < h; ++y)
                for (int x = 0; x < w; ++x)
                    values.push_back(float(gx * x + gy * y + c) / 32.0f);
            SurfaceReader reader(scene, surface, values);
            for (const Point p : make_points(scene.lattice, 300, random)) {
                const double exact = (double(gx) * p.x + double(gy) * p.y + c * 65536.0) / 65536.0;
                ASSERT_EQ(double(reader.at(p)), exact / 32.0);
            }
        }
    });
}

TEST(Evaluate, AConstantIsReproducedExactly) {
    each_scene([](const Scene& scene, Random& random) {
        for (const Surface surface : both_surfaces)
            for (const float x : {0.1f, 1.0f / 3.0f, -7.77e5f, 1e38f, 1e-30f, 0.0f}) {
                SurfaceReader reader(scene, surface, std::vector<float>(scene.pixels(), x));
                for (const Point p : make_points(scene.lattice, 100, random))
                    ASSERT_EQ(reader.at(p), x);
            }
    });
}

TEST(Evaluate, AtAPixelThePixelComesBack) {
    each_scene([](const Scene& scene, Random& random) {
        for (const Surface surface : both_surfaces)
            for (const Values kind : all_values) {
                const auto values = make_values(kind, scene.pixels(), random);
                SurfaceReader reader(scene, surface, values);
                for (int y = 0; y < scene.lattice.height(); ++y)
                    for (int x = 0; x < scene.lattice.width(); ++x) {
                        const DenormalsAreZero zero;
                        const float z = values[size_t(y * scene.lattice.width() + x)];
                        const float r = reader.at({x * position_one, y * position_one});
                        if (z == z)
                            ASSERT_EQ(r, z);
                        else
                            ASSERT_EQ(bits_of(r), 0x7fc00000u);
                    }
            }
    });
}

TEST(Evaluate, NonFiniteValuesStayInTheTrianglesThatTouchThem) {
    each_scene([](const Scene& scene, Random& random) {
        const int width = scene.lattice.width();
        const float inf = std::numeric_limits<float>::infinity();
        const auto clean = make_values(Values::unit, scene.pixels(), random);
        for (const Surface surface : both_surfaces)
            for (const float x : {std::nanf(""), inf, -inf}) {
                const Pixel bad{random.below(width), random.below(scene.lattice.height())};
                auto values = clean;
                values[size_t(bad.y * width + bad.x)] = x;
                SurfaceReader reader(scene, surface, values);
                SurfaceReader before(scene, Surface::linear, clean);
                for (const Point p : make_points(scene.lattice, 300, random)) {
                    const Face& f = closed_face(scene, p);
                    int32_t w[3];
                    weights_in(f, p, w);
                    bool touched = false;
                    for (size_t k = 0; k < 3; ++k)
                        touched = touched || (f[k] == bad && w[k] != 0);
                    const float r = reader.at(p);
                    if (touched) {
                        ASSERT_EQ(bits_of(r), bits_of(x != x ? float_of(0x7fc00000) : x));
                        continue;
                    }
                    ASSERT_TRUE(std::isfinite(r));
                    ASSERT_GE(r, 0.0f);
                    ASSERT_LT(r, 1.0f);
                    // A weight of 0 is exactly nothing.
                    ASSERT_TRUE(surface == Surface::patch || std::fabs(r - before.at(p)) < 1e-7f);
                }
            }
    });
}

TEST(Evaluate, InfinitiesOfBothSignsMakeNaN) {
    Random random(9);
    Scene scene(2, 2, 0, random);
    const float inf = std::numeric_limits<float>::infinity();
    for (const Surface surface : both_surfaces) {
        SurfaceReader reader(scene, surface, {inf, -inf, -inf, inf});
        EXPECT_EQ(bits_of(reader.at({20000, 30000})), 0x7fc00000u);
        EXPECT_EQ(reader.at({0, 0}), inf);
    }
}

TEST(Evaluate, NearestChannelsAreCopiedBitForBit) {
    each_scene([](const Scene& scene, Random& random) {
        const int channels = 6, width = scene.lattice.width();
        // Any 32 bits: denormals, NaN with payloads, signalling ones.
        auto values = fill(scene.pixels() * channels, [&] {
            const auto bits = uint32_t(random.bits());
            return float_of(random.below(3) ? bits : bits | 0x7f800000u);
        });
        const NearestMask nearest = 0b110010;
        for (size_t i = 0; i < values.size(); ++i)
            if (!(nearest >> (i % channels) & 1))
                values[i] = random_value(random);
        for (const Surface surface : both_surfaces) {
            SurfaceReader reader(scene, surface, values, channels, nearest);
            SurfaceReader blend(scene, surface, values, channels, 0);
            for (const Point p : make_points(scene.lattice, 200, random)) {
                const Face f = face_of_triangle(scene.lattice, locate(scene.lattice, p));
                int32_t w[3];
                weights_in(f, p, w);
                // The largest weight; of equal ones the first.
                const auto k = size_t(std::max_element(w, w + 3) - w);
                const auto r = reader.row(&p, 1), b = blend.row(&p, 1);
                for (int c = 0; c < channels; ++c) {
                    const uint32_t z =
                        bits_of(values[size_t((f[k].y * width + f[k].x) * channels + c)]);
                    ASSERT_EQ(bits_of(r[size_t(c)]), nearest >> c & 1 ? z : bits_of(b[size_t(c)]));
                }
            }
        }
    });
}

TEST(Evaluate, ChannelsDoNotKnowOfOneAnother) {
    Random random(10);
    Scene scene(11, 9, 200, random);
    std::vector<Point> points;
    for (int i = 0; i < 50; ++i)
        points.push_back({i * 12345, 300000 + i * 777});
    for (const Surface surface : both_surfaces)
        for (const int channels : {1, 2, 3, 4, 5, 6, 7, 8, 9, 64}) {
            const auto values = make_values(Values::hdr, scene.pixels() * size_t(channels), random);
            const auto all = SurfaceReader(scene, surface, values, channels)
                                 .row(points.data(), int(points.size()));
            for (int c = 0; c < channels; ++c) {
                std::vector<float> one, expected;
                for (size_t i = 0; i < scene.pixels(); ++i)
                    one.push_back(values[i * size_t(channels) + size_t(c)]);
                for (size_t i = 0; i < points.size(); ++i)
                    expected.push_back(all[i * size_t(channels) + size_t(c)]);
                SurfaceReader reader(scene, surface, one);
                ASSERT_EQ(differing(reader.row(points.data(), int(points.size())), expected), 0u)
                    << channels << ' ' << c;
            }
        }
}

} // namespace
} // namespace ddt::test
