// SPDX-License-Identifier: Apache-2.0
#include "ddt/core.h"

#include <cmath>

#include "core/base/float_mode.h"
#include "core/guide/guide.h"
#include "core/sample/evaluate.h"
#include "core/tiles/tile_io.h"
#include "core/tiles/tile_worker.h"
#include "core/triangulate/triangulate.h"
#include "tests/core/helpers.h"
#include "tests/core/job_helpers.h"
#include "tests/core/surface/consistency/whole_rounds.h"
#include "tests/core/surface/whole_net.h"
#include "tests/core/turned.h"
#include "tests/many_threads.h"

namespace ddt::test {
namespace {

std::vector<float> crop(const std::vector<float>& values, Rect whole, Rect part, int channels) {
    std::vector<float> r;
    for (int y = part.y0; y < part.y1; ++y)
        for (int x = part.x0; x < part.x1; ++x)
            for (int c = 0; c < channels; ++c)
                r.push_back(
                    values[(size_t(y - whole.y0) * size_t(whole.width()) + size_t(x - whole.x0)) *
                               size_t(channels) +
                           size_t(c)]);
    return r;
}

TEST(Enlarge, AnyNumberOfThreadsGivesTheSameBits) {
    const ManyThreads allowed;
    TestSource source({-20, 5, 560, 320}, 3, 1);
    const Rect out{0, 0, 900, 600};
    const auto mapping = mapping_of(source.window(), out, out);
    for (const Surface surface : both_surfaces) {
        Job job = job_of(source, 3);
        job.surface = plain_surface(surface);
        job.surface.soft = 0.3f;
        job.surface.consistency = 1;
        const auto one = run(source, job, mapping, out);
        for (const int threads : {2, 7, 0}) {
            job.threads = threads;
            ASSERT_EQ(differing(run(source, job, mapping, out), one), 0u) << threads;
        }
    }
}

/// Has memory of its own, with something between the rows that is not to be touched.
class PlacingSink final : public TestSink {
public:
    static constexpr float untouched = -55.0f;
    static constexpr size_t gap = 3;

    PlacingSink(Rect out, int channels)
        : TestSink(out, channels), m_out(out), m_channels(size_t(channels)),
          m_row(size_t(out.width()) * m_channels + gap),
          m_memory(m_row * size_t(out.height()), untouched) {}

    float* place(const Rect& r, size_t& row) override {
        ++places;
        row = m_row;
        return m_memory.data() + size_t(r.y0 - m_out.y0) * m_row +
               size_t(r.x0 - m_out.x0) * m_channels;
    }

    /// The rows without what is between them, which is checked.
    std::vector<float> rows() const {
        std::vector<float> result;
        for (size_t i = 0; i < m_memory.size(); ++i)
            if (i % m_row < m_row - gap)
                result.push_back(m_memory[i]);
            else
                EXPECT_EQ(m_memory[i], untouched);
        return result;
    }

    std::atomic<int> places{0};

private:
    Rect m_out;
    size_t m_channels, m_row;
    std::vector<float> m_memory;
};

TEST(Enlarge, PutsTheSameBitsIntoTheSinksMemory) {
    const ManyThreads allowed;
    for (const int channels : {1, 2, 3, 4, 6})
        for (const Rect out : {Rect{0, 0, 633, 402}, Rect{211, 100, 633, 300}}) {
            TestSource source({-20, 5, 300, 200}, channels, 7);
            const auto mapping = mapping_of(source.window(), {0, 0, 640, 410}, out);
            Job job = job_of(source, channels, 3);
            job.surface.soft = 0.4f;
            const auto written = run(source, job, mapping, out);
            PlacingSink sink(out, channels);
            ASSERT_EQ(enlarge(source, sink, mapping, job, nullptr), Outcome::done);
            EXPECT_EQ(sink.writes, 0);
            EXPECT_GT(sink.places, 1);
            EXPECT_EQ(differing(sink.rows(), written), 0u) << channels;
        }
}

/// Copies of the nearest pixel come a row at a time, with something past its end: by write().
TEST(Enlarge, PutsNothingIntoTheSinksMemoryWhereChannelsAreNearest) {
    TestSource source({0, 0, 50, 40}, 2, 7);
    const Rect out{0, 0, 120, 90};
    Job job = job_of(source, 2);
    job.kinds = {Channel::blend, Channel::nearest};
    PlacingSink sink(out, 2);
    ASSERT_EQ(enlarge(source, sink, mapping_of(source.window(), out, out), job, nullptr),
              Outcome::done);
    EXPECT_EQ(sink.places, 0);
    EXPECT_EQ(sink.written(1), int64_t(out.area()));
}

TEST(Enlarge, AnyPartOfTheOutputHasTheBitsOfTheWhole) {
    TestSource source({-20, 5, 560, 320}, 2, 2);
    const Rect to{-10, 30, 690, 430};
    const Rect whole{-60, 0, 750, 470}; // beyond the window too: clamped
    const Job job = job_of(source, 2);
    const auto all = run(source, job, mapping_of(source.window(), to, whole), whole);
    Random random(3);
    for (int i = 0; i < 12; ++i) {
        Rect part;
        part.x0 = random.between(whole.x0, whole.x1 - 1);
        part.x1 = random.between(part.x0 + 1, std::min(whole.x1, part.x0 + 200));
        part.y0 = random.between(whole.y0, whole.y1 - 1);
        part.y1 = random.between(part.y0 + 1, std::min(whole.y1, part.y0 + 200));
        const auto values = run(source, job, mapping_of(source.window(), to, part), part);
        ASSERT_EQ(differing(values, crop(all, whole, part, 2)), 0u);
    }
}

TEST(Enlarge, ShiftedWindowsShiftTheResult) {
    Job job = plain_job();
    const Rect window{0, 0, 290, 40}, to{0, 0, 500, 90};
    std::vector<float> first;
    for (const Pixel by : {Pixel{0, 0}, Pixel{1, -1}, Pixel{-1000, 7}, Pixel{123456, -(1 << 28)}})
        for (const Pixel out : {Pixel{0, 0}, Pixel{-37, 1 << 20}}) {
            const Rect w{window.x0 + by.x, window.y0 + by.y, window.x1 + by.x, window.y1 + by.y};
            const Rect t{to.x0 + out.x, to.y0 + out.y, to.x1 + out.x, to.y1 + out.y};
            TestSource source(w, 1, 5);
            const auto values = run(source, job_of(source, 1), mapping_of(w, t, t), t);
            if (first.empty())
                first = values;
            ASSERT_EQ(differing(values, first), 0u);
        }
}

/// The surface of the whole picture as one lattice at the mapping's positions.
std::vector<float> untiled(const TestSource& source, const Job& job, const ResizeMapping& mapping,
                           Rect out) {
    const Rect w = source.window();
    Lattice lattice;
    Workspace workspace;
    Statistics statistics;
    ControlNet net;
    WholeEdges edges;
    Search search;
    LocatedRow row;
    net.bounds = bounds_of(job.surface);
    lattice.start(w.width(), w.height(), source.guide().data(), true);
    const DenormalsAreZero zero;
    triangulate(lattice, job.mesh, workspace, statistics);
    lattice.find_divisions(lattice.all());
    lattice.find_first_edges(lattice.all());
    set_all_vertices(lattice, {source.values().data(), 1, 0, 1}, net);
    if (job.surface.soft > 0)
        find_all_gains(lattice, job.mesh.cost);
    const auto shape = [&] {
        edges.make(lattice, {0, 0, w.width(), w.height()}, true, job.surface.soft > 0,
                   job.surface.soft, net);
    };
    WholeRounds consistency;
    consistency.begin(lattice, net,
                      {job.surface.limit, false, correction_strength(mapping.scale())});
    for (int i = 0; i < job.surface.consistency; ++i) {
        shape();
        consistency.correct(lattice, job.surface.kind, net);
    }
    shape();
    search.begin();
    std::vector<float> values(out.area() + row_padding);
    std::vector<Position> positions(size_t(out.width()));
    std::vector<uint8_t> inside(size_t(out.width()));
    for (int y = out.y0; y < out.y1; ++y) {
        mapping.row(y, out.x0, out.x1, positions.data(), inside.data());
        std::vector<Point> points;
        for (const Position& p : positions)
            points.push_back({int32_t(p.x - int64_t(w.x0) * position_one),
                              int32_t(p.y - int64_t(w.y0) * position_one)});
        locate_row(lattice, points.data(), out.width(), search, row);
        float* const to = values.data() + size_t(y - out.y0) * size_t(out.width());
        evaluate_row(net, job.surface.kind, 0, row, {to, 0, 1, 0, 1});
    }
    values.resize(out.area());
    return values;
}

TEST(Enlarge, TilesShowNoSeams) {
    for (const Kind kind : {Kind::shapes, Kind::noise, Kind::few}) {
        TestSource source({3, -9, 333, 531}, 1, 6, kind);
        const Rect out{0, 0, 400, 630};
        const auto mapping = mapping_of(source.window(), out, out);
        Job job = job_of(source, 1);
        const auto tiled = run(source, job, mapping, out);
        ASSERT_EQ(source.reads.size(), 6u);
        EXPECT_EQ(differing(tiled, untiled(source, job, mapping, out)), 0u) << int(kind);
        job.surface.soft = 0.3f;
        job.surface.consistency = 2;
        const auto sharp = run(source, job, mapping, out);
        EXPECT_EQ(differing(sharp, untiled(source, job, mapping, out)), 0u) << int(kind);
        EXPECT_GT(differing(sharp, tiled), 100000u);
    }
}

/// A bar of hard pixels that climbs two rows a column, as isometric drawings do: what flips along
/// its edges depends on what has flipped beside it, a row an iteration, from tiles' halos on.
TEST(Enlarge, AStraightEdgeIsTheSameAllAlong) {
    const Rect window{0, 0, 400, 620}, out{0, 0, 800, 1240};
    // Pixels that are others than in the rows near the picture's rim.
    const auto others = [&](const char* filter, bool leans_right, int rise = 2) {
        std::vector<float> bar;
        for (int y = 0; y < window.y1; ++y)
            for (int x = 0; x < window.x1; ++x) {
                const int across = rise * (leans_right ? 399 - x : x) - y;
                bar.push_back(across > 20 * rise && across < 50 * rise ? 1.0f : 0.0f);
            }
        TestSource source(window, 1, bar, bar);
        Job job = job_of(source, 1, 0);
        set_filter(filter, job);
        const std::vector<float> v = run(source, job, mapping_of(window, out, out), out);
        int count = 0;
        const size_t period = 2 * size_t(rise);
        for (size_t y = 40; y < 1200; ++y)
            for (size_t k = 20 + y / size_t(rise); k < 120 + y / size_t(rise); ++k) {
                const size_t up = (y - 40) / period * period, above = k - up / size_t(rise);
                const size_t x = leans_right ? 799 - k : k;
                const size_t there = leans_right ? 799 - above : above;
                count += std::fabs(v[y * 800 + x] - v[(y - up) * 800 + there]) > 0.05f;
            }
        return count;
    };
    for (const char* filter : {"ddt", "ddt-linear", "ddt-sharp", "ddt-sharp,clipped=1"})
        for (const bool leans_right : {false, true})
            EXPECT_LT(others(filter, leans_right), 60) << filter << leans_right;
    for (const char* filter : {"ddt", "ddt-sharp,clipped=1"})
        EXPECT_LT(others(filter, false, 3), 60) << filter;
    EXPECT_GT(others("ddt,iterations=64", false), 1000);
    EXPECT_GT(others("ddt,iterations=64", true), 1000);
    EXPECT_GT(others("ddt,iterations=250", true), 60);
}

/// Black dots of a screentone on white: none is joined to its next by a dash, not even where the
/// tone ends, at an outline or at the picture's rim, and the contours' tensor sees half of it.
TEST(Enlarge, DotsOfAScreentoneStayApart) {
    const Rect window{0, 0, 24, 24}, out{0, 0, 96, 96};
    const auto joined = [&](const char* filter, int period, int begin, int end) {
        const auto is_dot = [=](int x, int y) {
            return (x + 2 * y) % period == 0 && std::min(x, y) >= begin && std::max(x, y) < end;
        };
        std::vector<float> tone;
        for (int y = 0; y < window.y1; ++y)
            for (int x = 0; x < window.x1; ++x)
                tone.push_back(is_dot(x, y) ? 0.0f : 1.0f);
        TestSource source(window, 1, tone, tone);
        Job job = job_of(source, 1, 0);
        set_filter(filter, job);
        const std::vector<float> v = run(source, job, mapping_of(window, out, out), out);
        int count = 0;
        for (int y = begin; y < end - 2; ++y)
            for (int x = std::max(begin, 1); x < end - 2; ++x)
                for (const Pixel& d : {Pixel{2, 1}, Pixel{1, 2}, Pixel{-1, 2}, Pixel{-2, 1}}) {
                    if (!is_dot(x, y) || !is_dot(x + d.x, y + d.y))
                        continue;
                    // The four pixels around the middle between the two dots.
                    const float* m =
                        &v[size_t(4 * y + 2 * d.y + 1) * 96 + size_t(4 * x + 2 * d.x + 1)];
                    count += (m[0] + m[1]) + (m[96] + m[97]) < 4 * 0.35f;
                }
        return count;
    };
    for (const char* filter : {"ddt", "ddt-sharp", "ddt-sharp,clipped=1"})
        for (const int period : {4, 5}) {
            EXPECT_EQ(joined(filter, period, 4, 16), 0) << filter << period;
            EXPECT_EQ(joined(filter, period, 0, 24), 0) << filter << period;
        }
}

TEST(Enlarge, PositionsOneByOneGiveTheBitsOfRows) {
    TestSource source({-5, 2, 275, 290}, 5, 7);
    const Rect out{0, 0, 400, 433};
    const auto mapping = mapping_of(source.window(), out, out);
    for (const int threads : {1, 3}) {
        const Job job = job_of(source, 5, threads);
        const auto rows = run(source, job, mapping, out);
        EXPECT_EQ(differing(run(source, job, Opaque(mapping), out), rows), 0u);
    }
}

TEST(Enlarge, AMappingMayLeavePixelsOut) {
    TestSource source({0, 0, 300, 280}, 1, 8);
    // The pixels' own coordinates as values: a plane, which comes back exactly.
    for (size_t i = 0; i < source.values().size(); ++i)
        source.values()[i] = float(i % 300);
    const Turned mapping(source.window(), 27, 1.8, false);
    const Rect out = mapping.out();
    for (const int threads : {1, 2}) {
        TestSink sink(out, 1);
        const Job job = job_of(source, 1, threads);
        ASSERT_EQ(enlarge(source, sink, mapping, job), Outcome::done);
        ASSERT_EQ(sink.written(0) + sink.written(1), int64_t(out.area()));
        int64_t shown = 0;
        for (int y = 0; y < out.y1; ++y) {
            std::vector<Position> p(size_t(out.width()));
            std::vector<uint8_t> inside(size_t(out.width()));
            mapping.row(y, 0, out.x1, p.data(), inside.data());
            for (int x = 0; x < out.x1; ++x) {
                const float v = *sink.at(x, y);
                if (inside[size_t(x)])
                    ASSERT_NEAR(v, float(p[size_t(x)].x) / 65536.0f, 1e-4f);
                else
                    ASSERT_EQ(v, -99.0f);
                shown += inside[size_t(x)];
            }
        }
        EXPECT_EQ(sink.written(1), shown);
        EXPECT_GT(shown, 60000);
    }
}

TEST(Enlarge, SameSizeGivesThePixels) {
    for (const int channels : {1, 2, 3, 4, 5, 6, 7, 8, 9, 64}) {
        TestSource source({10, -10, 40, 13}, channels, 9);
        for (const Surface surface : both_surfaces) {
            Job job = job_of(source, channels);
            job.surface = plain_surface(surface);
            const Rect w = source.window();
            const auto values = run(source, job, mapping_of(w, w, w), w);
            ASSERT_EQ(differing(values, source.values()), 0u) << channels;
        }
    }
}

/// Whether each channel of a picture of `channels`, every third an alpha, is as it is alone.
void expect_each_as_alone(int channels, const SurfaceOptions& surface) {
    TestSource source({0, 0, 33, 21}, channels, 10), one({0, 0, 33, 21}, 1, 10);
    const Rect out{0, 0, 100, 50};
    const auto mapping = mapping_of(source.window(), out, out);
    Job job = job_of(source, channels), alone = job_of(one, 1);
    job.surface = alone.surface = surface;
    for (int c = 0; c < channels; ++c)
        job.kinds.push_back(c % 3 == 1 ? Channel::alpha : Channel::blend);
    const auto all = run(source, job, mapping, out);
    for (int c = 0; c < channels; ++c) {
        for (size_t i = 0; i < one.values().size(); ++i)
            one.values()[i] = source.values()[i * size_t(channels) + size_t(c)];
        alone.kinds = {job.kinds[size_t(c)]};
        const auto values = run(one, alone, mapping, out);
        for (size_t i = 0; i < values.size(); ++i)
            ASSERT_EQ(bits_of(values[i]), bits_of(all[i * size_t(channels) + size_t(c)]));
    }
}

TEST(Enlarge, ChannelsDoNotKnowOfOneAnother) {
    on_each_target([] {
        for (const SurfaceOptions& surface : surfaces_with({0, 1, 2}))
            for (const int channels : {2, 3, 4, 5, 9})
                expect_each_as_alone(channels, surface);
    });
}

TEST(Enlarge, NearestChannelsAreCopies) {
    const int channels = 7;
    TestSource source({0, 0, 40, 30}, channels, 11);
    Random random(11);
    std::vector<uint32_t> ids;
    for (size_t i = 0; i < source.values().size(); ++i)
        if (i % channels == 1 || i % channels == 6) {
            // Of any bits, and whole numbers, which corrections would move.
            ids.push_back(i % channels == 1 ? uint32_t(random.bits()) | (i % 3 ? 0x7f800000u : 0u)
                                            : bits_of(float(random.below(1000))));
            source.values()[i] = float_of(ids.back());
        }
    std::sort(ids.begin(), ids.end());
    const Rect out{0, 0, 111, 93};
    const auto mapping = mapping_of(source.window(), out, out);
    for (const SurfaceOptions& surface : surfaces_with({0, 1, 2})) {
        Job job = job_of(source, channels);
        job.surface = surface;
        const auto blend = run(source, job, mapping, out);
        job.kinds.assign(channels, Channel::blend);
        ASSERT_EQ(differing(run(source, job, mapping, out), blend), 0u);
        job.kinds[1] = job.kinds[6] = Channel::nearest;
        const auto values = run(source, job, mapping, out);
        for (size_t i = 0; i < values.size(); ++i)
            if (i % channels == 1 || i % channels == 6)
                ASSERT_TRUE(std::binary_search(ids.begin(), ids.end(), bits_of(values[i])));
            else
                ASSERT_EQ(bits_of(values[i]), bits_of(blend[i]));
    }
}

TEST(Enlarge, OnePixelWideOrHighPictures) {
    for (const Surface surface : both_surfaces)
        for (const Pixel size :
             {Pixel{1, 1}, Pixel{1, 9}, Pixel{9, 1}, Pixel{1, 300}, Pixel{300, 1}})
            for (const int channels : {1, 3, 5}) {
                SCOPED_TRACE(::testing::Message() << size.x << " x " << size.y);
                TestSource source({4, 4, 4 + size.x, 4 + size.y}, channels, 12);
                Job job = job_of(source, channels);
                job.surface = plain_surface(surface);
                const Rect out{0, 0, 3 * size.x, 3 * size.y};
                const auto mapping = mapping_of(source.window(), out, out);
                const auto values = run(source, job, mapping, out);
                const int n = std::max(size.x, size.y);
                const auto z = [&](int i, int c) {
                    i = std::clamp(i, 0, n - 1);
                    return source.values()[size_t(i * channels + c)];
                };
                for (int y = 0; y < out.y1; ++y)
                    for (int x = 0; x < out.x1; ++x)
                        for (int c = 0; c < channels; ++c) {
                            // Output pixel i shows position (i - 1) / 3.
                            const int i = size.x > 1 ? x : size.y > 1 ? y : 1;
                            const float v = values[size_t((y * out.x1 + x) * channels + c)];
                            const int j = (i + 2) / 3 - 1, k = j + (i % 3 != 1);
                            ASSERT_GE(v, std::min(z(j, c), z(k, c)));
                            ASSERT_LE(v, std::max(z(j, c), z(k, c)));
                            if (surface == Surface::linear) {
                                const float t = float((i + 2) % 3) / 3.0f;
                                ASSERT_NEAR(v, z(j, c) + t * (z(k, c) - z(j, c)), 2e-5f);
                            }
                        }
            }
}

TEST(Enlarge, ReadsNoMoreThanATileAtOnceAndOnlyWhatIsNeeded) {
    TestSource source({0, 0, 900, 700}, 1, 13);
    const Rect to{0, 0, 1800, 1400}, out{1100, 600, 1200, 650};
    run(source, job_of(source, 1), mapping_of(source.window(), to, out), out);
    // Source pixels 550 to 600, 300 to 325: the third tile of the second row.
    ASSERT_EQ(source.reads.size(), 1u);
    EXPECT_EQ(source.reads[0].x0, 512 - 32);
    EXPECT_EQ(source.reads[0].x1, 768 + 1 + 32);
    EXPECT_EQ(source.reads[0].y0, 256 - 32);
    EXPECT_EQ(source.reads[0].y1, 512 + 1 + 32);
}

TEST(Enlarge, ManyChannelsWorkOnFewerTilesAtOnce) {
    // Of more than 100 MiB a tile, of 200 in all, only one may be in flight.
    constexpr int channels = 256;
    const ManyThreads allowed;
    TestSource source({0, 0, 400, 280}, channels, 14, Kind::flat);
    const Rect to{0, 0, 400, 280};
    const auto mapping = mapping_of(source.window(), to, to);
    const Job job = job_of(source, channels, 7);
    ASSERT_GT(TileWorker::memory(job, mapping) + TileMemory::needed(job), size_t(100) << 20);
    const auto values = run(source, job, mapping, to);
    EXPECT_EQ(source.reads.size(), 4u);
    EXPECT_EQ(source.most_running, 1);
    EXPECT_EQ(differing(values, source.values()), 0u);
}

/// Its guide is so many times as large.
class ScaledGuide final : public TestSource {
public:
    explicit ScaledGuide(float scale)
        : TestSource({0, 0, 40, 30}, 3, 21, Kind::few), m_scale(scale) {}
    bool read(const Rect& r, float* values, float* guide) override {
        TestSource::read(r, values, guide);
        for (size_t i = 0; i < r.area(); ++i)
            guide[i] *= m_scale;
        return true;
    }

private:
    const float m_scale;
};

TEST(Enlarge, GuidesNearerToZeroThanTheLeastAreZero) {
    const Rect out{0, 0, 80, 60};
    const auto bits_with = [&](float scale) {
        ScaledGuide source(scale); // 0, half and whole of it
        return run(source, job_of(source, 3), mapping_of(source.window(), out, out), out);
    };
    const std::vector<float> flat = bits_with(0);
    EXPECT_EQ(differing(bits_with(least_guide * 0.75f), flat), 0u);
    EXPECT_EQ(differing(bits_with(-least_guide * 0.75f), flat), 0u);
    EXPECT_GT(differing(bits_with(least_guide), flat), 0u);
    EXPECT_GT(differing(bits_with(-least_guide), flat), 0u);
}

TEST(Enlarge, ValuesNearerToZeroThanTheLeastAreZeroButIds) {
    TestSource source({0, 0, 20, 10}, 3, 22);
    for (size_t i = 0; i < source.values().size(); ++i)
        source.values()[i] = (i / 3 % 2 ? 0.75f : -1.0f) * least_value;
    Job job = job_of(source, 3);
    job.kinds = {Channel::blend, Channel::nearest, Channel::alpha};
    const auto values =
        run(source, job, mapping_of(source.window(), source.window(), source.window()),
            source.window());
    for (size_t i = 0; i < values.size(); ++i) {
        const bool is_small = i / 3 % 2 != 0 && i % 3 != 1;
        EXPECT_EQ(values[i], is_small ? 0.0f : source.values()[i]) << i;
    }
}

TEST(Enlarge, PixelsOfAnyKindAreWorkedOn) {
    const float inf = std::numeric_limits<float>::infinity();
    const float odd[] = {inf, -inf, std::nanf(""), 1e38f, -1e38f, 3.4e38f, 1e-40f, 0.0f, 1.0f};
    Random random(20);
    const auto values = fill(30 * 30 * 3, [&] { return odd[random.below(9)]; });
    for (const Surface surface : both_surfaces) {
        std::vector<float> out(90 * 90 * 3);
        EXPECT_EQ(
            enlarge(values.data(), 30, 30, 3, nullptr, out.data(), 90, 90, plain_surface(surface)),
            Outcome::done);
    }
}

} // namespace
} // namespace ddt::test
