// SPDX-License-Identifier: Apache-2.0
// Which rows of a tile are left to write, for those who share them.
#pragma once

#include <algorithm>
#include <mutex>

#include "core/tiles/tile_mesh.h"
#include "ddt/rect.h"

namespace ddt {

/// The rows of a tile, or of part of it, that somebody writes from the top downwards while others
/// may take half of what is left. Where its output is a grid (TileWriter::is_grid()) they are rows
/// of output pixels, else rows of the tile's cells. Thread-safe.
class RowsLeft {
public:
    /// These are to be written. `least`: rows, at least 1, that are worth being given to somebody;
    /// 0: none are given.
    void begin(const MeshedTile& of, const Rect& rows, bool grid, int least) {
        const std::lock_guard<std::mutex> lock(m_mutex);
        m_of = &of;
        m_rows = rows;
        m_grid = grid;
        m_least = least;
    }

    /// The next of them, so many rows or what is left; empty: there are none.
    Rect take(int rows) {
        const std::lock_guard<std::mutex> lock(m_mutex);
        Rect taken = m_rows;
        taken.y1 = std::min(taken.y0 + rows, taken.y1);
        m_rows.y0 = taken.y1;
        return taken;
    }

    /// How many of them are left, if they are enough for give(); else 0.
    int to_share() const {
        const std::lock_guard<std::mutex> lock(m_mutex);
        return can_give() ? m_rows.height() : 0;
    }

    /// Let the lower half go to `to`, if each half has at least `least` rows.
    bool give(RowsLeft& to) {
        const std::scoped_lock lock(m_mutex, to.m_mutex);
        if (!can_give())
            return false;
        to.m_of = m_of;
        to.m_grid = m_grid;
        to.m_least = m_least;
        to.m_rows = m_rows;
        to.m_rows.y0 = m_rows.y1 = m_rows.y0 + m_rows.height() / 2;
        return true;
    }

    // What only changes where somebody begins or takes.
    const MeshedTile& of() const { return *m_of; }
    bool grid() const { return m_grid; }

    /// All that is left.
    Rect all() const {
        const std::lock_guard<std::mutex> lock(m_mutex);
        return m_rows;
    }

private:
    bool can_give() const { return m_least > 0 && m_rows.height() >= 2 * m_least; }

    mutable std::mutex m_mutex;
    const MeshedTile* m_of = nullptr;
    Rect m_rows;
    bool m_grid = false;
    int m_least = 0;
};

} // namespace ddt
