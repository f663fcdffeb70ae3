// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/part/part_tiles.h"

#include "plugin/image/windows.h"
#include "plugin/tool/resize/tile_pixels.h"

namespace ddt::tool {

PartTiles::PartTiles(const Grid& grid, const OIIO::ImageSpec& from, const OIIO::ImageSpec& whole,
                     const Part& part)
    : m_grid(grid), m_x(x_axis(from, whole, whole.roi())), m_y(y_axis(from, whole, whole.roi())),
      m_tiles(tiles_of_part(grid.columns(), grid.rows(), part)), m_pixels(made_from(m_tiles)) {}

Rect PartTiles::source(int row) const {
    const Rect tiles = row_of(row);
    const Rect first = m_grid.tile(tiles.y0 * m_grid.columns() + tiles.x0).pixels;
    const Rect last = m_grid.tile(tiles.y0 * m_grid.columns() + tiles.x1 - 1).pixels;
    return {first.x0, first.y0, last.x1, last.y1};
}

Rect PartTiles::row_of(int row) const {
    return {m_tiles.x0, m_tiles.y0 + row, m_tiles.x1, m_tiles.y0 + row + 1};
}

Rect PartTiles::made_from(const Rect& tiles) const {
    return pixels_of_tiles(tiles, m_grid.columns(), m_grid.rows(), m_x, m_y);
}

} // namespace ddt::tool
