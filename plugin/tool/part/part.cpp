// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/part/part.h"

#include <algorithm>

#include "core/base/parse_number.h"

namespace ddt::tool {

bool parse_part(const std::string& text, Part& part) {
    const size_t slash = text.find('/');
    Part read;
    if (slash == std::string::npos ||
        !parse_number(text.substr(0, slash), 1, most_parts, read.index) ||
        !parse_number(text.substr(slash + 1), 1, most_parts, read.count) || read.index > read.count)
        return false;
    part = read;
    return true;
}

Rect tiles_of_part(int columns, int rows, Part part) {
    Rect tiles{0, 0, columns, rows};
    // Halve, and give each half parts in proportion: never more than it has tiles.
    while (part.count > 1) {
        const bool by_rows =
            part.count <= tiles.height() || (tiles.width() == 1) || tiles.height() > tiles.width();
        const int length = by_rows ? tiles.height() : tiles.width();
        const int across = by_rows ? tiles.width() : tiles.height();
        const int half = length / 2;
        const auto share = int((int64_t(part.count) * half + length / 2) / length);
        const int64_t least = part.count - int64_t(length - half) * across;
        const int first =
            std::clamp(share, int(std::max<int64_t>(least, 1)),
                       int(std::min<int64_t>(int64_t(half) * across, part.count - 1)));
        const bool in_first = part.index <= first;
        (by_rows ? (in_first ? tiles.y1 : tiles.y0) : (in_first ? tiles.x1 : tiles.x0)) =
            (by_rows ? tiles.y0 : tiles.x0) + half;
        part = in_first ? Part{part.index, first} : Part{part.index - first, part.count - first};
    }
    return tiles;
}

} // namespace ddt::tool
