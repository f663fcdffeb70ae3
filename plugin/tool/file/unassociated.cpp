// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/unassociated.h"

#include <cstring>
#include <vector>

#include <OpenImageIO/imagebufalgo.h>

#include "plugin/tool/file/picture.h"

namespace ddt::tool {

namespace {

constexpr const char* asked = "oiio:UnassociatedAlpha";

} // namespace

bool keeps_unassociated(const std::string& format) {
    // JPEG 2000 does without saying so; other formats with both kinds are associated when written.
    return format == "png" || format == "targa" || format == "tiff";
}

bool Unassociated::read(const std::string& path, std::string& error) {
    OIIO::ImageSpec hints;
    hints.attribute(asked, 1);
    return open_image(path, m_image, error, 0, &hints);
}

Unassociated::operator bool() const {
    return m_image.initialized() && m_image.spec().alpha_channel >= 0 &&
           m_image.spec().get_int_attribute(asked) != 0;
}

OIIO::ImageBuf Unassociated::associated() const {
    OIIO::ImageBuf floats = m_image.copy(OIIO::TypeFloat);
    floats.specmod().erase_attribute(asked);
    OIIO::ImageBufAlgo::premult(floats, floats);
    return floats;
}

bool Unassociated::put(const OIIO::ImageBuf& associated, const OIIO::ImageBuf& changed,
                       std::string& error) {
    const auto channels = size_t(m_image.nchannels()), width = size_t(m_image.spec().width);
    OIIO::ImageBuf straight;
    if (!OIIO::ImageBufAlgo::unpremult(straight, changed)) {
        error = straight.geterror();
        return false;
    }
    std::vector<float> before(width * channels), after(before.size());
    OIIO::ROI row = m_image.roi();
    for (int y = m_image.ybegin(); y < m_image.yend(); ++y) {
        row.ybegin = y;
        row.yend = y + 1;
        if (!associated.get_pixels(row, OIIO::TypeFloat, before.data()) ||
            !changed.get_pixels(row, OIIO::TypeFloat, after.data())) {
            error = "out of memory";
            return false;
        }
        for (size_t x = 0; x < width; ++x) {
            const size_t at = x * channels;
            if (std::memcmp(&before[at], &after[at], channels * sizeof(float)) == 0)
                continue;
            const int column = m_image.xbegin() + int(x);
            straight.getpixel(column, y, &after[at], int(channels));
            m_image.setpixel(column, y, &after[at], int(channels));
        }
    }
    return true;
}

} // namespace ddt::tool
