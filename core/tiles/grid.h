// SPDX-License-Identifier: Apache-2.0
// The fixed grid of tiles an image is triangulated in.
//
// The grid is anchored at the window's origin and never changes with threads, the part of the
// output wanted or the device, so the result is a function of the image alone. Each tile is
// triangulated with a halo; 32 pixels is as far as a difference at its border was ever seen to
// travel (tests/bench/halo.cpp; docs/quality.md).
#pragma once

#include "ddt/core.h"

namespace ddt {

constexpr int tile_size = 256;
constexpr int tile_halo = 32;

/// One tile: the cells (2x2 neighbouring pixels, named by their upper left pixel) whose positions
/// it serves, and the pixels it is triangulated from.
struct Tile {
    Rect cells;
    Rect pixels;         ///< the cells' pixels with the halo, within the window
    bool last_x, last_y; ///< serves the positions on the window's last column or row too
};

/// The tile with those of its cells alone.
Tile with_cells(const Tile& tile, const Rect& cells);

class Grid {
public:
    explicit Grid(const Rect& window);
    int count() const { return m_columns * m_rows; }
    int columns() const { return m_columns; }
    int rows() const { return m_rows; }
    Tile tile(int index) const;

private:
    Rect m_window;
    int m_columns, m_rows;
};

} // namespace ddt
