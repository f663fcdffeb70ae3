// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <OpenImageIO/imagebufalgo_util.h>
#include <OpenImageIO/strutil.h>

#include "ddt/resize.h"
#include "plugin/image/memory.h"
#include "plugin/image/prepare.h"
#include "plugin/image/reading.h"
#include "plugin/image/windows.h"
#include "plugin/imagebuf/by_oiio.h"
#include "plugin/imagebuf/copy.h"
#include "plugin/imagebuf/guarded.h"
#include "plugin/imagebuf/holes.h"
#include "plugin/imagebuf/matrix.h"
#include "plugin/imagebuf/resample.h"
#include "plugin/imagebuf/warp.h"

namespace ddt {
namespace {

Projective matrix_of(OIIO::M33fParam M) {
    Projective p;
    for (int i = 0; i < 9; ++i)
        p.m[i] = M.data()[i];
    return p;
}

/// The pixels whose centres the image of `roi` touches, as ImageBufAlgo::warp finds them: in
/// float32. False if that is no size at all.
bool image_of(const float* m, OIIO::ROI& roi, std::string& error) {
    float min_x = 0, max_x = 0, min_y = 0, max_y = 0;
    bool first = true;
    for (const int corner : {0, 1, 2, 3}) {
        const float x = corner & 1 ? float(roi.xend) - 0.5f : float(roi.xbegin) + 0.5f;
        const float y = corner & 2 ? float(roi.yend) - 0.5f : float(roi.ybegin) + 0.5f;
        const float w = x * m[2] + y * m[5] + m[8];
        const float px = (x * m[0] + y * m[3] + m[6]) / w, py = (x * m[1] + y * m[4] + m[7]) / w;
        // Written so that a NaN anywhere stays and is found below.
        min_x = first || !(px >= min_x) ? px : min_x;
        max_x = first || !(px <= max_x) ? px : max_x;
        min_y = first || !(py >= min_y) ? py : min_y;
        max_y = first || !(py <= max_y) ? py : max_y;
        first = false;
    }
    constexpr float limit = largest_coordinate;
    if (!(min_x > -limit && max_x < limit && min_y > -limit && max_y < limit)) {
        error = "the matrix maps the image's corners beyond any size; coordinates are allowed "
                "within +-" +
                std::to_string(largest_coordinate);
        return false;
    }
    roi.xbegin = int(std::floor(min_x));
    roi.xend = int(std::floor(max_x)) + 1;
    roi.ybegin = int(std::floor(min_y));
    roi.yend = int(std::floor(max_y)) + 1;
    return true;
}

/// What ImageBufAlgo::warp is asked for, beside the images and the roi.
struct WarpCall {
    OIIO::M33fParam M;
    bool recompute_roi;
    OIIO::ImageBuf::WrapMode wrap;
    bool edgeclamp;
    int nthreads;
};

/// OpenImageIO's own, by its default filter.
bool warp_by_oiio(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, const WarpCall& call,
                  const OIIO::ROI& roi, std::string& error) {
    const Projective scaled = matrix_of(call.M).scaled_up();
    float matrix[3][3];
    for (int i = 0; i < 9; ++i)
        matrix[i / 3][i % 3] = float(scaled.m[size_t(i)]);
    return while_reading(src, error, [&](const OIIO::ImageBuf& from) {
#if OIIO_VERSION >= OIIO_MAKE_VERSION(3, 0, 0)
        const bool ok = OIIO::ImageBufAlgo::warp(dst, from, matrix,
                                                 {{"recompute_roi", int(call.recompute_roi)},
                                                  {"wrap", int(call.wrap)},
                                                  {"edgeclamp", int(call.edgeclamp)}},
                                                 roi, call.nthreads);
#else
        const bool ok = OIIO::ImageBufAlgo::warp(dst, from, matrix, "", 0.0f, call.recompute_roi,
                                                 call.wrap, roi, call.nthreads);
#endif
        if (!ok)
            error = dst.has_error() ? dst.geterror() : "OpenImageIO's warp failed";
        return ok;
    });
}

/// The same into a dst of any type.
bool warp_by_oiio_into_any(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, const WarpCall& call,
                           const OIIO::ROI& roi, std::string& error) {
    if (is_written_by_oiio(dst.spec().format))
        return warp_by_oiio(dst, src, call, roi, error);
    OIIO::ImageSpec spec = dst.spec();
    spec.set_format(OIIO::TypeFloat);
    OIIO::set_roi(spec, roi);
    spec.nchannels = dst.nchannels();
    OIIO::ImageBuf floats;
    return make_image(floats, spec, error) && warp_by_oiio(floats, src, call, roi, error) &&
           copy_moved(dst, floats, roi, 0, 0, Beyond::edge, error);
}

/// OpenImageIO's filter goes through all that a pixel sees, beyond the picture too: near a horizon
/// that has no end. What is less than this for a whole picture takes minutes. It inverts the matrix
/// in float32, and where that is nearly singular sees another picture than the inverse's.
bool has_an_end(const Projective& to_output, const OIIO::ROI& roi, std::string& error) {
    constexpr double filter_width = 6; // of lanczos3
    const Projective to_source = to_output.float_inverse();
    const double allowed = std::ldexp(1.0, 36) + std::ldexp(double(roi.npixels()), 12);
    if (filtered_pixels(to_source, rect_of(roi), filter_width) <= allowed)
        return true;
    error =
        "the matrix makes the picture so small that filtering it would not end; shrink it less, "
        "or warp a part of it without its horizon";
    return false;
}

bool warp_checked(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, const Options& options,
                  const WarpCall& call, OIIO::ROI roi, OIIO::ROI& touched, std::string& error) {
    const OIIO::ImageBuf::WrapMode wrap = call.wrap;
    if (!check_options_of(src, options, error))
        return false;
    if (wrap < OIIO::ImageBuf::WrapDefault || wrap > OIIO::ImageBuf::WrapMirror) {
        // OpenImageIO ends the process.
        error =
            format("wrap mode {} is not allowed; allowed are default, black, clamp, periodic and "
                   "mirror",
                   int(wrap));
        return false;
    }
    const Projective to_output = matrix_of(call.M);
    Projective to_source;
    if (!to_output.invert(to_source)) {
        error = "the matrix has no inverse; give one that maps the plane onto the plane";
        return false;
    }
    if (!dst.initialized() && !roi.defined()) {
        roi = src.roi();
        if (call.recompute_roi && !image_of(call.M.data(), roi, error))
            return false;
    }
    if (!prepare(dst, src, roi, OIIO::ImageBufAlgo::IBAprep_NO_SUPPORT_VOLUME, error))
        return false;
    if (roi.width() <= 0)
        return true;
    touched = roi;

    int dx = 0, dy = 0;
    const bool black = wrap == OIIO::ImageBuf::WrapDefault || wrap == OIIO::ImageBuf::WrapBlack;
    const bool moved = black && moves_only(to_output, dx, dy);
    if (moved || !black || shrinks(to_output, rect_of(src.roi()))) {
        OIIO::ImageBuf filled;
        if (!fill_image(src, options, options.holes, type_between(src), filled, call.nthreads,
                        error))
            return false;
        const OIIO::ImageBuf& from = filled.initialized() ? filled : src;
        if (moved)
            return copy_moved(dst, from, roi, dx, dy, Beyond::black, error);
        if (!has_an_end(to_output, roi, error))
            return false;
        return warp_by_oiio_into_any(dst, from, call, roi, error);
    }
    if (!OIIO::ImageBufAlgo::zero(dst, roi, call.nthreads)) {
        error = dst.geterror();
        return false;
    }
    const MatrixMapping mapping(to_source, to_output, rect_of(src.roi()), rect_of(src.roi_full()),
                                rect_of(roi));
    return resample(dst, src, mapping, roi, options, call.nthreads, error);
}

} // namespace

bool warp(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, OIIO::M33fParam M, const Options& options,
          bool recompute_roi, OIIO::ImageBuf::WrapMode wrap, OIIO::ROI roi, int nthreads) {
    return warp(dst, src, M, options, recompute_roi, wrap, false, roi, nthreads);
}

bool warp(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, OIIO::M33fParam M, const Options& options,
          bool recompute_roi, OIIO::ImageBuf::WrapMode wrap, bool edgeclamp, OIIO::ROI roi,
          int nthreads) {
    return guarded_from(dst, src, [&](const auto& from, OIIO::ROI& touched, std::string& error) {
        return warp_checked(dst, from, options, {M, recompute_roi, wrap, edgeclamp, nthreads}, roi,
                            touched, error);
    });
}

} // namespace ddt
