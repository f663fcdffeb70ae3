// SPDX-License-Identifier: Apache-2.0
#include "plugin/imagebuf/copy.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include "plugin/image/memory.h"
#include "plugin/image/pixels.h"
#include "plugin/image/windows.h"

namespace ddt {

bool copy_moved(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, const OIIO::ROI& roi, int dx,
                int dy, Beyond beyond, std::string& error) {
    const OIIO::TypeDesc type = copied_type(src, dst);
    const size_t pixel = type.size() * size_t(roi.nchannels());
    const Rect window = rect_of(src.roi());
    // Output columns before, within and after the source's.
    const int begin = std::clamp(window.x0 + dx, roi.xbegin, roi.xend);
    const int end = std::clamp(window.x1 + dx, begin, roi.xend);
    const int width = window.width();
    std::vector<char> row(pixel * size_t(roi.width())), edge(pixel);

    for (int y = roi.ybegin; y < roi.yend; ++y) {
        const int sy = std::clamp(y - dy, window.y0, window.y1 - 1);
        const auto fill = [&](int from, int to, int column) {
            if (from >= to)
                return true;
            std::fill(edge.begin(), edge.end(), char(0));
            if (beyond == Beyond::edge &&
                !read_pixels(src, {column, sy, column + 1, sy + 1}, roi.chbegin, roi.chend, type,
                             edge.data(), error))
                return false;
            for (int x = from; x < to; ++x)
                std::memcpy(&row[pixel * size_t(x - roi.xbegin)], edge.data(), pixel);
            return true;
        };
        const bool black = beyond == Beyond::black && sy != y - dy;
        if (!fill(roi.xbegin, black ? roi.xend : begin, window.x0))
            return false;
        if (!black) {
            if (begin < end &&
                !read_pixels(src, {begin - dx, sy, end - dx, sy + 1}, roi.chbegin, roi.chend, type,
                             &row[pixel * size_t(begin - roi.xbegin)], error))
                return false;
            if (!fill(end, roi.xend, window.x0 + width - 1))
                return false;
        }
        write_copied(dst, {roi.xbegin, y, roi.xend, y + 1}, roi.chbegin, roi.chend, type,
                     row.data());
    }
    return true;
}

bool copy_whole(OIIO::ImageBuf& copy, const OIIO::ImageBuf& src, OIIO::TypeDesc type,
                std::string& error) {
    // By OpenImageIO, which keeps what types a file's channels have, where it can: a caller's
    // memory with room between pixels it takes for one without (2.4).
    if (type == src.spec().format && src.storage() != OIIO::ImageBuf::APPBUFFER) {
        if (copy.copy(src))
            return true;
        error = copy.geterror();
        return false;
    }
    OIIO::ImageSpec spec = src.spec();
    spec.set_format(type);
    return take_memory(copy, spec, error) &&
           copy_moved(copy, src, src.roi(), 0, 0, Beyond::edge, error);
}

} // namespace ddt
