// SPDX-License-Identifier: Apache-2.0
// A net of fitted vertices and bends, made row by row from the plain one's.
#pragma once

#include <vector>

#include "core/lattice/row_reach.h"
#include "core/surface/consistency/mean_rows.h"
#include "core/surface/fitted/fitted.h"

namespace ddt {

/// What a fitted net is made from.
struct FittedRecipe {
    /// EdgeRecipe::tau, or 0: no soft edges.
    float tau = 0;
    Bounds bounds = Bounds::vertices; ///< EdgeRecipe::bounds
    Correction correction = {};
    /// Lanes whose bit is set keep their source values: IDs are nothing to correct.
    unsigned kept_lanes = 0;
    /// EdgeRecipe::arena and cells
    Arena* arena = nullptr;
    int cells = 1;
};

/// Makes one group's net from the top row downwards, as EdgeMaker does: the plain edges through the
/// source, the means of their surface, where the vertices go, bends and softness follow one another
/// at the distance of the longest edges there, so that of each no more than some rows are there.
class FittedMaker {
public:
    /// Start on a net of some rows: the vertices of `part`, a part of the lattice in pixels, and
    /// the edges whose ends both lie in it. The lattice's divisions and first edges must have been
    /// found; the values must stay where they are, and group_size floats after the last may be
    /// read.
    void begin(const Lattice& lattice, const Rect& part, const FittedRecipe& recipe,
               const GroupValues& values, ControlNet& net);

    /// As EdgeMaker's: the edges with midpoints in row y of pixels or further up.
    void to_row(int y, int keep);
    void to_cells(int y, int keep) { to_row(m_reach.last_neighbour(y), keep); }

    /// About the bytes that this and the net take where edges are of the usual length. values: what
    /// is told of their channels; soft, cells: of the recipe.
    static MemoryNeeded memory(int width, int height, const GroupValues& values, bool soft,
                               int cells);

private:
    void go_on(int y, int keep);
    int bent_end(int vertices) const;
    void make_row();
    size_t row_size() const { return size_t(m_lattice->width()) * size_t(m_values.count); }

    const Lattice* m_lattice = nullptr;
    RowReach m_reach;
    ControlNet* m_net = nullptr;
    Rect m_part;
    Rect m_moved; ///< the vertices that the part's edges and their apexes are
    FittedRecipe m_recipe;
    GroupValues m_values;
    const float* m_source = nullptr; ///< of all pixels: the values, or,
    std::vector<float> m_copied;     ///< where they have more channels, a copy
    CrossedRows m_crossed;
    MeanRows m_plain; ///< of the plain surface
    EdgeMaker m_soft;
    BendScratch m_bends;
    std::vector<float> m_index; ///< row y at [y % m_index_rows]
    int m_index_rows = 1;
    int m_vertex_rows = 0; ///< rows of pixels above this one have their vertices
    int m_edge_rows = 0;   ///< rows of the doubled lattice above this one are bent
};

} // namespace ddt
