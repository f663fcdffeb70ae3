// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/gpu/jobs.h"

#include <chrono>
#include <cstring>
#include <stdexcept>

namespace ddt::bench {

namespace {

/// RGBA floats. Devices hand rows over, the CPU may write into their place.
class MemorySink final : public Sink {
public:
    MemorySink(int width, int height)
        : m_row(size_t(width) * 4), m_values(m_row * size_t(height), 1.0f) {}
    bool write(const Rect& r, float* values) override {
        const size_t n = size_t(r.width()) * 4;
        for (int y = r.y0; y < r.y1; ++y, values += n)
            std::memcpy(at(r.x0, y), values, n * sizeof(float));
        return true;
    }
    float* place(const Rect& r, size_t& row) override {
        row = m_row;
        return at(r.x0, r.y0);
    }

private:
    float* at(int x, int y) { return &m_values[size_t(y) * m_row + size_t(x) * 4]; }

    size_t m_row;
    std::vector<float> m_values;
};

ResizeMapping::Axis twofold(int pixels) {
    ResizeMapping::Axis a;
    a.from_size = a.window1 = pixels;
    a.to_size = a.out1 = 2 * pixels;
    return a;
}

} // namespace

std::vector<double> time_jobs(Picture& picture, const Job& job, int runs) {
    const ResizeMapping mapping(twofold(picture.width()), twofold(picture.height()));
    MemorySink sink(2 * picture.width(), 2 * picture.height());
    Statistics statistics;
    Job j = job;
    j.statistics = &statistics;
    std::vector<double> times;
    for (int i = 0; i < runs; ++i) {
        std::string error;
        const auto begin = std::chrono::steady_clock::now();
        const Outcome outcome = enlarge(picture, sink, mapping, j, &error);
        times.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
                .count());
        if (outcome != Outcome::done)
            throw std::runtime_error(error);
        if (statistics.device != job.device)
            throw std::runtime_error("another device did the job");
    }
    return times;
}

} // namespace ddt::bench
