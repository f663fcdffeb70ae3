// SPDX-License-Identifier: Apache-2.0
#include "core/sample/evaluate.h"

#include <algorithm>
#include <cfloat>

#include "core/lattice/crossed_search.h"
#include "core/triangulate/triangulate.h"
#include "tests/core/helpers.h"
#include "tests/core/surface/slow_surface.h"

namespace ddt::test {
namespace {

constexpr Surface surfaces[] = {Surface::linear, Surface::patch};

/// A surface over a scene: nets of all its channels.
class Reader {
public:
    Reader(const Scene& scene, Surface surface, const std::vector<float>& values, int channels = 1,
           NearestMask nearest = 0, float tau = 0, bool strict = false)
        : m_scene(scene), m_surface(surface), m_channels(channels), m_nearest(nearest) {
        const DenormalsAreZero zero;
        EdgeMaker edges;
        for (int c = 0; c < channels; c += group_size) {
            m_nets.emplace_back();
            set_vertices(scene.lattice, values.data(), channels, c,
                         std::min(group_size, channels - c), m_nets.back());
            if (surface == Surface::patch)
                make_edges(scene.lattice, scene.all(), true, false, 0, edges, m_nets.back());
            if (tau > 0)
                make_edges(scene.lattice, scene.all(), false, true, tau, edges, m_nets.back());
            std::fill_n(m_nets.back().strict, group_size, strict ? 1.0f : 0.0f);
        }
        m_search.begin();
    }

    /// The channels at n positions that neighbour one another. What was located before may speed
    /// it up but not change it; `fresh`: nothing was.
    std::vector<float> row(const Point* points, int n, bool fresh = false) {
        const DenormalsAreZero zero;
        Search none;
        none.begin();
        LocatedRow& located = m_row;
        locate_row(m_scene.lattice, points, n, fresh ? none : m_search, located);
        const size_t size = size_t(n) * size_t(m_channels);
        constexpr float canary = -77.0f;
        std::vector<float> out(size + row_padding + 1, canary);
        for (int g = 0; g < int(m_nets.size()); ++g)
            evaluate_row(m_nets[size_t(g)], m_surface,
                         g < 8 ? m_nearest >> (g * group_size) & 15 : 0, located,
                         output_of(g, out.data(), 0));
        EXPECT_EQ(out.back(), canary);
        out.resize(size);
        return out;
    }
    float at(Point p) { return row(&p, 1)[0]; }

    /// The channels at all combinations of ascending x and y, by blocks of rows.
    std::vector<float> grid(const std::vector<int32_t>& x, const std::vector<int32_t>& y) {
        const DenormalsAreZero zero;
        Search search;
        search.begin();
        std::vector<Point> points;
        for (const int32_t px : x)
            points.push_back({px, 0});
        Columns columns;
        columns.find(points.data(), int(points.size()), m_scene.lattice.width());
        m_alike = columns.alike;
        m_blocks = m_together = m_crossed = m_mixed = 0;
        const size_t width = x.size() * size_t(m_channels), row = width + 3;
        constexpr float canary = -77.0f;
        std::vector<float> out(row * y.size(), canary);
        LocatedBlock block;
        for (size_t at = 0; at < y.size();) {
            const int rows = locate_block(m_scene.lattice, columns, points, y.data() + at,
                                          int(y.size() - at), search, block);
            EXPECT_GT(rows, 0);
            ++m_blocks;
            m_together += block.phases;
            m_crossed += !block.crossed.cells.empty();
            m_mixed += block.phases && !block.crossed.cells.empty();
            for (int g = 0; g < int(m_nets.size()); ++g)
                evaluate_block(m_nets[size_t(g)], m_surface, columns, block,
                               output_of(g, out.data() + at * row, row));
            at += size_t(rows);
        }
        std::vector<float> values;
        for (size_t at = 0; at < out.size(); at += row) {
            const auto begin = out.begin() + ptrdiff_t(at), end = begin + ptrdiff_t(width);
            values.insert(values.end(), begin, end);
            for (size_t i = width; i < row; ++i)
                EXPECT_EQ(out[at + i], canary); // what is between the rows is not the block's
        }
        return values;
    }

    /// Of the last grid(); of how many blocks they were evaluated together, of how many the
    /// crossed cells, and of how many both.
    const Columns::Alike& alike() const { return m_alike; }
    int blocks() const { return m_blocks; }
    int together() const { return m_together; }
    int crossed() const { return m_crossed; }
    int mixed() const { return m_mixed; }

private:
    GroupOutput output_of(int group, float* out, size_t row) const {
        const int first = group * group_size;
        return {out, row, m_channels, first, std::min(group_size, m_channels - first)};
    }

    const Scene& m_scene;
    Columns::Alike m_alike;
    int m_blocks = 0, m_together = 0, m_crossed = 0, m_mixed = 0;
    Surface m_surface;
    int m_channels;
    NearestMask m_nearest;
    std::vector<Net> m_nets;
    Search m_search;
    LocatedRow m_row;
};

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
            for (const Surface surface : surfaces)
                for (const Values kind : all_values) {
                    const auto values = make_values(kind, scene.pixels(), random);
                    Reader reader(scene, surface, values);
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
            for (const Surface surface : surfaces)
                for (const Values kind : all_values)
                    for (const bool strict : {false, true}) {
                        const float tau = 1.0f;
                        const auto values = make_values(kind, scene.pixels(), random);
                        Reader reader(scene, surface, values, 1, 0, tau, strict);
                        const DenormalsAreZero zero;
                        SlowSurface slow(scene.faces, l.width(), l.height(), surface, values);
                        const SlowSurface hard = slow;
                        slow.soften(l, tau, strict);
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

TEST(Evaluate, SoftEdgesAtNoGainShowBothDiagonalsAlike) {
    // The middle of a cell: the mean of its four corners.
    Random random(3);
    Scene scene(2, 2, 0, random);
    scene.lattice.set_gain(scene.lattice.site(1, 1), 0.0f);
    Reader reader(scene, Surface::linear, {1, 2, 4, 16}, 1, 0, 0.3f);
    EXPECT_EQ(reader.at({position_one / 2, position_one / 2}), 5.75f);
}

TEST(Evaluate, AtAPixelThePixelComesBackWithSoftEdgesToo) {
    each_scene([](const Scene& scene, Random& random) {
        for (const Surface surface : surfaces) {
            auto values = make_values(Values::nonfinite, scene.pixels(), random);
            for (size_t i = 0; i < values.size(); i += 2)
                values[i] = -values[i];
            Reader reader(scene, surface, values, 1, 0, 10.0f);
            for (int y = 0; y < scene.lattice.height(); ++y)
                for (int x = 0; x < scene.lattice.width(); ++x) {
                    const float z = values[size_t(y * scene.lattice.width() + x)];
                    const float r = reader.at({x * position_one, y * position_one});
                    ASSERT_TRUE(z == z ? r == z : bits_of(r) == 0x7fc00000u) << r << ' ' << z;
                }
        }
    });
}

TEST(Evaluate, ARowIsItsPositionsOneByOne) {
    each_scene([](const Scene& scene, Random& random) {
        const int right = (scene.lattice.width() - 1) * position_one;
        const int bottom = (scene.lattice.height() - 1) * position_one;
        for (const Surface surface : surfaces) {
            const auto values = make_values(Values::hdr, scene.pixels(), random);
            Reader reader(scene, surface, values);
            for (int k = 0; k < 60; ++k) {
                // Straight rows, sloping ones, along the rim, on lattice lines, small and large
                // steps.
                const int n = random.between(1, 60), step = 1 << random.between(0, 17);
                Point p{random.between(0, right), random.between(0, bottom)};
                if (k % 3 == 0)
                    p.y &= -position_one;
                if (k % 5 == 0)
                    p.x &= -(position_one / 4);
                const Point d{k % 2 ? step : -step, k % 4 < 2 ? 0 : random.between(-step, step)};
                std::vector<Point> points;
                for (int i = 0; i < n; ++i) {
                    points.push_back(p);
                    p.x = std::clamp(p.x + d.x, 0, right);
                    p.y = std::clamp(p.y + d.y, 0, bottom);
                }
                std::vector<float> expected;
                for (const Point q : points)
                    expected.push_back(reader.row(&q, 1, true)[0]);
                ASSERT_EQ(differing(reader.row(points.data(), n), expected), 0u);
                ASSERT_EQ(differing(reader.row(points.data(), n), expected), 0u); // known now
                // A row a little lower.
                for (Point& q : points)
                    q.y = std::min(q.y + 3000, bottom);
                const auto below = reader.row(points.data(), n);
                ASSERT_EQ(differing(below, reader.row(points.data(), n, true)), 0u);
            }
        }
    });
}

/// A grid's values are those of its rows one by one.
void expect_rows(Reader& reader, const std::vector<int32_t>& x, const std::vector<int32_t>& y) {
    const auto grid = reader.grid(x, y);
    for (size_t r = 0; r < y.size(); ++r) {
        std::vector<Point> points;
        for (const int32_t px : x)
            points.push_back({px, y[r]});
        const auto row = reader.row(points.data(), int(points.size()));
        const auto begin = grid.begin() + ptrdiff_t(r * row.size());
        const std::vector<float> same(begin, begin + ptrdiff_t(row.size()));
        ASSERT_EQ(differing(row, same), 0u) << r;
    }
}

TEST(Evaluate, BlocksHaveTheBitsOfRows) {
    on_each_target([] {
        each_scene([](const Scene& scene, Random& random) {
            const Lattice& l = scene.lattice;
            const auto positions = [&](int size, int step) {
                std::vector<int32_t> p;
                const int32_t last = (size - 1) * position_one;
                for (int32_t at = random.between(0, step); at < last; at += random.between(1, step))
                    p.push_back(at);
                p.push_back(last);
                return p;
            };
            for (const Surface surface : surfaces)
                for (const int channels : {1, 2, 3, 4, 7})
                    for (const float tau : {0.0f, 0.5f}) {
                        const auto values =
                            make_values(all_values[size_t(channels) % std::size(all_values)],
                                        scene.pixels() * channels, random);
                        Reader reader(scene, surface, values, channels, 0, tau);
                        const auto x = positions(l.width(), channels * 20000);
                        const auto y = positions(l.height(), 30000);
                        expect_rows(reader, x, y);
                    }
        });
    });
}

TEST(Evaluate, LocatedRowsHoldTheTrianglesOfTheirPositions) {
    int in_cells = 0, in_triangles = 0;
    each_scene([&](const Scene& scene, Random& random) {
        const Lattice& l = scene.lattice;
        Search search;
        LocatedRow row;
        search.begin();
        for (int y = 0; y <= (l.height() - 1) * position_one; y += 20011) {
            std::vector<Point> points;
            for (int x = 0; x <= (l.width() - 1) * position_one; x += random.between(1, 9000))
                points.push_back({x, y});
            locate_row(l, points.data(), int(points.size()), search, row);
            int at = 0;
            for (const Span& s : row.spans) {
                ASSERT_EQ(s.begin, at);
                ASSERT_GT(s.end, s.begin);
                at = s.end;
                for (int i = s.begin; i < s.end; ++i) {
                    const Point p = points[size_t(i)];
                    const Triangle t = locate(l, p);
                    const Face f = face_of_triangle(l, t);
                    int32_t w[3];
                    t.weights(p, w);
                    if (s.kind == Span::triangle) {
                        ++in_triangles;
                        const int cx = std::min(p.x >> position_bits, l.width() - 2);
                        const int cy = std::min(p.y >> position_bits, l.height() - 2);
                        for (int k = 0; k < 3; ++k) {
                            ASSERT_EQ(s.vertex[k], t.vertex[k]);
                            ASSERT_EQ(s.edge[k], t.edge[k]);
                            ASSERT_EQ(row.weight[k][size_t(i)] * 65536.0f, float(w[k]));
                            ASSERT_LE(f[size_t(k)].x, cx + l.longest());
                            ASSERT_GE(f[size_t(k)].x, cx + 1 - l.longest());
                            ASSERT_LE(f[size_t(k)].y, cy + l.longest());
                            ASSERT_GE(f[size_t(k)].y, cy + 1 - l.longest());
                        }
                        continue;
                    }
                    // A plain cell: the triangle's vertices are three of its corners.
                    ++in_cells;
                    const Pixel corner{s.vertex[0] % l.stride() / 2, s.vertex[0] / l.stride() / 2};
                    ASSERT_EQ(row.weight[0][size_t(i)] * 65536.0f,
                              float(p.x - corner.x * position_one));
                    ASSERT_EQ(row.weight[1][size_t(i)] * 65536.0f,
                              float(p.y - corner.y * position_one));
                    for (const Pixel v : f) {
                        const Pixel c = v - corner;
                        ASSERT_TRUE(c.x >= 0 && c.x <= 1 && c.y >= 0 && c.y <= 1);
                    }
                }
            }
            ASSERT_EQ(at, int(points.size()));
        }
    });
    EXPECT_GT(in_cells, 1000);
    EXPECT_GT(in_triangles, 1000);
}

TEST(Evaluate, StaysBetweenTheTrianglesThreeValues) {
    each_scene([](const Scene& scene, Random& random) {
        for (const Surface surface : surfaces)
            for (const Values kind : {Values::unit, Values::hdr, Values::wild}) {
                auto values = make_values(kind, scene.pixels(), random);
                if (kind == Values::wild)
                    for (size_t i = 0; i < values.size(); i += 5)
                        values[i] = i % 2 ? 1e38f : -1e38f;
                Reader reader(scene, surface, values);
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
    Reader linear(scene, Surface::linear, values), patch(scene, Surface::patch, values);
    int different = 0;
    for (const Point p : make_points(scene.lattice, 600, random))
        different += bits_of(linear.at(p)) != bits_of(patch.at(p));
    EXPECT_GT(different, 250);
}

TEST(Evaluate, APlaneIsReproducedExactly) {
    each_scene([](const Scene& scene, Random& random) {
        for (const Surface surface : surfaces) {
            // Few enough bits that weight times value and all sums fit a float.
            const int w = scene.lattice.width(), h = scene.lattice.height();
            const int gx = random.between(-1, 1), gy = random.between(-3, 3), c = 5;
            std::vector<float> values;
            for (int y = 0; y < h; ++y)
                for (int x = 0; x < w; ++x)
                    values.push_back(float(gx * x + gy * y + c) / 32.0f);
            Reader reader(scene, surface, values);
            for (const Point p : make_points(scene.lattice, 300, random)) {
                const double exact = (double(gx) * p.x + double(gy) * p.y + c * 65536.0) / 65536.0;
                ASSERT_EQ(double(reader.at(p)), exact / 32.0);
            }
        }
    });
}

TEST(Evaluate, AConstantIsReproducedExactly) {
    each_scene([](const Scene& scene, Random& random) {
        for (const Surface surface : surfaces)
            for (const float x : {0.1f, 1.0f / 3.0f, -7.77e5f, 1e38f, 1e-30f, 0.0f}) {
                Reader reader(scene, surface, std::vector<float>(scene.pixels(), x));
                for (const Point p : make_points(scene.lattice, 100, random))
                    ASSERT_EQ(reader.at(p), x);
            }
    });
}

TEST(Evaluate, AtAPixelThePixelComesBack) {
    each_scene([](const Scene& scene, Random& random) {
        for (const Surface surface : surfaces)
            for (const Values kind : all_values) {
                const auto values = make_values(kind, scene.pixels(), random);
                Reader reader(scene, surface, values);
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
        for (const Surface surface : surfaces)
            for (const float x : {std::nanf(""), inf, -inf}) {
                const Pixel bad{random.below(width), random.below(scene.lattice.height())};
                auto values = clean;
                values[size_t(bad.y * width + bad.x)] = x;
                Reader reader(scene, surface, values);
                Reader before(scene, Surface::linear, clean);
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
    for (const Surface surface : surfaces) {
        Reader reader(scene, surface, {inf, -inf, -inf, inf});
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
        for (const Surface surface : surfaces) {
            Reader reader(scene, surface, values, channels, nearest);
            Reader blend(scene, surface, values, channels, 0);
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
    for (const Surface surface : surfaces)
        for (const int channels : {1, 2, 3, 4, 5, 6, 7, 8, 9, 64}) {
            const auto values = make_values(Values::hdr, scene.pixels() * size_t(channels), random);
            const auto all =
                Reader(scene, surface, values, channels).row(points.data(), int(points.size()));
            for (int c = 0; c < channels; ++c) {
                std::vector<float> one, expected;
                for (size_t i = 0; i < scene.pixels(); ++i)
                    one.push_back(values[i * size_t(channels) + size_t(c)]);
                for (size_t i = 0; i < points.size(); ++i)
                    expected.push_back(all[i * size_t(channels) + size_t(c)]);
                Reader reader(scene, surface, one);
                ASSERT_EQ(differing(reader.row(points.data(), int(points.size())), expected), 0u)
                    << channels << ' ' << c;
            }
        }
}

TEST(Evaluate, PositionsThatLieAlikeInCellsHaveTheBitsOfRows) {
    on_each_target([] {
        Random random(5);
        constexpr int few = 70;
        for (const int flips : {0, few, 6000}) {
            const Scene scene(29, 13, flips, random);
            const Lattice& l = scene.lattice;
            for (int phases = least_phases; phases <= most_phases; ++phases)
                for (const int channels : {1, 2, 3, 4, 7})
                    for (const float tau : {0.0f, 0.5f}) {
                        const int rows = random.between(1, LocatedBlock::most_rows);
                        SCOPED_TRACE(::testing::Message()
                                     << flips << " flips, " << phases << " x " << rows << ", "
                                     << channels << ", " << tau);
                        const auto kind = all_values[size_t(channels) % std::size(all_values)];
                        const auto values = make_values(kind, scene.pixels() * channels, random);
                        Reader reader(scene, surfaces[random.below(2)], values, channels, 0, tau,
                                      random.below(2) == 1);
                        // From anywhere in a cell to anywhere in another; on ties too.
                        const int32_t step = position_one / phases;
                        const int32_t shift = random.below(2) * random.below(step);
                        std::vector<int32_t> x, y;
                        for (int i = random.below(2 * phases);
                             i / phases < l.width() - 1 - random.below(3); ++i)
                            x.push_back(i / phases * position_one + i % phases * step + shift);
                        for (int i = 0; i < (l.height() - 1) * rows; ++i)
                            y.push_back(i / rows * position_one + i % rows * (position_one / rows));
                        expect_rows(reader, x, y);
                        // Few cells fall away at the ends.
                        EXPECT_EQ(reader.alike().phases, phases);
                        EXPECT_GE(reader.alike().cells, l.width() - 1 - 6);
                        const bool fits = phases * rows <= CrossedSearch::most_positions;
                        EXPECT_EQ(reader.crossed() > 0, flips > 0 && fits);
                        if (flips == 0)
                            EXPECT_EQ(reader.together(), reader.blocks());
                        else
                            EXPECT_EQ(reader.mixed() > 0, flips == few && fits);
                    }
        }
    });
}

TEST(Columns, FindTheLongestStretchOfCellsThatAreAlike) {
    const auto alike = [](const std::vector<int32_t>& x) {
        std::vector<Point> points;
        for (const int32_t at : x)
            points.push_back({at, 0});
        Columns columns;
        columns.find(points.data(), int(points.size()), 200);
        return columns.alike;
    };
    // 20 cells with three positions each, one with two, 30 with three.
    std::vector<int32_t> x;
    for (int cell = 5; cell < 56; ++cell)
        for (int k = 0; k < (cell == 25 ? 2 : 3); ++k)
            x.push_back(cell * position_one + 1000 + k * 20000);
    const Columns::Alike found = alike(x);
    EXPECT_EQ(found.cell, 26);
    EXPECT_EQ(found.cells, 30);
    EXPECT_EQ(found.begin, 20 * 3 + 2);
    EXPECT_EQ(found.phases, 3);
    EXPECT_EQ(found.end(), int(x.size()));
    // Elsewhere in every cell, cells with none between, or more in each than are any use.
    for (size_t i = 0; i < x.size(); ++i)
        x[i] = int32_t(i) * 21000;
    EXPECT_EQ(alike(x).cells, 0);
    for (size_t i = 0; i < x.size(); ++i)
        x[i] = int32_t(i) / 2 * 2 * position_one + int32_t(i) % 2 * 30000;
    EXPECT_EQ(alike(x).cells, 0);
    for (size_t i = 0; i < x.size(); ++i)
        x[i] = int32_t(i) / (most_phases + 1) * position_one +
               int32_t(i) % (most_phases + 1) * (position_one / (most_phases + 1));
    EXPECT_EQ(alike(x).cells, 0);
    EXPECT_EQ(alike({}).cells, 0);
}

} // namespace
} // namespace ddt::test
