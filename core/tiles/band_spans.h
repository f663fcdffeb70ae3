// SPDX-License-Identifier: Apache-2.0
// Where the output pixels are whose positions lie in some rows of a tile's cells.
#pragma once

#include <vector>

#include "core/tiles/grid.h"
#include "ddt/mapping.h"

namespace ddt {

/// Of mappings whose positions come in any order. A band is a tile with some of its rows of cells;
/// it is asked for one band after the other, from the top downwards.
class BandSpans {
public:
    /// Columns of a row.
    struct Span {
        int x0, x1;
        bool empty() const { return x0 >= x1; }
    };
    /// The bytes that this takes for so many rows of output.
    static size_t memory(int rows) { return size_t(rows) * 2 * sizeof(Span); }

    /// Of output pixels of `all`, which are those of the bands that follow and maybe others.
    void begin(const Rect& all);

    /// Find the pixels of a band in a window.
    void find(const Tile& band, const Rect& window, const Mapping& mapping);
    /// Rows y0 .. y1 - 1 have some.
    int y0() const { return m_y0; }
    int y1() const { return m_y1; }
    /// Columns, of which the others of row y have none.
    Span row(int y) const;

    /// Whether row(y) holds all that is left of the row for this band and those that follow, as it
    /// does where reach() is far from tight. Then leave() should say what is left to the latter, so
    /// that they look at no more.
    bool holds_rest(int y) const;
    void leave(int y, const Span& rest) { m_left[index(y)] = rest; }

private:
    size_t index(int y) const { return size_t(y - m_all.y0); }

    Rect m_all;
    int m_y0 = 0, m_y1 = 0;
    std::vector<Span> m_found; ///< the band's, a row of m_all each
    std::vector<Span> m_left;  ///< where pixels of this band and those that follow may be
};

} // namespace ddt
