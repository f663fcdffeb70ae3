// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/source.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "plugin/colour/colour_pixels.h"
#include "plugin/image/pixels.h"

namespace ddt {

ImageSource::ImageSource(const OIIO::ImageBuf& image, const Reading& reading, Arrival* arrival)
    : m_image(image), m_reading(reading), m_arrival(arrival) {
    m_all = int(reading.selected.size()) == image.nchannels();
    for (size_t i = 0; i < reading.selected.size(); ++i)
        m_all &= reading.selected[i] == int(i);
}

std::string ImageSource::error() const {
    const std::lock_guard<std::mutex> lock(m_mutex);
    return m_error;
}

bool ImageSource::fail(const std::string& error) {
    const std::lock_guard<std::mutex> lock(m_mutex);
    if (m_error.empty())
        m_error = error;
    return false;
}

/// Wait for the rows above `end`.
bool ImageSource::wait_for(int end) {
    std::string error;
    return !m_arrival || m_arrival->wait_for(end, error) || fail(error);
}

/// The image's numbers to linear light.
void ImageSource::convert(float* pixels, size_t count, int channels) const {
    std::vector<size_t> nans;
    const std::vector<Channel>& kinds = m_reading.channels.kinds;
    for (size_t i = 0; m_reading.keep_nan && i < count * size_t(channels); ++i)
        if (std::isnan(pixels[i]) && kinds[i % size_t(channels)] != Channel::nearest)
            nans.push_back(i);
    to_light(m_reading.light, m_reading.channels.colour, pixels, count, channels);
    for (const size_t i : nans)
        pixels[i] = std::numeric_limits<float>::quiet_NaN();
}

bool ImageSource::read_row(int y, const Rect& r, float* pixels, float* guide) {
    const int channels = m_image.nchannels();
    const size_t width = size_t(r.width());
    // IDs in integers go through the core as the bits they are.
    const OIIO::TypeDesc type = m_reading.channels.raw ? m_image.spec().format : OIIO::TypeFloat;
    std::string error;
    if (!read_pixels(m_image, {r.x0, y, r.x1, y + 1}, 0, channels, type, pixels, error))
        return fail(error);
    if (m_reading.channels.raw) {
        std::fill_n(guide, width, 0.0f);
        return true;
    }
    if (m_arrival)
        m_arrival->complete({r.x0, y, r.x1, y + 1}, pixels);
    convert(pixels, width, channels);
    make_guide(m_reading.guide, pixels, width, channels, guide);
    return true;
}

std::vector<float> ImageSource::codes() {
    const OIIO::TypeDesc type = m_image.spec().format;
    const bool bytes = type == OIIO::TypeUInt8;
    if (!m_all || m_reading.channels.raw || !(bytes || type == OIIO::TypeHalf))
        return {};
    return light_of_codes(m_reading.light, m_reading.channels.colour, m_image.nchannels(),
                          bytes ? 8 : 16, [&](const void* numbers, int n, float* values) {
                              OIIO::convert_pixel_values(type, numbers, OIIO::TypeFloat, values, n);
                          });
}

bool ImageSource::read_codes(const Rect& r, void* codes, float* guide) {
    const int channels = m_image.nchannels();
    const OIIO::TypeDesc type = m_image.spec().format;
    std::string error;
    if (!wait_for(r.y1))
        return false;
    if (!read_pixels(m_image, r, 0, channels, type, codes, error))
        return fail(error);
    const size_t width = size_t(r.width()), row = width * size_t(channels);
    std::vector<float> pixels(row);
    const char* from = static_cast<const char*>(codes);
    for (int y = r.y0; y < r.y1; ++y, from += row * type.size(), guide += width) {
        OIIO::convert_pixel_values(type, from, OIIO::TypeFloat, pixels.data(), int(row));
        convert(pixels.data(), width, channels);
        make_guide(m_reading.guide, pixels.data(), width, channels, guide);
    }
    return true;
}

bool ImageSource::read(const Rect& r, float* values, float* guide) {
    const size_t width = size_t(r.width()), channels = size_t(m_image.nchannels());
    const size_t selected = m_reading.selected.size();
    if (!wait_for(r.y1))
        return false;
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
