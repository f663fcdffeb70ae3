// SPDX-License-Identifier: Apache-2.0
// Nets of all rows of a lattice, made a stage at a time: what nets that are made row by row
// (core/surface/edge_maker.h) are compared with, and what looks at the stages works on.
#pragma once

#include "core/surface/control_net.h"
#include "core/surface/edge_scratch.h"
#include "core/surface/kept_rows.h"

namespace ddt::test {

/// Have all rows of numbers there.
inline void take_all_rows(const Lattice& lattice, int count, SiteRows& rows) {
    rows.numbers.resize(size_t(lattice.height()) * site_row(lattice.width(), count) + edge_padding);
    rows.count = count;
    rows.first = 0;
}

/// Set the vertices to a group's values.
inline void set_all_vertices(const Lattice& lattice, const GroupValues& values, ControlNet& net) {
    take_all_rows(lattice, values.count, net.values.even);
    take_all_rows(lattice, values.count, net.values.odd);
    net.stride = lattice.stride();
    set_vertices(lattice, values, {0, 0, lattice.width(), lattice.height()}, net);
}

/// Makes the edges of such nets, whose vertices are set.
class WholeEdges {
public:
    /// Make e, if `bend`, and q, if `soft`, by ControlNet::bounds and the gains of the finished
    /// mesh, of the edges whose ends both lie in `part`. With `bend` the lattice's divisions and
    /// first edges must have been found.
    void make(const Lattice& lattice, const Rect& part, bool bend, bool soft, float tau,
              ControlNet& net) {
        m_fans.begin(lattice, 1);
        m_scratch.fans = &m_fans;
        m_scratch.edge_cells.resize(lattice.width());
        m_scratch.gradient_cells.resize(lattice.width());
        if (bend) {
            take_all_rows(lattice, net.count(), m_scratch.gradients);
            make_gradients(lattice, part, part.y0, part.y1, net, m_scratch);
        }
        for (auto& weights : m_scratch.weights)
            weights.resize(size_t(lattice.width()) + edge_padding);
        if (soft) {
            take_all_rows(lattice, net.count(), net.soft.even);
            take_all_rows(lattice, net.count(), net.soft.odd);
        }
        make_edges(lattice, part, 2 * part.y0, 2 * part.y1 - 1, bend, soft,
                   soft ? 1.0f / tau : 0.0f, m_scratch, net);
    }

    /// Of the last edges with bends: EdgeScratch::gradients.
    const SiteRows& gradients() const { return m_scratch.gradients; }

private:
    EdgeScratch m_scratch;
    FanRows m_fans;
};

} // namespace ddt::test
