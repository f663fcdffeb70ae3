// SPDX-License-Identifier: Apache-2.0
// What the edges of a control net are made of.
#pragma once

#include <cstdint>
#include <vector>

#include "core/surface/net.h"

namespace ddt {

/// What is known of a row of cells.
struct CellRow {
    std::vector<float> down;    ///< 1 where the diagonal is down, else 0; padded to whole vectors
    std::vector<uint8_t> other; ///< 1 where other edges cross the cell
};

/// Flag those of cells x0 .. x1 - 1 of a row whose diagonal is down, as in CellRow.
inline void flag_down(const Division* divisions, int x0, int x1, float* down) {
    for (int x = x0; x < x1; ++x)
        down[x] = divisions[x] == Division::down ? 1.0f : 0.0f;
}

/// The rows round the one that is worked on, so that neighbours lie next to one another.
struct NearRows {
    std::vector<float> vertices[3]; ///< of row y of pixels at [y % 3], group_size floats each
    CellRow cells[2];               ///< row y of cells at [y % 2]

    void resize(int width);
    const float* vertex(int x, int y) const {
        return vertices[y % 3].data() + ptrdiff_t(x) * group_size;
    }
    const CellRow& cell_row(int y) const { return cells[y % 2]; }

    /// Before rows y, y + 1, ... of pixels are worked on: load those before y + 1.
    void begin(const Lattice& lattice, const Rect& part, int y, const Net& net);
    /// Before row y is: load row y + 1, and the cells between, as far as `part` (in pixels, and one
    /// pixel more) needs them.
    void load_below(const Lattice& lattice, const Rect& part, int y, const Net& net);
};

/// Kept from one use to the next.
struct EdgeScratch {
    /// The gradients at vertex site s: group_size floats at gradients_at(s), x, and as many a
    /// doubled row below, y. Of some rows of the lattice, or of all.
    std::vector<float> gradients;
    int first = 0; ///< the site that they begin with
    float* gradients_at(int site) { return gradients.data() + 2 * ptrdiff_t(site - first); }
    const float* gradients_at(int site) const {
        return gradients.data() + 2 * ptrdiff_t(site - first);
    }
    NearRows gradient_rows, edge_rows; ///< edges are made after the gradients at both their ends
    std::vector<float> weights;        ///< of the soft edges of a row of the doubled lattice
};

/// Floats beyond the last of a row that may be read or written.
constexpr size_t edge_padding = 4 * group_size;

/// Make the gradients at the vertices of rows y0 .. y1 - 1 of pixels; those of the row before y0
/// were made last, if it is in the part.
void make_gradients(const Lattice& lattice, const Rect& part, int y0, int y1, const Net& net,
                    EdgeScratch& scratch);

/// Make e, if `bend`, and q, if there is a gain, of the edges with midpoints in rows y0 .. y1 - 1
/// of the doubled lattice; those of the row before y0 were made last, if it is in the part.
void make_edges(const Lattice& lattice, const Rect& part, int y0, int y1, bool bend,
                const float* gain, float reciprocal_tau, EdgeScratch& scratch, Net& net);

} // namespace ddt
