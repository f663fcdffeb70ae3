// SPDX-License-Identifier: Apache-2.0
// Plain buffers as a source and a sink.
#pragma once

#include <cstring>

#include "core/base/float_mode.h"
#include "ddt/core.h"

namespace ddt {

class BufferSource final : public Source {
public:
    BufferSource(const float* pixels, const float* guide, int width, int channels)
        : m_pixels(pixels), m_guide(guide), m_width(size_t(width)), m_channels(size_t(channels)) {}

    bool read(const Rect& r, float* values, float* guide) override {
        const DenormalsAreZero as_on_gpus;
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

} // namespace ddt
