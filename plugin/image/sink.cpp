#include "plugin/image/sink.h"

#include "plugin/image/colourpixels.h"
#include "plugin/image/pixels.h"

namespace ddt {

bool ImageSink::write(const Rect& r, float* values) {
    const Writing& w = m_writing;
    if (w.bits != OIIO::TypeUnknown) {
        write_pixels(m_image, r, w.chbegin, w.chend, w.bits, values);
    } else {
        from_light(w.light, w.colour, values, r.area(), w.channels);
        write_floats(m_image, r, w.chbegin, w.chend, values, w.channels);
    }
    return true;
}

} // namespace ddt
