// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/source.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "plugin/colour/colourpixels.h"
#include "plugin/image/pixels.h"

namespace ddt {

ImageSource::ImageSource(const OIIO::ImageBuf& image, const Reading& reading)
    : m_image(image), m_reading(reading) {
    m_all = int(reading.selected.size()) == image.nchannels();
    for (size_t i = 0; i < reading.selected.size(); ++i)
        m_all &= reading.selected[i] == int(i);
}

std::string ImageSource::error() const {
    const std::lock_guard<std::mutex> lock(m_mutex);
    return m_error;
}

bool ImageSource::read_row(int y, const Rect& r, float* pixels, float* guide) {
    const int channels = m_image.nchannels();
    const size_t width = size_t(r.width());
    // IDs in integers go through the core as the bits they are.
    const OIIO::TypeDesc type = m_reading.channels.raw ? m_image.spec().format : OIIO::TypeFloat;
    std::string error;
    if (!read_pixels(m_image, {r.x0, y, r.x1, y + 1}, 0, channels, type, pixels, error)) {
        const std::lock_guard<std::mutex> lock(m_mutex);
        if (m_error.empty())
            m_error = error;
        return false;
    }
    if (m_reading.channels.raw) {
        std::fill_n(guide, width, 0.0f);
        return true;
    }
    std::vector<size_t> nans;
    for (size_t i = 0; m_reading.keep_nan && i < width * size_t(channels); ++i)
        if (std::isnan(pixels[i]))
            nans.push_back(i);
    to_light(m_reading.light, m_reading.channels.colour, pixels, width, channels);
    for (const size_t i : nans)
        pixels[i] = std::numeric_limits<float>::quiet_NaN();
    make_guide(m_reading.guide, pixels, width, channels, guide);
    return true;
}

bool ImageSource::read(const Rect& r, float* values, float* guide) {
    const size_t width = size_t(r.width()), channels = size_t(m_image.nchannels());
    const size_t selected = m_reading.selected.size();
    std::vector<float> row(m_all ? 0 : width * channels);
    for (int y = r.y0; y < r.y1; ++y, values += width * selected, guide += width) {
        float* pixels = m_all ? values : row.data();
        if (!read_row(y, r, pixels, guide))
            return false;
        if (!m_all)
            for (size_t i = 0; i < width; ++i)
                for (size_t k = 0; k < selected; ++k)
                    values[i * selected + k] = pixels[i * channels + m_reading.selected[k]];
    }
    return true;
}

} // namespace ddt
