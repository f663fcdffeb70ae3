// SPDX-License-Identifier: Apache-2.0
// Sources, sinks and mappings for tests of whole jobs.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "ddt/core.h"
#include "ddt/option_table.h"
#include "tests/core/helpers.h"

namespace ddt::test {

/// A picture with its guide, as a source that keeps account of what is read.
class TestSource : public Source {
public:
    TestSource(Rect window, int channels, uint64_t seed, Kind kind = Kind::shapes)
        : m_window(window), m_channels(size_t(channels)),
          m_guide(make_guide(kind, window.width(), window.height(), seed)) {
        Random random(seed);
        for (const float z : m_guide)
            for (size_t c = 0; c < m_channels; ++c)
                m_values.push_back(c == 0 ? z : random.unit());
    }

    TestSource(Rect window, int channels, std::vector<float> values, std::vector<float> guide)
        : m_window(window), m_channels(size_t(channels)), m_guide(std::move(guide)),
          m_values(std::move(values)) {}

    bool read(const Rect& r, float* values, float* guide) override {
        const int running = ++m_running;
        int most = most_running;
        while (running > most && !most_running.compare_exchange_weak(most, running)) {
        }
        {
            const std::lock_guard<std::mutex> lock(m_mutex);
            reads.push_back(r);
        }
        for (int y = r.y0; y < r.y1; ++y)
            for (int x = r.x0; x < r.x1; ++x) {
                const size_t at = index(x, y);
                *guide++ = m_guide[at];
                for (size_t c = 0; c < m_channels; ++c)
                    *values++ = m_values[at * m_channels + c];
            }
        --m_running;
        return true;
    }

    const std::vector<float>& guide() const { return m_guide; }
    std::vector<float>& guide() { return m_guide; }
    const std::vector<float>& values() const { return m_values; }
    std::vector<float>& values() { return m_values; }
    Rect window() const { return m_window; }

    std::vector<Rect> reads;
    std::atomic<int> most_running{0}; ///< reads at the same time

private:
    size_t index(int x, int y) const {
        EXPECT_TRUE(x >= m_window.x0 && x < m_window.x1 && y >= m_window.y0 && y < m_window.y1);
        return size_t(y - m_window.y0) * size_t(m_window.width()) + size_t(x - m_window.x0);
    }

    Rect m_window;
    size_t m_channels;
    std::vector<float> m_guide, m_values;
    std::atomic<int> m_running{0};
    std::mutex m_mutex;
};

/// Takes the pixels of a rectangle and counts how often each is written.
class TestSink : public Sink {
public:
    TestSink(Rect out, int channels)
        : m_out(out), m_channels(size_t(channels)), m_counts(out.area()),
          m_values(out.area() * size_t(channels), -99.0f) {}

    bool write(const Rect& r, float* values) override {
        ++writes;
        for (int y = r.y0; y < r.y1; ++y)
            for (int x = r.x0; x < r.x1; ++x, values += m_channels) {
                if (x < m_out.x0 || x >= m_out.x1 || y < m_out.y0 || y >= m_out.y1) {
                    ++strays;
                    continue;
                }
                const size_t at =
                    size_t(y - m_out.y0) * size_t(m_out.width()) + size_t(x - m_out.x0);
                ++m_counts[at];
                std::copy(values, values + m_channels, &m_values[at * m_channels]);
                // A sink may change what it is given.
                std::fill(values, values + m_channels, 1e30f);
            }
        return true;
    }

    const std::vector<float>& values() const { return m_values; }
    const float* at(int x, int y) const {
        return &m_values[(size_t(y - m_out.y0) * size_t(m_out.width()) + size_t(x - m_out.x0)) *
                         m_channels];
    }
    /// Pixels that were written n times.
    int64_t written(int n) const { return std::count(m_counts.begin(), m_counts.end(), n); }

    std::atomic<int> writes{0}, strays{0};

private:
    Rect m_out;
    size_t m_channels;
    std::vector<std::atomic<int>> m_counts;
    std::vector<float> m_values;
};

/// The window mapped onto [0, size) starting at `to`, of which `out` is wanted.
inline ResizeMapping mapping_of(Rect window, Rect to, Rect out) {
    ResizeMapping::Axis x, y;
    x.from0 = x.window0 = window.x0;
    x.from_size = window.width();
    x.window1 = window.x1;
    x.to0 = to.x0;
    x.to_size = to.width();
    x.out0 = out.x0;
    x.out1 = out.x1;
    y.from0 = y.window0 = window.y0;
    y.from_size = window.height();
    y.window1 = window.y1;
    y.to0 = to.y0;
    y.to_size = to.height();
    y.out0 = out.y0;
    y.out1 = out.y1;
    return {x, y};
}

inline Job job_of(const TestSource& source, int channels, int threads = 1) {
    Job job = plain_job();
    job.window = source.window();
    job.channels = channels;
    job.threads = threads;
    return job;
}

/// The result of a job that is to succeed: every pixel of `out` once, and no other.
inline std::vector<float> run(TestSource& source, const Job& job, const Mapping& mapping,
                              Rect out) {
    TestSink sink(out, job.channels);
    std::string error;
    EXPECT_EQ(enlarge(source, sink, mapping, job, &error), Outcome::done) << error;
    EXPECT_EQ(error, "");
    EXPECT_EQ(sink.strays, 0);
    EXPECT_EQ(sink.written(1), int64_t(out.area()));
    return sink.values();
}

/// Have a job do what a filter's specification says.
inline void set_filter(const char* filter, Job& job) {
    FilterOptions options;
    std::string error;
    EXPECT_TRUE(parse_filter(filter, options, error)) << error;
    job.mesh = options.mesh;
    job.surface = options.surface;
}

/// The same as another mapping without saying so: pixels are then asked for one by one.
class Opaque final : public Mapping {
public:
    explicit Opaque(const Mapping& mapping) : m_mapping(mapping) {}
    Rect reach(double x0, double y0, double x1, double y1) const override {
        // More than there is, all round where that is possible.
        Rect r = m_mapping.reach(x0 - 2, y0 - 2, x1 + 2, y1 + 2);
        return r;
    }
    void row(int y, int x0, int x1, Position* positions, uint8_t* inside) const override {
        m_mapping.row(y, x0, x1, positions, inside);
    }
    Scale scale() const override { return m_mapping.scale(); }

private:
    const Mapping& m_mapping;
};

} // namespace ddt::test
