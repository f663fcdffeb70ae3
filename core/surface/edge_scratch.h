// SPDX-License-Identifier: Apache-2.0
// What the edges of a control net are made of.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/surface/fan_rows.h"
#include "core/surface/net.h"

namespace ddt {

/// Flag those of cells x0 .. x1 - 1 of a row whose diagonal is down: 1, else 0.
inline void flag_down(const Division* divisions, int x0, int x1, float* down) {
    for (int x = x0; x < x1; ++x)
        down[x] = divisions[x] == Division::down ? 1.0f : 0.0f;
}

/// Flags as of flag_down(), padded for spread(), of the rows of cells above and below the row of
/// pixels that is worked on.
struct NearCells {
    std::vector<float> rows[2]; ///< row y of cells at [y % 2]

    void resize(int width);
    const float* above(int y) const { return rows[(y + 1) % 2].data(); }
    const float* below(int y) const { return rows[y % 2].data(); }

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

/// Spokes of fans, one after the other.
struct Spokes {
    std::vector<float> x, y; ///< the neighbour relative to the vertex, in pixels
    std::vector<int32_t> at; ///< the same in floats of a net's rows
};

/// Kept from one use to the next.
struct EdgeScratch {
    /// Whether all vertices that are there are known to be tame (core/surface/tame.h).
    bool tame = false;
    /// The gradients: x at a vertex' site, y at the site below.
    SiteRows gradients;
    FanRows* fans = nullptr; ///< of the lattice
    Spokes spokes;
    NearCells gradient_cells, edge_cells; ///< edges are made after the gradients at both their ends
    /// Of the soft edges of a row of the doubled lattice, of even and of odd columns.
    std::vector<float> weights[2];
    std::vector<int> columns; ///< of edges that are made one by one
};

/// Floats beyond the last of a row that may be read or written.
constexpr size_t edge_padding = most_lanes;

/// Make the gradients at the vertices of rows y0 .. y1 - 1 of pixels; those of the row before y0
/// were made last, if it is in the part.
void make_gradients(const Lattice& lattice, const Rect& part, int y0, int y1, const Net& net,
                    EdgeScratch& scratch);

/// Make e, if `bend`, and q, if `soft`, of the edges with midpoints in rows y0 .. y1 - 1
/// of the doubled lattice; those of the row before y0 were made last, if it is in the part.
void make_edges(const Lattice& lattice, const Rect& part, int y0, int y1, bool bend, bool soft,
                float reciprocal_tau, EdgeScratch& scratch, Net& net);

} // namespace ddt
