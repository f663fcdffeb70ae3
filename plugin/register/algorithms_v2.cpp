// SPDX-License-Identifier: Apache-2.0
// ImageBufAlgo's choke points in OIIO 2.4 and 2.5. The forms that return an ImageBuf, and those
// without the later parameters, call these within OIIO through its own table of functions.
#include "filter.h"
#include "fit.h"
#include "hooks.h"

namespace ddt {
namespace {

using namespace OIIO;

bool resize_by_filter(ImageBuf& dst, const ImageBuf& src, Filter2D* filter, ROI roi, int nthreads) {
    const Filter* ours = as_ours(filter);
    return ours ? resize(dst, src, ours->options(), roi, nthreads)
                : ImageBufAlgo::resize(dst, src, filter, roi, nthreads);
}

bool resize_by_name(ImageBuf& dst, const ImageBuf& src, string_view name, float width, ROI roi,
                    int nthreads) {
    if (!is_filter_name(name))
        return ImageBufAlgo::resize(dst, src, name, width, roi, nthreads);
    return without_throwing(dst, [&] {
        Options options;
        return parse_filter_for(dst, name, options) && resize(dst, src, options, roi, nthreads);
    });
}

bool fit_by_filter(ImageBuf& dst, const ImageBuf& src, Filter2D* filter, string_view fillmode,
                   bool exact, ROI roi, int nthreads) {
    const Filter* ours = as_ours(filter);
    if (!ours || !exact) // then by way of ImageBufAlgo::resize
        return ImageBufAlgo::fit(dst, src, filter, fillmode, exact, roi, nthreads);
    return without_throwing(
        dst, [&] { return fit_exactly(dst, src, ours->options(), fillmode, roi, nthreads); });
}

bool fit_by_name(ImageBuf& dst, const ImageBuf& src, string_view name, float width,
                 string_view fillmode, bool exact, ROI roi, int nthreads) {
    if (!is_filter_name(name))
        return ImageBufAlgo::fit(dst, src, name, width, fillmode, exact, roi, nthreads);
    return without_throwing(dst, [&] {
        Options options;
        if (!parse_filter_for(dst, name, options))
            return false;
        Filter filter(name, options, width, width);
        return fit_by_filter(dst, src, &filter, fillmode, exact, roi, nthreads);
    });
}

bool warp_by_filter(ImageBuf& dst, const ImageBuf& src, M33fParam M, const Filter2D* filter,
                    bool recompute_roi, ImageBuf::WrapMode wrap, ROI roi, int nthreads) {
    const Filter* ours = as_ours(filter);
    return ours ? warp(dst, src, M, ours->options(), recompute_roi, wrap, roi, nthreads)
                : ImageBufAlgo::warp(dst, src, M, filter, recompute_roi, wrap, roi, nthreads);
}

bool warp_by_name(ImageBuf& dst, const ImageBuf& src, M33fParam M, string_view name, float width,
                  bool recompute_roi, ImageBuf::WrapMode wrap, ROI roi, int nthreads) {
    if (!is_filter_name(name))
        return ImageBufAlgo::warp(dst, src, M, name, width, recompute_roi, wrap, roi, nthreads);
    return without_throwing(dst, [&] {
        Options options;
        return parse_filter_for(dst, name, options) &&
               warp(dst, src, M, options, recompute_roi, wrap, roi, nthreads);
    });
}

} // namespace

void add_algorithms(Redirects& list) {
    // rotate needs no stand-in: it calls warp.
    add(list, "ImageBufAlgo::resize", &ImageBufAlgo::resize, &resize_by_filter);
    add(list, "ImageBufAlgo::resize", &ImageBufAlgo::resize, &resize_by_name);
    add(list, "ImageBufAlgo::fit", &ImageBufAlgo::fit, &fit_by_filter);
    add(list, "ImageBufAlgo::fit", &ImageBufAlgo::fit, &fit_by_name);
    add(list, "ImageBufAlgo::warp", &ImageBufAlgo::warp, &warp_by_filter);
    add(list, "ImageBufAlgo::warp", &ImageBufAlgo::warp, &warp_by_name);
}

} // namespace ddt
