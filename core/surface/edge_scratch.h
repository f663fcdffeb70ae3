// SPDX-License-Identifier: Apache-2.0
// What the edges of a control net are made of.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include "core/base/arith.h"
#include "core/surface/net.h"

namespace ddt {

/// What is known of a row of cells.
struct CellRow {
    std::vector<float> down;    ///< 1 where the diagonal is down, else 0; padded for spread()
    std::vector<uint8_t> other; ///< 1 where other edges cross the cell; padded for eight_flags()
};

/// Flags of 0 or 1, a byte each, the first in the lowest bits.
inline uint64_t eight_flags(const uint8_t* flags) {
    uint64_t word;
    std::memcpy(&word, flags, sizeof word);
    return word;
}

/// The first column from x on that is outside begin .. end - 1 or flagged. flags(x): eight_flags()
/// of column x and those after it, of which columns outside are not looked at.
template <class Flags>
DDT_INLINE int next_flagged(int x, int begin, int end, Flags&& flags) {
    if (x < begin || x >= end)
        return x;
    for (; x < end; x += 8)
        if (const uint64_t word = flags(x))
            return std::min(x + __builtin_ctzll(word) / 8, end);
    return end;
}

/// Flag those of cells x0 .. x1 - 1 of a row whose diagonal is down, as in CellRow.
inline void flag_down(const Division* divisions, int x0, int x1, float* down) {
    for (int x = x0; x < x1; ++x)
        down[x] = divisions[x] == Division::down ? 1.0f : 0.0f;
}

/// The rows of cells above and below the row of pixels that is worked on.
struct NearCells {
    CellRow cells[2]; ///< row y of cells at [y % 2]

    void resize(int width);
    const CellRow& above(int y) const { return cells[(y + 1) % 2]; }
    const CellRow& below(int y) const { return cells[y % 2]; }

    /// Before rows y, y + 1, ... of pixels are worked on: load the cells above.
    void begin(const Lattice& lattice, const Rect& part, int y);
    /// Before row y is: load the cells below, as far as `part` (in pixels) needs them.
    void load_below(const Lattice& lattice, const Rect& part, int y);
};

/// A net's vertices in a row of pixels, from column 0 on; those of the nearest row where there is
/// none.
inline const float* vertex_row(const Lattice& lattice, const Net& net, int y) {
    return net.vertex(lattice.vertex_site(0, std::clamp(y, 0, lattice.height() - 1)));
}

/// Kept from one use to the next.
struct EdgeScratch {
    /// The gradients: x at a vertex' site, y at the site below.
    SiteRows gradients;
    NearCells gradient_cells, edge_cells; ///< edges are made after the gradients at both their ends
    /// Of the soft edges of a row of the doubled lattice, of even and of odd columns.
    std::vector<float> weights[2];
};

/// Floats beyond the last of a row that may be read or written.
constexpr size_t edge_padding = most_row_lanes;

/// Make the gradients at the vertices of rows y0 .. y1 - 1 of pixels; those of the row before y0
/// were made last, if it is in the part.
void make_gradients(const Lattice& lattice, const Rect& part, int y0, int y1, const Net& net,
                    EdgeScratch& scratch);

/// Make e, if `bend`, and q, if there is a gain, of the edges with midpoints in rows y0 .. y1 - 1
/// of the doubled lattice; those of the row before y0 were made last, if it is in the part.
void make_edges(const Lattice& lattice, const Rect& part, int y0, int y1, bool bend,
                const float* gain, float reciprocal_tau, EdgeScratch& scratch, Net& net);

} // namespace ddt
