// SPDX-License-Identifier: Apache-2.0
// ImageBufAlgo's resize, fit and warp in OIIO 2.4 and 2.5, by every entry point: a library linked
// with -Bsymbolic-functions calls its own functions past our redirection.
#include "plugin/register/filter.h"
#include "plugin/register/fit.h"
#include "plugin/register/hooks.h"
#include "plugin/register/returning.h"

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
    if (!ours)
        return ImageBufAlgo::fit(dst, src, filter, fillmode, exact, roi, nthreads);
    return without_throwing(
        dst, [&] { return fit(dst, src, ours->options(), fillmode, exact, roi, nthreads); });
}

bool fit_by_name(ImageBuf& dst, const ImageBuf& src, string_view name, float width,
                 string_view fillmode, bool exact, ROI roi, int nthreads) {
    if (!is_filter_name(name))
        return ImageBufAlgo::fit(dst, src, name, width, fillmode, exact, roi, nthreads);
    return without_throwing(dst, [&] {
        Options options;
        return parse_filter_for(dst, name, options) &&
               fit(dst, src, options, fillmode, exact, roi, nthreads);
    });
}

// The forms that were deprecated in 2.3, without fillmode.
bool old_fit_by_filter(ImageBuf& dst, const ImageBuf& src, Filter2D* filter, bool exact, ROI roi,
                       int nthreads) {
    return fit_by_filter(dst, src, filter, "letterbox", exact, roi, nthreads);
}

bool old_fit_by_name(ImageBuf& dst, const ImageBuf& src, string_view name, float width, bool exact,
                     ROI roi, int nthreads) {
    return fit_by_name(dst, src, name, width, "letterbox", exact, roi, nthreads);
}

} // namespace

void add_algorithms(Redirects& list) {
    constexpr const char *resizing = "ImageBufAlgo::resize", *fitting = "ImageBufAlgo::fit";
    add_both<&resize_by_filter>(list, resizing, &ImageBufAlgo::resize, &ImageBufAlgo::resize);
    add_both<&resize_by_name>(list, resizing, &ImageBufAlgo::resize, &ImageBufAlgo::resize);
    add_both<&fit_by_filter>(list, fitting, &ImageBufAlgo::fit, &ImageBufAlgo::fit);
    add_both<&fit_by_name>(list, fitting, &ImageBufAlgo::fit, &ImageBufAlgo::fit);
    add_both<&old_fit_by_filter>(list, fitting, &ImageBufAlgo::fit, &ImageBufAlgo::fit);
    add_both<&old_fit_by_name>(list, fitting, &ImageBufAlgo::fit, &ImageBufAlgo::fit);
    add_warp(list);
    add_rotate(list);
    add_st_warp(list);
}

} // namespace ddt
