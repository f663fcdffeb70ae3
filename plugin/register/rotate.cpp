// SPDX-License-Identifier: Apache-2.0
// ImageBufAlgo::rotate. In a library whose own calls are redirected it would be enough to redirect
// warp, which it calls; one linked with -Bsymbolic-functions calls its own.
#include <OpenImageIO/Imath.h>

#include "plugin/register/filter.h"
#include "plugin/register/hooks.h"
#include "plugin/register/returning.h"

namespace ddt {
namespace {

using namespace OIIO;

/// The matrix is computed as OpenImageIO computes it, to the bit.
bool rotate_ours(ImageBuf& dst, const ImageBuf& src, float angle, float x, float y,
                 const Options& options, bool recompute_roi, ROI roi, int nthreads) {
    Imath::M33f M;
    M.translate(Imath::V2f(-x, -y));
    M.rotate(angle);
    M *= Imath::M33f().translate(Imath::V2f(x, y));
    return warp(dst, src, M, options, recompute_roi, ImageBuf::WrapBlack, roi, nthreads);
}

float centre_x(const ImageBuf& src) {
    const ROI full = src.roi_full();
    return 0.5f * float(full.xbegin + full.xend);
}

float centre_y(const ImageBuf& src) {
    const ROI full = src.roi_full();
    return 0.5f * float(full.ybegin + full.yend);
}

bool about_by_filter(ImageBuf& dst, const ImageBuf& src, float angle, float x, float y,
                     Filter2D* filter, bool recompute_roi, ROI roi, int nthreads) {
    const Filter* ours = as_ours(filter);
    return ours ? rotate_ours(dst, src, angle, x, y, ours->options(), recompute_roi, roi, nthreads)
                : ImageBufAlgo::rotate(dst, src, angle, x, y, filter, recompute_roi, roi, nthreads);
}

bool about_by_name(ImageBuf& dst, const ImageBuf& src, float angle, float x, float y,
                   string_view name, float width, bool recompute_roi, ROI roi, int nthreads) {
    if (!is_filter_name(name))
        return ImageBufAlgo::rotate(dst, src, angle, x, y, name, width, recompute_roi, roi,
                                    nthreads);
    return without_throwing(dst, [&] {
        Options options;
        return parse_filter_for(dst, name, options) &&
               rotate_ours(dst, src, angle, x, y, options, recompute_roi, roi, nthreads);
    });
}

bool by_filter(ImageBuf& dst, const ImageBuf& src, float angle, Filter2D* filter,
               bool recompute_roi, ROI roi, int nthreads) {
    return about_by_filter(dst, src, angle, centre_x(src), centre_y(src), filter, recompute_roi,
                           roi, nthreads);
}

bool by_name(ImageBuf& dst, const ImageBuf& src, float angle, string_view name, float width,
             bool recompute_roi, ROI roi, int nthreads) {
    return about_by_name(dst, src, angle, centre_x(src), centre_y(src), name, width, recompute_roi,
                         roi, nthreads);
}

} // namespace

void add_rotate(Redirects& list) {
    add_both<&about_by_filter>(list, "ImageBufAlgo::rotate", &ImageBufAlgo::rotate,
                               &ImageBufAlgo::rotate);
    add_both<&about_by_name>(list, "ImageBufAlgo::rotate", &ImageBufAlgo::rotate,
                             &ImageBufAlgo::rotate);
    add_both<&by_filter>(list, "ImageBufAlgo::rotate", &ImageBufAlgo::rotate,
                         &ImageBufAlgo::rotate);
    add_both<&by_name>(list, "ImageBufAlgo::rotate", &ImageBufAlgo::rotate, &ImageBufAlgo::rotate);
}

} // namespace ddt
