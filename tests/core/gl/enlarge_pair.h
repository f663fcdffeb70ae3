// SPDX-License-Identifier: Apache-2.0
// One job done on two devices, to be compared bit for bit.
#pragma once

#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/enlarge/buffers.h"
#include "ddt/core.h"
#include "ddt/names.h"
#include "tests/core/plain.h"

namespace ddt::test {

/// A picture of floats with its guide.
struct Picture {
    int width, height, channels;
    std::vector<float> values, guide;
};

/// Options of every scheme there is, with every cost.
inline std::vector<MeshOptions> every_scheme_and_cost() {
    std::vector<MeshOptions> all;
    for (const std::string& scheme : scheme_names())
        for (const std::string& cost : cost_names()) {
            MeshOptions mesh = plain_mesh();
            EXPECT_TRUE(find_scheme(scheme, mesh)) << scheme;
            EXPECT_TRUE(find_cost(cost, mesh.cost)) << cost;
            if (mesh.scheme == Scheme::annealing)
                mesh.max_iterations = 5; // it does as many as it may
            all.push_back(mesh);
        }
    return all;
}

/// What is done to it.
struct Order {
    Job job = plain_job();
    int out_width = 0, out_height = 0;
    const Mapping* mapping = nullptr; ///< null: window to window
};

inline BufferSource source_of(const Picture& picture) {
    return {picture.values.data(), picture.guide.data(), picture.width, picture.channels};
}

/// Keeps the bits, and counts how often each pixel came.
class BitsSink final : public Sink {
public:
    BitsSink(int width, int height, int channels)
        : m_width(width), m_channels(channels),
          bits(size_t(width) * size_t(height) * size_t(channels), 0xdeadbeefu),
          times(size_t(width) * size_t(height)) {}
    bool write(const Rect& r, float* values) override {
        const size_t row = size_t(r.width()) * size_t(m_channels);
        for (int y = r.y0; y < r.y1; ++y, values += row) {
            const size_t first = size_t(y) * size_t(m_width) + size_t(r.x0);
            std::memcpy(&bits[first * size_t(m_channels)], values, row * 4);
            for (size_t i = 0; i < size_t(r.width()); ++i)
                ++times[first + i];
        }
        return true;
    }

private:
    int m_width, m_channels;

public:
    std::vector<uint32_t> bits;
    std::vector<uint8_t> times;
};

struct Result {
    Outcome outcome;
    std::string error;
    Statistics statistics;
    std::vector<uint32_t> bits;
    std::vector<uint8_t> times;
};

inline Result enlarge_on(Device device, const Picture& picture, const Order& order) {
    Job job = order.job;
    Result result;
    job.window = {0, 0, picture.width, picture.height};
    job.channels = picture.channels;
    job.device = device;
    job.statistics = &result.statistics;
    BufferSource source = source_of(picture);
    BitsSink sink(order.out_width, order.out_height, picture.channels);
    const ResizeMapping whole(ResizeMapping::Axis::whole(picture.width, order.out_width),
                              ResizeMapping::Axis::whole(picture.height, order.out_height));
    result.outcome =
        enlarge(source, sink, order.mapping ? *order.mapping : whole, job, &result.error);
    result.bits = std::move(sink.bits);
    result.times = std::move(sink.times);
    return result;
}

/// Fails the test unless the job gives the same bits on the device as on the CPU, and was done
/// there.
inline void expect_same(Device device, const Picture& picture, const Order& order,
                        const std::string& what) {
    const Result cpu = enlarge_on(Device::cpu, picture, order);
    const Result gpu = enlarge_on(device, picture, order);
    ASSERT_EQ(cpu.outcome, Outcome::done) << what << ": " << cpu.error;
    ASSERT_EQ(gpu.outcome, Outcome::done) << what << ": " << gpu.error;
    EXPECT_EQ(gpu.statistics.device, device) << what;
    EXPECT_EQ(gpu.statistics.flips, cpu.statistics.flips) << what;
    EXPECT_EQ(gpu.statistics.evaluations, cpu.statistics.evaluations) << what;
    EXPECT_EQ(gpu.statistics.iterations, cpu.statistics.iterations) << what;
    EXPECT_EQ(gpu.statistics.rounds, cpu.statistics.rounds) << what;
    EXPECT_EQ(gpu.statistics.pixels, cpu.statistics.pixels) << what;
    EXPECT_EQ(gpu.times, cpu.times) << what;
    size_t differing = 0, first = 0;
    for (size_t i = cpu.bits.size(); i-- > 0;)
        if (cpu.bits[i] != gpu.bits[i]) {
            ++differing;
            first = i;
        }
    EXPECT_EQ(differing, 0u) << what << ": " << differing << " of " << cpu.bits.size()
                             << " differ, the first at " << first << ": cpu " << std::hex
                             << cpu.bits[first] << ", gpu " << gpu.bits[first];
}

} // namespace ddt::test
