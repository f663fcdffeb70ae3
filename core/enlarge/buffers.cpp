// SPDX-License-Identifier: Apache-2.0
// enlarge() from and to plain buffers.
#include <algorithm>
#include <cstring>

#include "ddt/core.h"

namespace ddt {

namespace {

class BufferSource final : public Source {
public:
    BufferSource(const float* pixels, const float* guide, int width, int channels)
        : m_pixels(pixels), m_guide(guide), m_width(size_t(width)), m_channels(size_t(channels)) {}

    bool read(const Rect& r, float* values, float* guide) override {
        const auto width = size_t(r.width());
        for (int y = r.y0; y < r.y1; ++y, values += width * m_channels, guide += width) {
            const size_t first = size_t(y) * m_width + size_t(r.x0);
            std::memcpy(values, m_pixels + first * m_channels, width * m_channels * sizeof(float));
            if (m_guide)
                std::memcpy(guide, m_guide + first, width * sizeof(float));
            else
                for (size_t x = 0; x < width; ++x)
                    guide[x] = mean(values + x * m_channels);
        }
        return true;
    }

private:
    float mean(const float* pixel) const {
        if (m_channels < 3)
            return pixel[0];
        return (pixel[0] + pixel[1] + pixel[2]) * (1.0f / 3.0f);
    }

    const float* m_pixels;
    const float* m_guide;
    size_t m_width, m_channels;
};

class BufferSink final : public Sink {
public:
    BufferSink(float* pixels, int width, int channels)
        : m_pixels(pixels), m_width(size_t(width)), m_channels(size_t(channels)) {}

    bool write(const Rect& r, float* values) override {
        const size_t row = size_t(r.width()) * m_channels;
        for (int y = r.y0; y < r.y1; ++y, values += row)
            std::memcpy(m_pixels + (size_t(y) * m_width + size_t(r.x0)) * m_channels, values,
                        row * sizeof(float));
        return true;
    }

    float* place(const Rect& r, size_t& row) override {
        row = m_width * m_channels;
        return m_pixels + (size_t(r.y0) * m_width + size_t(r.x0)) * m_channels;
    }

private:
    float* m_pixels;
    size_t m_width, m_channels;
};

} // namespace

Outcome enlarge(const float* src, int width, int height, int channels, const float* guide,
                float* dst, int dst_width, int dst_height, const SurfaceOptions& surface,
                const MeshOptions& mesh, int threads, std::string* error) {
    if (dst_width < width || dst_height < height || !src || !dst) {
        if (error)
            *error = "ddt: the output must not be smaller than the input, nor a buffer null";
        return Outcome::bad_job;
    }
    Job job;
    job.window = {0, 0, width, height};
    job.channels = channels;
    job.surface = surface;
    job.mesh = mesh;
    job.threads = threads;
    const auto axis = [](int from, int to) {
        ResizeMapping::Axis a;
        a.from_size = a.window1 = from;
        a.to_size = a.out1 = to;
        return a;
    };
    BufferSource source(src, guide, width, channels);
    BufferSink sink(dst, dst_width, channels);
    const ResizeMapping mapping(axis(width, dst_width), axis(height, dst_height));
    return enlarge(source, sink, mapping, job, error);
}

} // namespace ddt
