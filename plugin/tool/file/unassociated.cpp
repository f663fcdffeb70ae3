// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/unassociated.h"

#include <cstring>
#include <vector>

#include <OpenImageIO/imagebufalgo.h>

#include "plugin/image/memory.h"
#include "plugin/tool/file/open_image.h"

namespace ddt::tool {

namespace {

constexpr const char* asked = "oiio:UnassociatedAlpha";

} // namespace

bool may_be_unassociated(const OIIO::ImageBuf& image) {
    // JPEG 2000 does without saying so; other formats with both kinds are associated when written.
    const std::string format(image.file_format_name());
    return image.spec().alpha_channel >= 0 &&
           (format == "png" || format == "targa" || format == "tiff");
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

bool Unassociated::associate(OIIO::ImageBuf& floats, std::string& error) const {
    OIIO::ImageSpec spec = m_image.spec();
    spec.set_format(OIIO::TypeFloat);
    spec.erase_attribute(asked);
    if (!check_size(spec.roi(), spec.nchannels, spec.format, error) ||
        !take_memory(floats, spec, error))
        return false;
    if (m_image.get_pixels(spec.roi(), OIIO::TypeFloat, floats.localpixels()) &&
        OIIO::ImageBufAlgo::premult(floats, floats))
        return true;
    error = why_unreadable(floats, std::string(m_image.name()));
    return false;
}

void Unassociated::put(const OIIO::ImageBuf& associated, const OIIO::ImageBuf& changed) {
    const OIIO::ImageSpec& spec = m_image.spec();
    const auto channels = size_t(spec.nchannels), width = size_t(spec.width);
    std::vector<float> before(width * channels), after(before.size());
    OIIO::ROI row = m_image.roi();
    for (int y = m_image.ybegin(); y < m_image.yend(); ++y) {
        row.ybegin = y;
        row.yend = y + 1;
        associated.get_pixels(row, OIIO::TypeFloat, before.data());
        changed.get_pixels(row, OIIO::TypeFloat, after.data());
        for (size_t x = 0; x < width; ++x) {
            float* const pixel = &after[x * channels];
            if (std::memcmp(&before[x * channels], pixel, channels * sizeof *pixel) == 0)
                continue;
            // As OpenImageIO divides.
            const float alpha = pixel[spec.alpha_channel];
            for (int c = 0; c < spec.nchannels && alpha != 0; ++c)
                if (c != spec.alpha_channel && c != spec.z_channel)
                    pixel[c] /= alpha;
            m_image.setpixel(m_image.xbegin() + int(x), y, pixel, spec.nchannels);
        }
    }
}

} // namespace ddt::tool
