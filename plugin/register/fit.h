// SPDX-License-Identifier: Apache-2.0
// ImageBufAlgo::fit by one of our filters.
#pragma once

#include "ddt/resize.h"

namespace ddt {

/// Scale src's display window by one factor to fill roi (default: dst's windows, or src's) as
/// `fillmode` says ("width", "height", otherwise "letterbox"). Exact: centred, black around it, and
/// dst gets roi as both windows; where that shrinks, OpenImageIO's own fit. Otherwise to whole
/// pixels, and dst gets roi as its display window. OpenImageIO's fit calls functions of its own
/// that cannot be redirected everywhere, hence this one. False with one line in dst's error.
bool fit(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, const Options& options,
         OIIO::string_view fillmode, bool exact, OIIO::ROI roi, int nthreads);

} // namespace ddt
