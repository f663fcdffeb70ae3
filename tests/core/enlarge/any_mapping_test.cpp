// SPDX-License-Identifier: Apache-2.0
// Mappings that jump about and ones that lead out of the window.
#include <limits>

#include "tests/core/job_helpers.h"
#include "tests/core/mirrored.h"
#include "tests/many_threads.h"

namespace ddt::test {
namespace {

constexpr int width = 400, height = 300;

/// A plane, so that every position's value is known.
float plane(double x, double y) {
    return float((x + 2 * y) / 1024);
}

class Plane final : public Source {
public:
    bool read(const Rect& r, float* values, float* guide) override {
        for (int y = r.y0; y < r.y1; ++y)
            for (int x = r.x0; x < r.x1; ++x)
                *values++ = *guide++ = plane(x, y);
        return true;
    }
};

/// Positions within a window that lies before 0, and some at the ends of 64 bits: one's own are
/// clamped so beyond a horizon, and what is converted is on some machines.
class Farthest final : public Mapping {
public:
    explicit Farthest(const Rect& window) : m_window(window) {}
    Rect reach(double, double, double, double) const override { return {0, 0, side, side}; }
    void row(int y, int x0, int x1, Position* positions, uint8_t* inside) const override {
        for (int x = x0; x < x1; ++x) {
            *positions++ = {along(x, m_window.x0, (5 * x + y) % 7),
                            along(y, m_window.y0, (7 * x + y) % 5)};
            *inside++ = 1;
        }
    }
    static constexpr int side = 400;

private:
    static int64_t along(int i, int begin, int turn) {
        return turn == 0   ? std::numeric_limits<int64_t>::max()
               : turn == 1 ? std::numeric_limits<int64_t>::min()
                           : i * 40000 + int64_t(begin) * position_one;
    }
    Rect m_window;
};

/// Positions anywhere in [-beyond, size + beyond), each axis by itself if `grid`.
class Scattered final : public Mapping {
public:
    Scattered(Rect out, int beyond, bool grid) : m_out(out), m_beyond(beyond), m_grid(grid) {}
    Rect reach(double, double, double, double) const override { return m_out; }
    void row(int y, int x0, int x1, Position* positions, uint8_t* inside) const override {
        for (int x = x0; x < x1; ++x) {
            *positions++ = at(x, y);
            *inside++ = 1;
        }
    }
    bool separable() const override { return m_grid; }
    Position at(int x, int y) const {
        return {along(m_grid ? Random(uint64_t(x)) : Random(uint64_t(y * 10000 + x)), width),
                along(m_grid ? Random(uint64_t(y) + 7777) : Random(uint64_t(y * 10000 + x) + 99),
                      height)};
    }

private:
    int64_t along(Random random, int size) const {
        const auto most = uint64_t(size - 1 + 2 * m_beyond) * position_one;
        return int64_t(random.bits() % (most + 1)) - int64_t(m_beyond) * position_one;
    }
    Rect m_out;
    int m_beyond;
    bool m_grid;
};

Job job_of_plane() {
    Job job = plain_job();
    job.window = {0, 0, width, height};
    job.surface = plain_surface(Surface::linear);
    job.device = Device::cpu;
    return job;
}

TEST(AnyMapping, MayJumpByAnyDistance) {
    Plane source;
    const Rect out{0, 0, 150, 60};
    const Scattered mapping(out, 0, false);
    TestSink sink(out, 1);
    ASSERT_EQ(enlarge(source, sink, mapping, job_of_plane()), Outcome::done);
    EXPECT_EQ(sink.written(1), int64_t(out.area()));
    for (int y = 0; y < out.y1; ++y)
        for (int x = 0; x < out.x1; ++x) {
            const Position p = mapping.at(x, y);
            ASSERT_NEAR(*sink.at(x, y),
                        plane(double(p.x) / position_one, double(p.y) / position_one), 1e-5f);
        }
}

TEST(AnyMapping, OneAxisAtATimeToo) {
    Plane source;
    const Rect out{0, 0, 150, 60};
    const Scattered mapping(out, 0, true);
    for (const Channel kind : {Channel::blend, Channel::nearest}) {
        Job job = job_of_plane();
        job.kinds = {kind};
        TestSink sink(out, 1);
        ASSERT_EQ(enlarge(source, sink, mapping, job), Outcome::done);
        const float tolerance = kind == Channel::blend ? 1e-5f : 3.0f / 1024;
        for (int y = 0; y < out.y1; ++y)
            for (int x = 0; x < out.x1; ++x) {
                const Position p = mapping.at(x, y);
                ASSERT_NEAR(*sink.at(x, y),
                            plane(double(p.x) / position_one, double(p.y) / position_one),
                            tolerance);
            }
    }
}

TEST(AnyMapping, RowsAndColumnsMayRunBackwards) {
    TestSource source({0, 0, 300, 280}, 3, 77);
    const Rect out{0, 0, 700, 640};
    const ResizeMapping mapping = mapping_of(source.window(), out, out);
    for (const bool nearest : {false, true}) {
        Job job = job_of(source, 3);
        if (nearest)
            job.kinds = {Channel::blend, Channel::nearest, Channel::blend};
        TestSink straight(out, 3);
        ASSERT_EQ(enlarge(source, straight, mapping, job), Outcome::done);
        for (const auto& [turn_x, turn_y] :
             {std::pair(true, false), std::pair(false, true), std::pair(true, true)}) {
            TestSink sink(out, 3);
            ASSERT_EQ(enlarge(source, sink, Mirrored(mapping, out, turn_x, turn_y), job),
                      Outcome::done);
            ASSERT_EQ(sink.written(1), int64_t(out.area()));
            std::vector<float> back;
            for (int y = 0; y < out.y1; ++y)
                for (int x = 0; x < out.x1; ++x) {
                    const float* p =
                        sink.at(turn_x ? out.x1 - 1 - x : x, turn_y ? out.y1 - 1 - y : y);
                    back.insert(back.end(), p, p + 3);
                }
            EXPECT_EQ(differing(back, straight.values()), 0u) << turn_x << turn_y << nearest;
        }
    }
}

TEST(AnyMapping, OutsideTheWindowNothingIsReadThatIsNotThere) {
    Plane source;
    const Rect out{0, 0, 150, 60};
    for (const int beyond : {1, 1000, 1 << 28})
        for (const bool grid : {false, true}) {
            const Scattered mapping(out, beyond, grid);
            TestSink sink(out, 1);
            ASSERT_EQ(enlarge(source, sink, mapping, job_of_plane()), Outcome::done);
            EXPECT_EQ(sink.strays, 0);
            int64_t within = 0, beside = 0;
            for (int y = 0; y < out.y1; ++y)
                for (int x = 0; x < out.x1; ++x) {
                    const Position p = mapping.at(x, y);
                    const double px = double(p.x) / position_one, py = double(p.y) / position_one;
                    const float v = *sink.at(x, y);
                    if (px >= 0 && px <= width - 1 && py >= 0 && py <= height - 1) {
                        ++within;
                        ASSERT_NEAR(v, plane(px, py), 1e-5f);
                        continue;
                    }
                    ASSERT_TRUE(v == -99.0f || (v >= 0 && v <= plane(width - 1, height - 1))) << v;
                    beside += v != -99.0f;
                }
            EXPECT_EQ(sink.written(1), within + beside);
            EXPECT_GT(within + beside, 2000) << "what is not written shows nothing";
            EXPECT_EQ(sink.written(0), int64_t(out.area()) - within - beside);
        }
}

TEST(AnyMapping, AnyNumberMayBeAPosition) {
    const ManyThreads allowed;
    TestSource source({-300, -300, -20, -20}, 3, 5);
    const auto [least, most] = std::minmax_element(source.values().begin(), source.values().end());
    const Rect out{0, 0, Farthest::side, Farthest::side};
    std::vector<float> one;
    for (const int threads : {1, 3}) {
        Job job = job_of(source, 3);
        job.surface.kind = Surface::patch;
        job.device = Device::cpu;
        job.threads = threads;
        TestSink sink(out, 3);
        ASSERT_EQ(enlarge(source, sink, Farthest(source.window()), job), Outcome::done);
        EXPECT_EQ(sink.strays, 0);
        EXPECT_GT(sink.written(1), int64_t(out.area()) / 3);
        for (const float v : sink.values())
            ASSERT_TRUE(v == -99.0f || (v >= *least && v <= *most)) << v;
        if (one.empty())
            one = sink.values();
        EXPECT_EQ(differing(sink.values(), one), 0u) << threads;
    }
}

} // namespace
} // namespace ddt::test
