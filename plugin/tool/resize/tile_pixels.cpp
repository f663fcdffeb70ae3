// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/resize/tile_pixels.h"

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

Rect pixels_of_tiles(const Rect& tiles, int columns, int rows, const ResizeMapping::Axis& x,
                     const ResizeMapping::Axis& y) {
    return {first_of(tiles.x0, columns, x), first_of(tiles.y0, rows, y),
            first_of(tiles.x1, columns, x), first_of(tiles.y1, rows, y)};
}

} // namespace ddt::tool
