// SPDX-License-Identifier: Apache-2.0
// Shrinking along one axis, by the filter that OpenImageIO shrinks with.
#pragma once

#include <OpenImageIO/imagebuf.h>

namespace ddt {

/// The pixels and channels of `roi` from `src`, floats in local memory, whose lines along the other
/// axis are those of dst and are there for all of roi. What OpenImageIO's resize does by default,
/// up to rounding and but for its filter along the other axis, which changes nothing there and
/// takes it seven times as long. As there, the display window's outermost pixel goes on beyond the
/// pixels, black where that has none. A part is a crop of the whole.
void shrink_axis(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, bool along_x, const OIIO::ROI& roi,
                 int nthreads);

} // namespace ddt
