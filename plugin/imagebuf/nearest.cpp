// SPDX-License-Identifier: Apache-2.0
#include "plugin/imagebuf/nearest.h"

#include <cstring>
#include <vector>

#include "core/base/constants.h"
#include "plugin/image/channels.h"
#include "plugin/image/pixels.h"
#include "plugin/image/windows.h"

namespace ddt {
namespace {

bool is_id(const Channels& channels, int c) {
    return c < int(channels.kinds.size()) && channels.kinds[size_t(c)] == Channel::nearest;
}

int nearest_pixel(const ResizeMapping::Axis& axis, int i) {
    return int((axis.position(i) + position_one / 2) >> position_bits);
}

/// The channels from roi.chbegin to roi.chend.
bool copy_nearest(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, const OIIO::ROI& roi,
                  std::string& error) {
    const OIIO::TypeDesc type = copied_type(src, dst);
    const size_t pixel = type.size() * size_t(roi.nchannels());
    const Rect window = rect_of(src.roi());
    const ResizeMapping::Axis across = x_axis(src.spec(), dst.spec(), roi);
    const ResizeMapping::Axis down = y_axis(src.spec(), dst.spec(), roi);
    std::vector<char> from(pixel * size_t(window.width())), row(pixel * size_t(roi.width()));
    for (int y = roi.ybegin; y < roi.yend; ++y) {
        const int line = nearest_pixel(down, y);
        if (!read_pixels(src, {window.x0, line, window.x1, line + 1}, roi.chbegin, roi.chend, type,
                         from.data(), error))
            return false;
        for (int x = roi.xbegin; x < roi.xend; ++x)
            std::memcpy(&row[pixel * size_t(x - roi.xbegin)],
                        &from[pixel * size_t(nearest_pixel(across, x) - window.x0)], pixel);
        write_copied(dst, {roi.xbegin, y, roi.xend, y + 1}, roi.chbegin, roi.chend, type,
                     row.data());
    }
    return true;
}

} // namespace

bool all_are_ids(const OIIO::ImageBuf& src, const OIIO::ROI& roi) {
    const Channels channels = channels_of(src.spec(), src.nativespec());
    for (int c = roi.chbegin; c < roi.chend; ++c)
        if (!is_id(channels, c))
            return false;
    return true;
}

bool copy_nearest_ids(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, const OIIO::ROI& roi,
                      std::string& error) {
    const Channels channels = channels_of(src.spec(), src.nativespec());
    OIIO::ROI ids = roi;
    for (ids.chbegin = roi.chbegin; ids.chbegin < roi.chend; ids.chbegin = ids.chend + 1) {
        ids.chend = ids.chbegin;
        while (ids.chend < roi.chend && is_id(channels, ids.chend))
            ++ids.chend;
        if (ids.chend > ids.chbegin && !copy_nearest(dst, src, ids, error))
            return false;
    }
    return true;
}

} // namespace ddt
