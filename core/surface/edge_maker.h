// SPDX-License-Identifier: Apache-2.0
// What belongs to the edges of a control net: their bends e and softness q (see net.h).
#pragma once

#include "core/surface/edge_scratch.h"

namespace ddt {

/// Makes a net's edges from the top row downwards, so that rows can be used while they are in the
/// cache.
class EdgeMaker {
public:
    /// Take the memory for a lattice of so many sites.
    void reserve(size_t sites);

    /// Start on the edges of a net whose ends both lie in `part`, a part of the lattice in pixels.
    /// `bend`: make e, for Surface::patch; the lattice's divisions and first edges must
    /// then have been found.
    /// `gain`: make q, by Workspace::gain of the finished mesh and tau > 0; null: do not.
    void begin(const Lattice& lattice, const Rect& part, bool bend, const float* gain, float tau,
               Net& net);

    /// Make the edges with midpoints in row y of pixels or further up, as far as they are not made.
    void to_row(int y);
    /// Make all edges.
    void finish() { to_row(m_part.y1); }

    /// Once all are made, with bends: the gradients, as EdgeScratch has them.
    const float* gradients() const { return m_scratch.gradients.data(); }

private:
    EdgeScratch m_scratch;
    const Lattice* m_lattice = nullptr;
    Net* m_net = nullptr;
    Rect m_part;
    bool m_bend = false;
    const float* m_gain = nullptr;
    float m_reciprocal_tau = 0;
    int m_gradient_rows = 0; ///< rows of pixels above this one are done
    int m_edge_rows = 0;     ///< rows of the doubled lattice above this one are done
};

} // namespace ddt
