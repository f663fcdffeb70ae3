// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/part.h"

#include <algorithm>

#include "core/base/parse_number.h"
#include "core/tiles/grid.h"

namespace ddt::tool {

namespace {

/// The first output pixel that a row or column of tiles serves.
int first_of(int tile, int tiles, const ResizeMapping::Axis& axis) {
    return tile <= 0       ? axis.out0
           : tile >= tiles ? axis.out1
                           : axis.first_at_or_after(axis.window0 + tile * tile_size);
}

} // namespace

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

Rect pixels_of_tiles(const Rect& tiles, int columns, int rows, const ResizeMapping::Axis& x,
                     const ResizeMapping::Axis& y) {
    return {first_of(tiles.x0, columns, x), first_of(tiles.y0, rows, y),
            first_of(tiles.x1, columns, x), first_of(tiles.y1, rows, y)};
}

} // namespace ddt::tool
