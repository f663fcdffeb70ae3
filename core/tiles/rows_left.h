// SPDX-License-Identifier: Apache-2.0
// Which output rows of a tile are left to write, for those who share them.
#pragma once

#include <algorithm>
#include <mutex>

#include "core/tiles/tile_mesh.h"
#include "ddt/mapping.h"

namespace ddt {

/// The rows of a tile, or of part of it, that somebody writes from the top downwards while others
/// may take half of what is left. Thread-safe.
class RowsLeft {
public:
    /// These pixels are to be written. `grid`: TileWriter::is_grid(); `least`: rows, at least 1,
    /// that are worth being given to somebody; 0: none are given.
    void begin(const MeshedTile& of, const Rect& pixels, bool grid, int least) {
        const std::lock_guard<std::mutex> lock(m_mutex);
        m_of = &of;
        m_pixels = pixels;
        m_grid = grid;
        m_least = least;
    }

    /// The next of them, so many rows or what is left; empty: there are none.
    Rect take(int rows) {
        const std::lock_guard<std::mutex> lock(m_mutex);
        Rect taken = m_pixels;
        taken.y1 = std::min(taken.y0 + rows, taken.y1);
        m_pixels.y0 = taken.y1;
        return taken;
    }

    /// How many of them are left, if they are enough for give(); else 0.
    int to_share() const {
        const std::lock_guard<std::mutex> lock(m_mutex);
        return can_give() ? m_pixels.height() : 0;
    }

    /// Let the lower half go to `to`, if either gets enough.
    bool give(RowsLeft& to) {
        const std::scoped_lock lock(m_mutex, to.m_mutex);
        if (!can_give())
            return false;
        to.m_of = m_of;
        to.m_grid = m_grid;
        to.m_least = m_least;
        to.m_pixels = m_pixels;
        to.m_pixels.y0 = m_pixels.y1 = m_pixels.y0 + m_pixels.height() / 2;
        return true;
    }

    // What only changes where somebody begins or takes.
    const MeshedTile& of() const { return *m_of; }
    bool grid() const { return m_grid; }

    /// All that is left.
    Rect pixels() const {
        const std::lock_guard<std::mutex> lock(m_mutex);
        return m_pixels;
    }

private:
    bool can_give() const { return m_least > 0 && m_pixels.height() >= 2 * m_least; }

    mutable std::mutex m_mutex;
    const MeshedTile* m_of = nullptr;
    Rect m_pixels;
    bool m_grid = false;
    int m_least = 0;
};

} // namespace ddt
