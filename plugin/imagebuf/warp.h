// SPDX-License-Identifier: Apache-2.0
// warp() with what only OpenImageIO 3 has.
#pragma once

#include "ddt/resize.h"

namespace ddt {

/// As in ddt/resize.h. `edgeclamp` is OpenImageIO's parameter of that name, for what is left to it:
/// its filter does not reach beyond the source's edge. Before 3.0 it has no such parameter.
bool warp(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, OIIO::M33fParam M, const Options& options,
          bool recompute_roi, OIIO::ImageBuf::WrapMode wrap, bool edgeclamp, OIIO::ROI roi,
          int nthreads);

} // namespace ddt
