// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/windows.h"

#include <algorithm>
#include <cstdint>

namespace ddt {
namespace {

/// Cut begin .. end to the output pixels that the enlarged data window touches, on either side
/// where that ends within the display window.
void cut_to_data(int from0, int from_size, int window0, int window_size, int to0, int to_size,
                 int& begin, int& end) {
    const auto moved = [&](int from) { return int64_t(from - from0) * to_size; };
    if (window0 > from0)
        begin = int(std::max<int64_t>(begin, to0 + moved(window0) / from_size));
    if (window0 + window_size < from0 + from_size) {
        const int64_t last = moved(window0 + window_size);
        const int64_t up = last > 0 ? (last + from_size - 1) / from_size : last / from_size;
        end = int(std::min<int64_t>(end, to0 + up));
    }
}

} // namespace

OIIO::ROI cut_to_data(const OIIO::ImageSpec& src, const OIIO::ImageSpec& dst, OIIO::ROI roi) {
    if (dst.full_width >= src.full_width)
        cut_to_data(src.full_x, src.full_width, src.x, src.width, dst.full_x, dst.full_width,
                    roi.xbegin, roi.xend);
    if (dst.full_height >= src.full_height)
        cut_to_data(src.full_y, src.full_height, src.y, src.height, dst.full_y, dst.full_height,
                    roi.ybegin, roi.yend);
    roi.xend = std::max(roi.xbegin, roi.xend);
    roi.yend = std::max(roi.ybegin, roi.yend);
    return roi;
}

ResizeMapping::Axis x_axis(const OIIO::ImageSpec& src, const OIIO::ImageSpec& dst,
                           const OIIO::ROI& roi) {
    return {src.full_x, src.full_width,    dst.full_x, dst.full_width,
            src.x,      src.x + src.width, roi.xbegin, roi.xend};
}

ResizeMapping::Axis y_axis(const OIIO::ImageSpec& src, const OIIO::ImageSpec& dst,
                           const OIIO::ROI& roi) {
    return {src.full_y, src.full_height,    dst.full_y, dst.full_height,
            src.y,      src.y + src.height, roi.ybegin, roi.yend};
}

ResizeMapping mapping_of(const OIIO::ImageSpec& src, const OIIO::ImageSpec& dst,
                         const OIIO::ROI& roi) {
    return {x_axis(src, dst, roi), y_axis(src, dst, roi)};
}

} // namespace ddt
