// SPDX-License-Identifier: Apache-2.0
#include "tests/differential/ways.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/base/half.h"
#include "core/base/vectors/gathers.h"
#include "core/enlarge/buffers.h"
#include "ddt/names.h"
#include "tests/use_simd.h"

namespace ddt::test {

namespace {

float rounded_to_half(float v) {
    return float_of_half(half_of_float(v));
}

/// The output pixels of a part; those that nothing is written to keep a mark.
class PictureSink final : public Sink {
public:
    PictureSink(const Rect& part, int channels, const Way& way)
        : values(part.area() * size_t(channels), Done::mark), m_part(part), m_channels(channels),
          m_way(way) {}
    bool write(const Rect& r, float* from) override {
        const size_t row = size_t(r.width()) * size_t(m_channels);
        for (int y = r.y0; y < r.y1; ++y, from += row) {
            std::memcpy(at(r.x0, y), from, row * sizeof(float));
            if (m_way.halfs)
                std::transform(from, from + row, at(r.x0, y), rounded_to_half);
        }
        return true;
    }
    bool takes_halfs() const override { return m_way.halfs; }
    bool write_packed(const Rect& r, const void* numbers) override {
        const auto* from = static_cast<const uint16_t*>(numbers);
        const size_t row = size_t(r.width()) * size_t(m_channels);
        for (int y = r.y0; y < r.y1; ++y, from += row)
            std::transform(from, from + row, at(r.x0, y), float_of_half);
        return true;
    }
    float* place(const Rect& r, size_t& row) override {
        row = size_t(m_part.width()) * size_t(m_channels);
        return m_way.places ? at(r.x0, r.y0) : nullptr;
    }

    std::vector<float> values;

private:
    float* at(int x, int y) {
        return &values[(size_t(y - m_part.y0) * size_t(m_part.width()) + size_t(x - m_part.x0)) *
                       size_t(m_channels)];
    }
    Rect m_part;
    int m_channels;
    const Way& m_way;
};

/// The instruction sets that were compiled and this machine has, the narrowest first.
std::vector<int64_t> targets() {
    std::vector<int64_t> all = hwy::SupportedAndGeneratedTargets();
    std::sort(all.rbegin(), all.rend()); // the larger the number, the narrower
    return all;
}

} // namespace

Way reference_way() {
    return {"reference", targets().front()};
}

std::vector<Way> other_ways(const std::vector<Device>& devices) {
    std::vector<Way> ways;
    for (const int64_t target : targets())
        if (target != reference_way().target)
            ways.push_back({hwy::TargetName(target), target});
    ways.push_back({gathers_are_quick() ? "loads" : "gathers"});
    ways.back().other_reads = true;
    ways.push_back({"2 threads", 0, 2});
    ways.push_back({"7 threads, in place", 0, 7, Device::cpu, false, true});
    ways.push_back({"a part", 0, 2, Device::cpu, true});
    for (const Device device : devices) {
        ways.push_back({device_name(device), 0, 2, device});
        ways.push_back({std::string(device_name(device)) + ", a part", 0, 2, device, true});
        ways.push_back(
            {std::string(device_name(device)) + ", halfs", 0, 2, device, false, false, true});
    }
    return ways;
}

Done run(const RandomJob& job, const Way& way) {
    test::use_simd(way.target);
    const bool quick = gathers_are_quick();
    set_gathers_are_quick(quick != way.other_reads);
    const Rect& out = way.part ? job.part : job.out;
    const std::unique_ptr<Mapping> mapping = mapping_of_part(job, out);
    BufferSource source(job.values.data(), job.guide.data(), job.width, job.job.channels);
    PictureSink sink(out, job.job.channels, way);
    Job j = job.job;
    j.threads = way.threads;
    j.device = way.device;
    Done done;
    done.outcome = enlarge(source, sink, *mapping, j, &done.error);
    set_gathers_are_quick(quick);
    done.values = std::move(sink.values);
    return done;
}

size_t differing(const RandomJob& job, const Done& reference, const Way& way, const Done& done) {
    const Rect& r = way.part ? job.part : job.out;
    const auto row = size_t(r.width()) * size_t(job.job.channels);
    size_t count = 0;
    for (int y = r.y0; y < r.y1; ++y) {
        const float* expected = &reference.values[(size_t(y) * size_t(job.out.x1) + size_t(r.x0)) *
                                                  size_t(job.job.channels)];
        const float* got = &done.values[size_t(y - r.y0) * row];
        for (size_t i = 0; i < row; ++i) {
            const float wanted =
                way.halfs && expected[i] != Done::mark ? rounded_to_half(expected[i]) : expected[i];
            count += std::memcmp(&wanted, got + i, sizeof(float)) != 0;
        }
    }
    return count;
}

const char* broken_promise(const RandomJob& job, const std::vector<float>& values) {
    const bool corrected = job.job.surface.consistency > 0;
    for (int c = 0; c < job.job.channels; ++c) {
        const Channel kind = job.job.kinds[size_t(c)];
        if (kind == Channel::nearest)
            continue;
        float low = INFINITY, high = -INFINITY;
        bool finite = true;
        for (size_t i = size_t(c); i < job.values.size(); i += size_t(job.job.channels)) {
            finite &= std::isfinite(job.values[i]);
            low = std::min(low, job.values[i]);
            high = std::max(high, job.values[i]);
        }
        if (!finite)
            continue;
        // What is near zero becomes zero when it is read.
        low = std::min(low, 0.0f);
        high = std::max(high, 0.0f);
        for (size_t i = size_t(c); i < values.size(); i += size_t(job.job.channels)) {
            const float v = values[i];
            if (v == Done::mark)
                continue;
            if (!std::isfinite(v))
                return "a finite channel became infinite or NaN";
            const bool share = kind == Channel::alpha && corrected;
            if ((!corrected && (v < low || v > high)) ||
                (share && (v < low || v > std::max(high, 1.0f))))
                return "a channel left the range of its pixels";
        }
    }
    return nullptr;
}

} // namespace ddt::test
