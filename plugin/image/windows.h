// SPDX-License-Identifier: Apache-2.0
// Windows of pixels, and how a source's are mapped onto a destination's.
#pragma once

#include <OpenImageIO/imageio.h>

#include "ddt/core.h"

namespace ddt {

/// The pixels of a roi.
inline Rect rect_of(const OIIO::ROI& roi) {
    return {roi.xbegin, roi.ybegin, roi.xend, roi.yend};
}

/// `roi`, of dst's pixels, without those that src's enlarged data window does not touch: where it
/// ends within the display window, along axes that do not shrink. May be empty.
OIIO::ROI cut_to_data(const OIIO::ImageSpec& src, const OIIO::ImageSpec& dst, OIIO::ROI roi);

/// src's display window mapped onto dst's, `roi` of dst's pixels wanted.
ResizeMapping::Axis x_axis(const OIIO::ImageSpec& src, const OIIO::ImageSpec& dst,
                           const OIIO::ROI& roi);
ResizeMapping::Axis y_axis(const OIIO::ImageSpec& src, const OIIO::ImageSpec& dst,
                           const OIIO::ROI& roi);
/// Along both axes.
ResizeMapping mapping_of(const OIIO::ImageSpec& src, const OIIO::ImageSpec& dst,
                         const OIIO::ROI& roi);

} // namespace ddt
