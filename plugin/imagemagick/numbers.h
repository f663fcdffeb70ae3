// SPDX-License-Identifier: Apache-2.0
// An image's numbers, as narrow as they are. As floats a number of 8 bits and the same one of 16
// may differ in the last place; so what ImageMagick widened goes back before it is worked on.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "plugin/host/buffer.h"
#include "plugin/imagemagick/api.h"

namespace ddt::magick {

constexpr int largest_code = 65535;

/// What ImageMagick keeps: integers of 16 bits or, with HDRI, floats of any value, of which it
/// gives shares of 65535.
#if MAGICKCORE_HDRI_ENABLE
using Number = float;
constexpr StorageType number_type = FloatPixel;
#else
using Number = uint16_t;
constexpr StorageType number_type = ShortPixel;
#endif

inline float share_of(int code) {
    return float(code * (1.0 / largest_code));
}

/// Codes of 16 bits that were made floats, or empty if one of them is another number.
inline std::vector<uint16_t> of_16_bits(const std::vector<float>& numbers) {
    std::vector<uint16_t> codes;
    codes.reserve(numbers.size());
    for (const float number : numbers) {
        const double code = std::nearbyint(double(number) * largest_code);
        if (!(code >= 0 && code <= largest_code && share_of(int(code)) == number))
            return {};
        codes.push_back(uint16_t(code));
    }
    return codes;
}

/// Codes of 8 bits that were made such of 16, or empty if one of them is another number.
inline std::vector<uint8_t> of_8_bits(const std::vector<uint16_t>& codes) {
    constexpr uint16_t step = largest_code / 255;
    std::vector<uint8_t> bytes;
    bytes.reserve(codes.size());
    for (const uint16_t code : codes) {
        if (code % step != 0)
            return {};
        bytes.push_back(uint8_t(code / step));
    }
    return bytes;
}

template <class T>
host::Buffer buffer_of(std::vector<T>& numbers, const Rect& box, int channels) {
    const ptrdiff_t size = sizeof(T), pixel = size * channels;
    const host::Sample sample = size == 1   ? host::Sample::uint8
                                : size == 2 ? host::Sample::uint16
                                            : host::Sample::float32;
    numbers.resize(box.area() * size_t(channels));
    return {numbers.data(), pixel * box.width(), pixel, size, box, sample};
}

/// The numbers of an image, for host::Enlargement::from.
class Numbers {
public:
    /// Of the channels that `map` names. False with an exception.
    bool take(const Image& image, const Rect& window, const char* map, int channels,
              ExceptionInfo* exception) {
        std::vector<Number> numbers;
        m_buffer = buffer_of(numbers, window, channels);
        if (ExportImagePixels(&image, 0, 0, image.columns, image.rows, map, number_type,
                              numbers.data(), exception) == MagickFalse)
            return false;
        keep(std::move(numbers), window, channels);
        if (image.depth <= 8 && !m_codes.empty()) {
            m_bytes = of_8_bits(m_codes);
            if (!m_bytes.empty())
                m_buffer = buffer_of(m_bytes, window, channels);
        }
        return true;
    }
    const host::Buffer& buffer() const { return m_buffer; }

private:
    void keep(std::vector<uint16_t> codes, const Rect& window, int channels) {
        m_codes = std::move(codes);
        m_buffer = buffer_of(m_codes, window, channels);
    }
    void keep(std::vector<float> floats, const Rect& window, int channels) {
        m_floats = std::move(floats);
        m_buffer = buffer_of(m_floats, window, channels);
        std::vector<uint16_t> codes = of_16_bits(m_floats);
        if (!codes.empty())
            keep(std::move(codes), window, channels);
    }

    std::vector<float> m_floats;
    std::vector<uint16_t> m_codes;
    std::vector<uint8_t> m_bytes;
    host::Buffer m_buffer;
};

} // namespace ddt::magick
