// SPDX-License-Identifier: Apache-2.0
#include "fit.h"

#include <algorithm>

#include <OpenImageIO/Imath.h>
#include <OpenImageIO/imagebufalgo_util.h>

namespace ddt {

bool fit_exactly(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, const Options& options,
                 OIIO::string_view fillmode, OIIO::ROI roi, int nthreads) {
    using namespace OIIO;
    if (!ImageBufAlgo::IBAprep(roi, &dst, &src,
                               ImageBufAlgo::IBAprep_NO_SUPPORT_VOLUME |
                                   ImageBufAlgo::IBAprep_NO_COPY_ROI_FULL))
        return false;

    const ImageSpec& from = src.spec();
    const float scale_x = float(roi.width()) / float(from.full_width);
    const float scale_y = float(roi.height()) / float(from.full_height);
    const float scale = fillmode == "width"    ? scale_x
                        : fillmode == "height" ? scale_y
                                               : std::min(scale_x, scale_y);
    // Centre goes to centre.
    const float shift_x =
        0.5f * (float(roi.xbegin + roi.xend) - scale * float(2 * from.full_x + from.full_width));
    const float shift_y =
        0.5f * (float(roi.ybegin + roi.yend) - scale * float(2 * from.full_y + from.full_height));
    const Imath::M33f M(scale, 0.0f, 0.0f, 0.0f, scale, 0.0f, shift_x, shift_y, 1.0f);

    ImageSpec to = from;
    const ROI window(roi.xbegin, roi.xend, roi.ybegin, roi.yend, 0, 1, 0, from.nchannels);
    to.set_roi(window);
    to.set_roi_full(window);
    dst.reset(to);
    return warp(dst, src, M, options, false, ImageBuf::WrapBlack, {}, nthreads);
}

} // namespace ddt
