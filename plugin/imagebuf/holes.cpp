// SPDX-License-Identifier: Apache-2.0
#include "plugin/imagebuf/holes.h"

#include "core/tin/fill.h"
#include "plugin/image/source.h"
#include "plugin/image/windows.h"
#include "plugin/imagebuf/guarded.h"

namespace ddt {

bool fill_image(const OIIO::ImageBuf& src, const Options& options, Holes holes,
                OIIO::ImageBuf& filled, std::string& error) {
    if (holes == Holes::keep)
        return true;
    if (is_id_type(src.spec().format) || is_id_type(src.nativespec().format) || src.spec().deep)
        return true; // identifiers are neither NaN nor to be interpolated
    OIIO::ROI roi = src.roi();
    const Rect window = rect_of(roi);
    const auto channels = size_t(src.nchannels());
    std::vector<float> values(window.area() * channels);
    if (!src.get_pixels(roi, OIIO::TypeFloat, values.data())) {
        error = src.geterror();
        return false;
    }
    const Channels roles = channels_of(src.spec(), src.nativespec().format);
    std::vector<float> guide(window.area());
    const HoledImage image{values.data(), guide.data(),       window.width(), window.height(),
                           int(channels), roles.kinds.data(), false};
    std::vector<uint8_t> missing;
    if (!find_missing(image, holes, missing))
        return true;
    missing = {};
    {
        Reading reading;
        Options as_it_is = options;
        as_it_is.holes = Holes::keep;
        if (!plan_reading(src, as_it_is, roi, reading, error))
            return false;
        ImageSource source(src, reading);
        std::vector<float> unused(window.area() * reading.selected.size());
        if (!source.read(window, unused.data(), guide.data())) {
            error = source.error();
            return false;
        }
    }
    if (!fill_missing(image, holes, options.mesh, options.device, error))
        return false;
    if (!filled.copy(src) || !filled.set_pixels(roi, OIIO::TypeFloat, values.data())) {
        error = filled.geterror();
        return false;
    }
    return true;
}

bool fill(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, const Options& options, Missing missing) {
    return guarded(dst, [&](OIIO::ROI&, std::string& error) {
        if (!check_source(src, error))
            return false;
        OIIO::ImageBuf filled;
        const Holes holes = missing == Missing::alpha ? Holes::fill_alpha : Holes::fill;
        if (!fill_image(src, options, holes, filled, error))
            return false;
        return dst.copy(filled.initialized() ? filled : src);
    });
}

} // namespace ddt
