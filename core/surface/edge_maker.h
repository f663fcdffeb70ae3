// SPDX-License-Identifier: Apache-2.0
// What belongs to the edges of a control net: their bends e and softness q (see control_net.h).
#pragma once

#include "core/lattice/row_reach.h"
#include "core/surface/edge_scratch.h"
#include "core/surface/kept_rows.h"

namespace ddt {

/// Rows of pixels whose vertices, and whose edges, are there at once.
struct RowsInUse {
    int vertices, edges;
};

/// What the edges of a net are made from.
struct EdgeRecipe {
    /// Make e, for Surface::patch; the lattice's divisions and first edges must then have been
    /// found.
    bool bend = false;
    /// Make q, by the gains of the finished mesh and tau > 0.
    bool soft = false;
    float tau = 0;
    /// With bends: where the lattice's fans are kept, for others, too; null: they are not.
    FanRows* fans = nullptr;
    /// Where rows are kept, as take_rows() says; null: on the heap.
    Arena* arena = nullptr;
    /// Rows of cells that to_cells() is asked for at once, at most.
    int cells = 1;
    /// Without `bend`: e is there of edges before their q is made. Else it counts as 0.
    bool bent = false;
    /// What of softness is kept; the net's then.
    Bounds bounds = Bounds::vertices;
};

/// Makes a net's edges from the top row downwards, so that rows can be used while they are in the
/// cache, and need not be kept longer than they are used (kept_rows.h).
class EdgeMaker {
public:
    /// Start on the softness of the edges whose ends both lie in `part`, a part of the lattice in
    /// pixels, of a net whose vertices and bends another makes in time. What `recipe` has no need
    /// of stays as it is.
    void begin_edge_rows(const Lattice& lattice, const Rect& part, const EdgeRecipe& recipe,
                         ControlNet& net);
    /// Start on bends and softness of a net whose vertices are set to `values`, as they are needed,
    /// too. The values must stay where they are.
    void begin_rows(const Lattice& lattice, const Rect& part, const EdgeRecipe& recipe,
                    const GroupValues& values, ControlNet& net);
    /// The same of values that are made as they are needed.
    void begin_rows(const Lattice& lattice, const Rect& part, const EdgeRecipe& recipe,
                    ValueRows& values, ControlNet& net);

    /// Make the edges with midpoints in row y of pixels or further up, as far as they are not made,
    /// in steps. Rows that no triangle at or below row `keep` of cells has may go.
    void to_row(int y, int keep);
    /// The same of what triangles that meet row y of cells have.
    void to_cells(int y, int keep) { to_row(m_reach.last_neighbour(y), keep); }

    /// The part of the lattice that edges are made for.
    const Rect& part() const { return m_part; }
    /// Edges with midpoints above this row of pixels are made.
    int rows() const { return m_edge_rows / 2; }

    /// About the bytes that this and a net of `count` channels usually take.
    static MemoryNeeded memory(int width, int height, int count, const EdgeRecipe& recipe);

private:
    void begin(const Lattice& lattice, const Rect& part, const EdgeRecipe& recipe,
               bool makes_vertices, int count, ControlNet& net);
    void go_on(int y, int keep);
    int last_row(int y) const;
    int values_end(int y) const;
    RowsInUse most_in_use() const;
    void load_vertices(int end, int keep);

    EdgeScratch m_scratch;
    FanRows m_fans; ///< where no others keep them
    const Lattice* m_lattice = nullptr;
    RowReach m_reach;
    ControlNet* m_net = nullptr;
    Rect m_part;
    EdgeRecipe m_recipe;
    bool m_makes_vertices = false;     ///< and takes rows for them and bends
    GroupValues m_values;              ///< for these,
    ValueRows* m_value_rows = nullptr; ///< or what makes them
    int m_vertex_rows = 0;             ///< rows of pixels above this one are set
    int m_gradient_rows = 0;           ///< ... have gradients
    int m_edge_rows = 0;               ///< rows of the doubled lattice above this one are done
};

} // namespace ddt
