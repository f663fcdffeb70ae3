// SPDX-License-Identifier: Apache-2.0
// The core of this build as a module that `turns` loads beside another build's.
#include <cstring>
#include <string>

#include "ddt/core.h"
#include "ddt/option_table.h"
#include "turn.h"

namespace {

using turns::Turn;

/// Of the first of a rectangle's pixels in row y, of an image so wide.
size_t index_of(const ddt::Rect& r, int y, int width) {
    return size_t(y) * size_t(width) + size_t(r.x0);
}

class TurnSource final : public ddt::Source {
public:
    explicit TurnSource(const Turn& turn) : m_turn(turn) {}
    bool read(const ddt::Rect& r, float* values, float* guide) override {
        const auto n = size_t(r.width());
        for (int y = r.y0; y < r.y1; ++y, values += 3 * n, guide += n) {
            const size_t from = index_of(r, y, m_turn.width);
            std::memcpy(values, m_turn.pixels + 3 * from, 3 * n * sizeof(float));
            std::memcpy(guide, m_turn.guide + from, n * sizeof(float));
        }
        return true;
    }

private:
    const Turn& m_turn;
};

class TurnSink final : public ddt::Sink {
public:
    explicit TurnSink(const Turn& turn) : m_to(turn.to), m_width(turn.width * turn.scale) {}
    bool write(const ddt::Rect& r, float* values) override {
        const size_t row = 3 * size_t(r.width());
        for (int y = r.y0; y < r.y1; ++y, values += row)
            std::memcpy(m_to + 3 * index_of(r, y, m_width), values, row * sizeof(float));
        return true;
    }
    float* place(const ddt::Rect& r, size_t& row) override {
        row = 3 * size_t(m_width);
        return m_to + 3 * index_of(r, r.y0, m_width);
    }

private:
    float* m_to;
    int m_width;
};

ddt::ResizeMapping::Axis axis(int from, int scale) {
    ddt::ResizeMapping::Axis a;
    a.from_size = a.window1 = from;
    a.to_size = a.out1 = from * scale;
    return a;
}

} // namespace

extern "C" __attribute__((visibility("default"))) const char* ddt_take_turn(const Turn& turn,
                                                                            turns::Spent& spent) {
    static std::string error; // a turn at a time
    ddt::FilterOptions options;
    if (!ddt::parse_filter(turn.filter, options, error))
        return error.c_str();
    ddt::Statistics statistics;
    ddt::Job job;
    job.window = {0, 0, turn.width, turn.height};
    job.channels = 3;
    job.mesh = options.mesh;
    job.surface = options.surface;
    job.threads = turn.threads;
    job.device = ddt::Device::cpu;
    job.statistics = &statistics;
    TurnSource source(turn);
    TurnSink sink(turn);
    const ddt::ResizeMapping mapping(axis(turn.width, turn.scale), axis(turn.height, turn.scale));
    if (ddt::enlarge(source, sink, mapping, job, &error) != ddt::Outcome::done)
        return error.c_str();
    const ddt::StageTimes& t = statistics.times;
    spent = {t.triangulate, t.surface, t.sample, t.read + t.write};
    return nullptr;
}
