// SPDX-License-Identifier: Apache-2.0
// The fixed grid of tiles an image is triangulated in.
//
// The grid is anchored at the window's origin and never changes with threads, the part of the
// output wanted or the device, so the result is a function of the image alone. Each tile is
// triangulated with a halo; 32 pixels is as far as a difference at its border was seen to travel in
// photographs (tests/bench/halo.cpp; docs/quality.md). Along straight hard edges of slopes 2:1, 3:1
// flips run on from the border, or from where the edge ends, a pixel an iteration, all through the
// tile: such an edge comes to the same state in every tile, at which the whole image's mesh may not
// have arrived.
#pragma once

#include "ddt/rect.h"

namespace ddt {

constexpr int tile_size = 256;
constexpr int tile_halo = 32;

/// Pixels of the largest tile along an axis of a window of so many; a lattice has at least 2.
constexpr int largest_tile(int pixels) {
    constexpr int most = tile_size + 1 + 2 * tile_halo;
    return pixels < 2 ? 2 : pixels < most ? pixels : most;
}

/// One tile: the cells (2x2 neighbouring pixels, named by their upper left pixel) whose positions
/// it serves, and the pixels it is triangulated from.
struct Tile {
    Rect cells;
    Rect pixels;         ///< the cells' pixels with the halo, within the window
    bool last_x, last_y; ///< serves the positions on the window's last column or row too
};

/// The tile with those of its cells alone.
Tile with_cells(const Tile& tile, const Rect& cells);

/// A window's tiles, or a block of them, numbered row by row.
class Grid {
public:
    explicit Grid(const Rect& window);
    int count() const { return int(m_block.area()); }
    int columns() const { return m_block.width(); }
    int rows() const { return m_block.height(); }
    Tile tile(int index) const;

    /// Those in columns x0 .. x1 - 1 and rows y0 .. y1 - 1 of them alone, or none.
    Grid block(const Rect& tiles) const;
    /// The part of the window that they lie in, without their halos.
    Rect pixels() const;

private:
    Rect m_window;
    Rect m_block; ///< in tiles of the window
};

} // namespace ddt
