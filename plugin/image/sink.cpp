#include "plugin/image/sink.h"

#include <cmath>

#include "plugin/image/colourpixels.h"
#include "plugin/image/pixels.h"

namespace ddt {

bool ImageSink::write(const Rect& r, float* values) {
    const size_t count = r.area();
    const bool floats = m_writing.type == OIIO::TypeFloat;
    if (floats) {
        from_light(m_writing.light, m_writing.colour, values, count, m_writing.channels);
        // Integers have no NaN, and converting one to an integer is undefined.
        if (!m_image.spec().format.is_floating_point())
            for (size_t i = 0; i < count * m_writing.channels; ++i)
                values[i] = std::isnan(values[i]) ? 0.0f : values[i];
    }
    write_pixels(m_image, r, m_writing.chbegin, m_writing.chend, m_writing.type, values,
                 OIIO::stride_t(sizeof(float)) * m_writing.channels);
    return true;
}

} // namespace ddt
