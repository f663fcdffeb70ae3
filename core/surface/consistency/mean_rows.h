// SPDX-License-Identifier: Apache-2.0
// The surface's means over source pixels (consistency.h), row after row.
#pragma once

#include <vector>

#include "core/surface/consistency/consistency.h"
#include "core/surface/edge_maker.h"

namespace ddt {

/// Of one group of channels. The net, its edges and the sums are there for as many rows as are in
/// use.
class MeanRows {
public:
    /// Start on the vertices of `wanted`, a part of the lattice in pixels, of a surface through
    /// `values`, which must stay where they are. crossed: of all who take means on the
    /// lattice; it has begun with mean_positions().
    void begin(const Lattice& lattice, const Rect& wanted, Surface surface,
               const EdgeRecipe& recipe, const GroupValues& values, CrossedRows& crossed);
    void begin(const Lattice& lattice, const Rect& wanted, Surface surface,
               const EdgeRecipe& recipe, ValueRows& values, CrossedRows& crossed);

    /// The sums of quadrants' means of the vertices in row y, from column 0 on, until the next row
    /// is asked for; rows in order, from the first of `wanted` on. Of the net, edges in row `keep`
    /// of pixels and below stay.
    const float* row(int y, int keep);

    const ControlNet& net() const { return m_net; }
    /// The part of the lattice whose edges are made.
    const Rect& part() const { return m_edges.part(); }

    /// About the bytes that this takes of `count` channels where edges are of the usual length.
    static MemoryNeeded memory(int width, int height, int count, const EdgeRecipe& recipe);

private:
    template <class Values>
    void begin_any(const Lattice& lattice, const Rect& wanted, Surface surface,
                   const EdgeRecipe& recipe, Values& values, CrossedRows& crossed);
    float* sums(int y) { return m_sums.data() + size_t(y % 2) * (m_sums.size() / 2); }

    const Lattice* m_lattice = nullptr;
    Rect m_wanted;
    Surface m_surface = Surface::patch;
    ControlNet m_net;
    EdgeMaker m_edges;
    CrossedRows* m_crossed = nullptr;
    MeanScratch m_scratch;
    std::vector<float> m_sums; ///< row y at [y % 2]
    int m_cell_rows = 0;       ///< rows of cells above this one are in the sums
};

} // namespace ddt
