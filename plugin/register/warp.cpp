// SPDX-License-Identifier: Apache-2.0
// ImageBufAlgo::warp by a filter or its name: all there is in OIIO 2, deprecated in 3.
#include "plugin/register/filter.h"
#include "plugin/register/hooks.h"
#include "plugin/register/returning.h"

#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

namespace ddt {
namespace {

using namespace OIIO;

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

void add_warp(Redirects& list) {
    constexpr const char* label = "ImageBufAlgo::warp";
    add_both<&warp_by_filter>(list, label, &ImageBufAlgo::warp, &ImageBufAlgo::warp);
    add_both<&warp_by_name>(list, label, &ImageBufAlgo::warp, &ImageBufAlgo::warp);
}

} // namespace ddt
