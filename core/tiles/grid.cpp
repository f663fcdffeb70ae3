// SPDX-License-Identifier: Apache-2.0
#include "core/tiles/grid.h"

#include <algorithm>

namespace ddt {

namespace {

/// A window one pixel wide or high still has one (degenerate) row of cells.
int cells_along(int pixels) {
    return std::max(1, pixels - 1);
}

int tiles_along(int pixels) {
    return (cells_along(pixels) - 1) / tile_size + 1;
}

void axis(int window0, int window1, int index, int& cell0, int& cell1, int& pixel0, int& pixel1,
          bool& last) {
    cell0 = window0 + index * tile_size;
    const int end = window0 + cells_along(window1 - window0);
    last = end - cell0 <= tile_size;
    cell1 = last ? end : cell0 + tile_size;
    pixel0 = cell0 - window0 > tile_halo ? cell0 - tile_halo : window0;
    pixel1 = window1 - cell1 > tile_halo + 1 ? cell1 + 1 + tile_halo : window1;
}

} // namespace

Tile with_cells(const Tile& tile, const Rect& cells) {
    return {cells, tile.pixels, tile.last_x && cells.x1 == tile.cells.x1,
            tile.last_y && cells.y1 == tile.cells.y1};
}

Grid::Grid(const Rect& window)
    : m_window(window), m_block{0, 0, tiles_along(window.width()), tiles_along(window.height())} {}

Tile Grid::tile(int index) const {
    Tile t;
    axis(m_window.x0, m_window.x1, m_block.x0 + index % columns(), t.cells.x0, t.cells.x1,
         t.pixels.x0, t.pixels.x1, t.last_x);
    axis(m_window.y0, m_window.y1, m_block.y0 + index / columns(), t.cells.y0, t.cells.y1,
         t.pixels.y0, t.pixels.y1, t.last_y);
    return t;
}

Grid Grid::block(const Rect& tiles) const {
    Grid part = *this;
    part.m_block = {m_block.x0 + tiles.x0, m_block.y0 + tiles.y0, m_block.x0 + tiles.x1,
                    m_block.y0 + tiles.y1};
    return part;
}

Rect Grid::pixels() const {
    if (m_block.empty())
        return {};
    const Rect first = tile(0).cells, last = tile(count() - 1).cells;
    // A pixel on the border of two tiles is a corner of both's cells.
    return {first.x0, first.y0, std::min(last.x1 + 1, m_window.x1),
            std::min(last.y1 + 1, m_window.y1)};
}

} // namespace ddt
