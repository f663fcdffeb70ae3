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

/// Of which arrays an EdgeMaker keeps but a window of rows (kept_rows.h); the others have all rows.
enum class Windowed {
    none,
    edges, ///< softness and gradients; vertices and bends are as the net has them
    all,   ///< these and the net's vertices and bends
};

/// Makes a net's edges from the top row downwards, so that rows can be used while they are in the
/// cache, and need not be kept longer than they are used.
class EdgeMaker {
public:
    /// Start on the edges of a net of the whole lattice whose ends both lie in `part`, a part of
    /// the lattice in pixels. What `recipe` has no need of stays as it is.
    void begin(const Lattice& lattice, const Rect& part, const EdgeRecipe& recipe, ControlNet& net);
    /// By the bounds that the net has.
    void begin(const Lattice& lattice, const Rect& part, bool bend, bool soft, float tau,
               ControlNet& net) {
        EdgeRecipe recipe{bend, soft, tau};
        recipe.bounds = net.bounds;
        begin(lattice, part, recipe, net);
    }
    /// The same where q and the gradients, which begin() keeps for all rows, are kept for some.
    void begin_edge_rows(const Lattice& lattice, const Rect& part, const EdgeRecipe& recipe,
                         ControlNet& net);
    /// The same of a net of some rows, whose vertices are set to `values`, as they are needed, too.
    /// The values must stay where they are.
    void begin_rows(const Lattice& lattice, const Rect& part, const EdgeRecipe& recipe,
                    const GroupValues& values, ControlNet& net);
    /// The same of values that are made as they are needed.
    void begin_rows(const Lattice& lattice, const Rect& part, const EdgeRecipe& recipe,
                    ValueRows& values, ControlNet& net);

    /// Make the edges with midpoints in row y of pixels or further up, as far as they are not made,
    /// in steps. Of a net of some rows, those that no triangle at or below row `keep` of cells has
    /// may go.
    void to_row(int y, int keep);
    /// The same of what triangles that meet row y of cells have.
    void to_cells(int y, int keep) { to_row(m_reach.last_neighbour(y), keep); }
    /// Make all edges, and keep them.
    void finish() { to_row(m_part.y1, 0); }

    /// The part of the lattice that edges are made for.
    const Rect& part() const { return m_part; }
    /// Edges with midpoints above this row of pixels are made.
    int rows() const { return m_edge_rows / 2; }

    /// Once all are made, with bends: the gradients, as EdgeScratch has them.
    const SiteRows& gradients() const { return m_scratch.gradients; }

    /// About the bytes that this and a net of some rows of `count` channels usually take.
    static MemoryNeeded memory(int width, int height, int count, const EdgeRecipe& recipe);

private:
    void begin(const Lattice& lattice, const Rect& part, const EdgeRecipe& recipe,
               Windowed windowed, int count, ControlNet& net);
    bool edges_windowed() const { return m_windowed != Windowed::none; }
    bool values_windowed() const { return m_windowed == Windowed::all; }
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
    GroupValues m_values;              ///< of a net of some rows,
    ValueRows* m_value_rows = nullptr; ///< or what makes them
    Windowed m_windowed = Windowed::none;
    int m_vertex_rows = 0;   ///< rows of pixels above this one are set
    int m_gradient_rows = 0; ///< ... have gradients
    int m_edge_rows = 0;     ///< rows of the doubled lattice above this one are done
};

} // namespace ddt
