// SPDX-License-Identifier: Apache-2.0
#include "plugin/imagebuf/holes.h"

#include <cmath>

#include "ddt/points.h"
#include "plugin/image/source.h"
#include "plugin/image/windows.h"
#include "plugin/imagebuf/guarded.h"

namespace ddt {

namespace {

/// Which pixels are missing; whether any is.
bool find_missing(const std::vector<float>& values, size_t channels, int alpha, Missing what,
                  std::vector<uint8_t>& missing) {
    bool any = false;
    for (size_t i = 0; i < missing.size(); ++i) {
        const float* pixel = &values[i * channels];
        bool is = what == Missing::alpha && alpha >= 0 && pixel[alpha] == 0.0f;
        for (size_t c = 0; c < channels; ++c)
            is |= std::isnan(pixel[c]);
        missing[i] = is;
        any |= is;
    }
    return any;
}

} // namespace

bool fill_image(const OIIO::ImageBuf& src, const Options& options, Missing what,
                OIIO::ImageBuf& filled, std::string& error) {
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
    std::vector<uint8_t> missing(window.area());
    if (!find_missing(values, channels, roles.alpha, what, missing))
        return true;
    std::vector<float> guide(window.area());
    {
        Reading reading;
        if (!plan_reading(src, options, roi, reading, error))
            return false;
        ImageSource source(src, reading);
        std::vector<float> unused(window.area() * reading.selected.size());
        if (!source.read(window, unused.data(), guide.data())) {
            error = source.error();
            return false;
        }
    }
    std::vector<float> whole = values;
    if (!fill_holes(whole.data(), window.width(), window.height(), int(channels),
                    roles.kinds.data(), guide.data(), missing.data(), options.mesh, &error))
        return false;
    // A pixel that lacks some channels keeps the others.
    for (size_t i = 0; i < missing.size(); ++i) {
        const bool empty = what == Missing::alpha && roles.alpha >= 0 &&
                           values[i * channels + size_t(roles.alpha)] == 0.0f;
        for (size_t c = 0; c < channels && !empty; ++c)
            if (!std::isnan(values[i * channels + c]))
                whole[i * channels + c] = values[i * channels + c];
    }
    if (!filled.copy(src) || !filled.set_pixels(roi, OIIO::TypeFloat, whole.data())) {
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
        if (!fill_image(src, options, missing, filled, error))
            return false;
        return dst.copy(filled.initialized() ? filled : src);
    });
}

} // namespace ddt
