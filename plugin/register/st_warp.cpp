// SPDX-License-Identifier: Apache-2.0
// ImageBufAlgo::st_warp weighs pixels by a filter of its own place for each pixel, which a mesh has
// no meaning for: our filters are refused there, with a line, and not evaluated.
#include "plugin/message/format.h"
#include "plugin/register/filter.h"
#include "plugin/register/hooks.h"
#include "plugin/register/returning.h"

namespace ddt {
namespace {

using namespace OIIO;

bool refuse(ImageBuf& dst) {
    return without_throwing(dst, [&] {
        set_error(dst, "ddt: st_warp cannot use the filters of ddt; allowed are OpenImageIO's own");
        return false;
    });
}

bool by_filter(ImageBuf& dst, const ImageBuf& src, const ImageBuf& st, const Filter2D* filter,
               int chan_s, int chan_t, bool flip_s, bool flip_t, ROI roi, int nthreads) {
    return as_ours(filter) ? refuse(dst)
                           : ImageBufAlgo::st_warp(dst, src, st, filter, chan_s, chan_t, flip_s,
                                                   flip_t, roi, nthreads);
}

bool by_name(ImageBuf& dst, const ImageBuf& src, const ImageBuf& st, string_view name, float width,
             int chan_s, int chan_t, bool flip_s, bool flip_t, ROI roi, int nthreads) {
    return is_filter_name(name) ? refuse(dst)
                                : ImageBufAlgo::st_warp(dst, src, st, name, width, chan_s, chan_t,
                                                        flip_s, flip_t, roi, nthreads);
}

} // namespace

void add_st_warp(Redirects& list) {
    add_both<&by_filter>(list, "ImageBufAlgo::st_warp", &ImageBufAlgo::st_warp,
                         &ImageBufAlgo::st_warp);
    add_both<&by_name>(list, "ImageBufAlgo::st_warp", &ImageBufAlgo::st_warp,
                       &ImageBufAlgo::st_warp);
}

} // namespace ddt
