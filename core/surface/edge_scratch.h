// SPDX-License-Identifier: Apache-2.0
// What the edges of a control net are made of.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/surface/control_net.h"
#include "core/surface/fan_rows.h"
#include "core/surface/near_cells.h"

namespace ddt {

/// A net's vertices in a row of pixels, from column 0 on; those of the nearest row where there is
/// none.
inline const float* vertex_row(const Lattice& lattice, const ControlNet& net, int y) {
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
    bool bent = false; ///< EdgeRecipe::bent
    /// The gradients: x at a vertex' site, y at the site below.
    SiteRows gradients;
    FanRows* fans = nullptr; ///< of the lattice
    Spokes spokes;
    NearCells gradient_cells, edge_cells; ///< edges are made after the gradients at both their ends
    /// Of the soft edges of a row of the doubled lattice, of even and of odd columns.
    std::vector<float> weights[2];
    std::vector<int> columns; ///< of edges that are made one by one
};

/// Make the gradients at the vertices of rows y0 .. y1 - 1 of pixels; those of the row before y0
/// were made last, if it is in the part.
void make_gradients(const Lattice& lattice, const Rect& part, int y0, int y1, const ControlNet& net,
                    EdgeScratch& scratch);

/// Make e, if `bend`, and q, if `soft`, of the edges with midpoints in rows y0 .. y1 - 1
/// of the doubled lattice; those of the row before y0 were made last, if it is in the part.
void make_edges(const Lattice& lattice, const Rect& part, int y0, int y1, bool bend, bool soft,
                float reciprocal_tau, EdgeScratch& scratch, ControlNet& net);

} // namespace ddt
