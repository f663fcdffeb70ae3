// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/sink.h"

#include <cstdint>

#include "plugin/colour/colour_pixels.h"
#include "plugin/image/pixels.h"

namespace ddt {

bool ImageSink::write(const Rect& r, float* values) {
    const Writing& w = m_writing;
    if (write_codes(r, values))
        return true;
    if (w.bits != OIIO::TypeUnknown) {
        write_pixels(m_image, r, w.chbegin, w.chend, w.bits, values);
    } else {
        from_light(w.light, w.colour, values, r.area(), w.channels);
        write_floats(m_image, r, w.chbegin, w.chend, values, w.channels);
    }
    return true;
}

/// Whether numbers are stored without a conversion but to the image's type.
bool ImageSink::as_they_are() const {
    const Writing& w = m_writing;
    return w.bits == OIIO::TypeUnknown && ddt::as_they_are(w.light, w.colour);
}

/// Floats that stay as they are.
float* ImageSink::place(const Rect& r, size_t& row) {
    const Writing& w = m_writing;
    constexpr OIIO::stride_t size = sizeof(float);
    const bool whole = w.chend - w.chbegin == w.channels &&
                       m_image.pixel_stride() == size * w.channels &&
                       m_image.scanline_stride() % size == 0;
    if (m_image.spec().format != OIIO::TypeFloat || !whole || !as_they_are())
        return nullptr;
    void* const first = address(m_image, r.x0, r.y0, w.chbegin);
    if (reinterpret_cast<uintptr_t>(first) % alignof(float) != 0) // a caller's memory
        return nullptr;
    row = size_t(m_image.scanline_stride() / size);
    return static_cast<float*>(first);
}

bool ImageSink::takes_halfs() const {
    const Writing& w = m_writing;
    return m_image.spec().format == OIIO::TypeHalf && w.chend - w.chbegin == w.channels &&
           as_they_are();
}

const CodeTable* ImageSink::takes_codes() const {
    const Writing& w = m_writing;
    return w.bits == OIIO::TypeUnknown && all_alike(w.light, w.colour, w.channels) &&
                   w.chend - w.chbegin == w.channels && m_image.spec().format == OIIO::TypeUInt8
               ? w.light.codes()
               : nullptr;
}

bool ImageSink::write_packed(const Rect& r, const void* numbers) {
    const Writing& w = m_writing;
    write_pixels(m_image, r, w.chbegin, w.chend, m_image.spec().format, numbers);
    return true;
}

/// The usual case at once.
bool ImageSink::write_codes(const Rect& r, const float* values) {
    const CodeTable* codes = takes_codes();
    if (!codes || m_image.pixel_stride() != m_writing.channels)
        return false;
    const size_t row = size_t(r.width()) * size_t(m_writing.channels);
    for (int y = r.y0; y < r.y1; ++y, values += row)
        codes->encode(values, static_cast<uint8_t*>(address(m_image, r.x0, y, m_writing.chbegin)),
                      row);
    return true;
}

} // namespace ddt
