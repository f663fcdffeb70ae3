// SPDX-License-Identifier: Apache-2.0
#include "plugin/imagebuf/holes.h"

#include <cstring>

#include "core/fill/fill.h"
#include "plugin/image/memory.h"
#include "plugin/image/pixels.h"
#include "plugin/image/reading.h"
#include "plugin/image/source.h"
#include "plugin/image/windows.h"
#include "plugin/imagebuf/copy.h"
#include "plugin/imagebuf/guarded.h"
#include "plugin/imagebuf/thread_count.h"

namespace ddt {

namespace {

/// Put the numbers of an image that differ from src's as floats; others keep bits that floats have
/// no room for.
bool put_filled(const OIIO::ImageBuf& src, const float* values, OIIO::ImageBuf& filled,
                std::string& error) {
    const Rect window = rect_of(src.roi());
    const int channels = src.nchannels();
    std::vector<float> before(size_t(window.width()) * size_t(channels));
    for (int y = window.y0; y < window.y1; ++y) {
        if (!read_pixels(src, {window.x0, y, window.x1, y + 1}, 0, channels, OIIO::TypeFloat,
                         before.data(), error))
            return false;
        for (const float& old : before) {
            if (std::memcmp(&old, values, sizeof old) != 0) {
                const int i = int(&old - before.data()), x = window.x0 + i / channels,
                          c = i % channels;
                write_pixels(filled, {x, y, x + 1, y + 1}, c, c + 1, OIIO::TypeFloat, values);
            }
            ++values;
        }
    }
    return true;
}

/// Into memory that is its caller's.
bool copy_into(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, std::string& error) {
    const OIIO::ROI to = dst.roi(), from = src.roi();
    if (to.width() != from.width() || to.height() != from.height() ||
        dst.nchannels() != src.nchannels()) {
        error = format("the destination's memory is of {} x {} pixels of {} channels; needed are "
                       "{} x {} of {}",
                       to.width(), to.height(), dst.nchannels(), from.width(), from.height(),
                       src.nchannels());
        return false;
    }
    return copy_moved(dst, src, to, to.xbegin - from.xbegin, to.ybegin - from.ybegin, Beyond::edge,
                      error);
}

} // namespace

OIIO::TypeDesc type_between(const OIIO::ImageBuf& src) {
    const OIIO::TypeDesc type = src.spec().format;
    const bool mixed = !src.nativespec().channelformats.empty();
    return type == OIIO::TypeHalf && !mixed ? OIIO::TypeFloat : type;
}

bool fill_image(const OIIO::ImageBuf& src, const Options& options, Holes holes, OIIO::TypeDesc type,
                OIIO::ImageBuf& filled, int nthreads, std::string& error) {
    if (holes == Holes::keep)
        return true;
    if (is_id_type(src.spec().format) || is_id_type(src.nativespec().format) || src.spec().deep)
        return true; // IDs are neither NaN nor to be interpolated
    OIIO::ROI roi = src.roi();
    const Rect window = rect_of(roi);
    const auto channels = size_t(src.nchannels());
    if (!check_size(roi, src.nchannels() + 1, OIIO::TypeFloat, error))
        return false;
    std::vector<float> values(window.area() * channels);
    if (!read_pixels(src, window, 0, src.nchannels(), OIIO::TypeFloat, values.data(), error))
        return false;
    const Channels roles = channels_of(src.spec(), src.nativespec());
    std::vector<float> guide(window.area());
    const HoledImage image{values.data(),      guide.data(),          nullptr,
                           window.width(),     window.height(),       int(channels),
                           roles.kinds.data(), thread_count(nthreads)};
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
    MeshReport report;
    if (!fill_missing(image, holes, options.mesh, options.device, options.progress, &report, error))
        return false;
    if (options.statistics)
        *options.statistics = report.statistics;
    return copy_whole(filled, src, type, error) && put_filled(src, values.data(), filled, error);
}

bool copy_filled(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, const Options& options,
                 Holes holes, int nthreads, std::string& error) {
    OIIO::ImageBuf filled;
    const OIIO::TypeDesc type = src.spec().format;
    if (!fill_image(src, options, holes, type, filled, nthreads, error))
        return false;
    const OIIO::ImageBuf& result = filled.initialized() ? filled : src;
    if (dst.storage() == OIIO::ImageBuf::APPBUFFER)
        return copy_into(dst, result, error);
    return copy_whole(dst, result, type, error);
}

bool fill(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, const Options& options, Missing missing) {
    return guarded_from(dst, src, [&](const auto& from, OIIO::ROI&, std::string& error) {
        if (!check_options_of(from, options, error))
            return false;
        if (missing > Missing::alpha) {
            error = "what is missing must be nan or alpha";
            return false;
        }
        const Holes holes = missing == Missing::alpha ? Holes::fill_alpha : Holes::fill;
        return copy_filled(dst, from, options, holes, 0, error);
    });
}

} // namespace ddt
