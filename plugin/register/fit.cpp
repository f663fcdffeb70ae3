// SPDX-License-Identifier: Apache-2.0
#include "plugin/register/fit.h"

#include <algorithm>

#include <OpenImageIO/Imath.h>
#include <OpenImageIO/imagebufalgo_util.h>

#include "plugin/image/memory.h"
#include "plugin/image/reading.h"
#include "plugin/image/windows.h"
#include "plugin/imagebuf/by_oiio.h"
#include "plugin/imagebuf/guarded.h"
#include "plugin/imagebuf/holes.h"
#include "plugin/imagebuf/matrix.h"

namespace ddt {

namespace {

using namespace OIIO;

constexpr int prepare_flags =
    ImageBufAlgo::IBAprep_NO_SUPPORT_VOLUME | ImageBufAlgo::IBAprep_NO_COPY_ROI_FULL;

/// dst becomes an image like src of the given windows; false with one line in `error` if that is no
/// size, or there is no memory.
bool make(ImageBuf& dst, const ImageBuf& src, const ROI& window, std::string& error) {
    if (!check_size(window, src.nchannels(), src.spec().format, error))
        return false;
    ImageSpec spec = src.spec();
    spec.set_roi(window);
    spec.set_roi_full(window);
    return make_image(dst, spec, error);
}

/// The frame that the picture is fitted into, as ImageBufAlgo finds it: of a dst that is not
/// initialised, and becomes another image yet, what it would be is no image to make first.
bool find_frame(ImageBuf& dst, const ImageBuf& src, ROI& roi, std::string& error) {
    if (!dst.initialized()) {
        if (!roi.defined())
            roi = src.roi();
        return check_size(roi, src.nchannels(), src.spec().format, error);
    }
    if (ImageBufAlgo::IBAprep(roi, &dst, &src, prepare_flags))
        return true;
    error = dst.geterror();
    return false;
}

ROI window_of(const ROI& roi, int channels) {
    return ROI(roi.xbegin, roi.xend, roi.ybegin, roi.yend, 0, 1, 0, channels);
}

/// A number of pixels from a float, which may be anything.
int pixels(float size) {
    return size + 0.5f < float(1 << 30) ? int(size + 0.5f) : 1 << 30;
}

/// OpenImageIO's own, by its default filter.
bool fit_by_oiio(ImageBuf& dst, const ImageBuf& src, string_view fillmode, ROI roi, int nthreads,
                 std::string& error) {
    return while_reading(src, error, [&](const ImageBuf& from) {
#if OIIO_VERSION >= OIIO_MAKE_VERSION(3, 0, 0)
        const bool ok =
            ImageBufAlgo::fit(dst, from, {{"fillmode", fillmode}, {"exact", 1}}, roi, nthreads);
#else
        const bool ok = ImageBufAlgo::fit(dst, from, "", 0.0f, fillmode, true, roi, nthreads);
#endif
        if (!ok)
            error = dst.geterror();
        return ok;
    });
}

/// Resize to a whole number of pixels.
bool fit_whole(ImageBuf& dst, const ImageBuf& src, const Options& options, string_view fillmode,
               ROI roi, int nthreads, std::string& error) {
    const ImageSpec& from = src.spec();
    const ROI frame = window_of(roi, from.nchannels);
    const float aspect = float(from.full_width) / float(from.full_height);
    const bool to_height =
        fillmode == "height" ||
        (fillmode != "width" && float(frame.width()) / float(frame.height()) >= aspect);
    ROI window = frame;
    if (to_height)
        window.xend = frame.xbegin + pixels(float(frame.height()) * aspect);
    else
        window.yend = frame.ybegin + pixels(float(frame.width()) / aspect);

    const ROI full = src.roi_full();
    const bool same = window.width() == full.width() && window.height() == full.height() &&
                      window.xbegin == full.xbegin && window.ybegin == full.ybegin;
    if (!same && !make(dst, src, window, error))
        return false;
    // The frame is black, and shows no more of a source that is a part of its display window.
    ROI part = window;
    if (!same)
        part = cut_to_data(src.spec(), dst.spec(), window);
    const bool empty = part.width() <= 0 || part.height() <= 0;
    if (same) {
        if (!copy_filled(dst, src, options, options.holes, nthreads, error))
            return false;
    } else if (!empty && !resize(dst, src, options, part, nthreads)) {
        error = dst.geterror();
        return false;
    }
    // Centred by whole pixels, and without the frame's origin, as OpenImageIO has it.
    ImageSpec& spec = dst.specmod();
    set_roi_full(spec, frame);
    spec.x = (frame.width() - window.width()) / 2;
    spec.y = (frame.height() - window.height()) / 2;
    return true;
}

/// Warp, which keeps the shape and the centre exactly.
bool fit_exactly(ImageBuf& dst, const ImageBuf& src, const Options& options, string_view fillmode,
                 ROI roi, int nthreads, std::string& error) {
    const ImageSpec& from = src.spec();
    const float scale_x = float(roi.width()) / float(from.full_width);
    const float scale_y = float(roi.height()) / float(from.full_height);
    const float scale = fillmode == "width"    ? scale_x
                        : fillmode == "height" ? scale_y
                                               : std::min(scale_x, scale_y);
    // OpenImageIO's warp keeps its filter off what is beyond the edge here, and here alone.
    if (scale < float(1 - shrink_tolerance))
        return fit_by_oiio(dst, src, fillmode, roi, nthreads, error);
    // Centre goes to centre.
    const float shift_x =
        0.5f * (float(roi.xbegin + roi.xend) - scale * float(2 * from.full_x + from.full_width));
    const float shift_y =
        0.5f * (float(roi.ybegin + roi.yend) - scale * float(2 * from.full_y + from.full_height));
    const Imath::M33f M(scale, 0.0f, 0.0f, 0.0f, scale, 0.0f, shift_x, shift_y, 1.0f);

    if (!make(dst, src, window_of(roi, from.nchannels), error))
        return false;
    if (warp(dst, src, M, options, false, ImageBuf::WrapBlack, {}, nthreads))
        return true;
    error = dst.geterror();
    return false;
}

} // namespace

bool fit(ImageBuf& dst, const ImageBuf& src, const Options& options, string_view fillmode,
         bool exact, ROI roi, int nthreads) {
    return guarded_from(dst, src, [&](const auto& from, ROI&, std::string& error) {
        if (!check_options_of(from, options, error) || !find_frame(dst, from, roi, error))
            return false;
        return exact ? fit_exactly(dst, from, options, fillmode, roi, nthreads, error)
                     : fit_whole(dst, from, options, fillmode, roi, nthreads, error);
    });
}

} // namespace ddt
