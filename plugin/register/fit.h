// SPDX-License-Identifier: Apache-2.0
// The part of ImageBufAlgo::fit that resamples by a fraction of a pixel.
#pragma once

#include "ddt/resize.h"

namespace ddt {

/// ImageBufAlgo::fit with exact=true: scale src's display window by one factor to fill roi as
/// `fillmode` says ("width", "height", otherwise "letterbox"), centred, black around it. dst gets
/// roi (default: its own windows) as both windows. OIIO calls no function that could be redirected
/// between fit and the evaluation of the filter, hence this one.
bool fit_exactly(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, const Options& options,
                 OIIO::string_view fillmode, OIIO::ROI roi, int nthreads);

} // namespace ddt
