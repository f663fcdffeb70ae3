// SPDX-License-Identifier: Apache-2.0
// The surface over a mesh of a tile.
#pragma once

#include <vector>

#include "core/sample/evaluate.h"
#include "core/surface/consistency/corrected_rows.h"
#include "core/surface/control_net.h"
#include "core/surface/edge_maker.h"
#include "core/surface/fitted/fitted_maker.h"
#include "core/tiles/tile_mesh.h"
#include "ddt/core.h"

namespace ddt {

/// A surface and its memory, kept from one tile, or part of one, to the next.
class TileSurface {
public:
    TileSurface(const Job& job, const Mapping& mapping);

    /// About the bytes that this takes for a lattice of width x height pixels; cells: of begin().
    static MemoryNeeded memory(const Job& job, int width, int height, int cells);

    /// Lay the surface over a mesh, through `values`, the job's channels for each pixel, to sample
    /// it in the cells of `part`, the mesh's tile or one with some of its cells, no more than so
    /// many rows of cells at once. Mesh and values must stay there while it is in use. arena: for
    /// its rows, see take_rows().
    void begin(const TileMesh& mesh, const Tile& part, int cells, const float* values,
               Arena& arena);

    /// Edges are made as they are needed: before what needs them is sampled, make_edges_for() its
    /// y, in ascending order, is to be called. What is above `keep` may be gone then.
    void make_edges_for(int32_t y, int32_t keep);

    /// To be called before positions are sampled that are not those of the columns before.
    void begin_panel() { m_search.begin(); }

    /// Sample at n points; row_padding floats more may be written.
    void sample(const Point* points, int n, float* out);
    /// Sample some of n rows at y[0], y[1], ... and the x of `points`, whose y is overwritten,
    /// `row` floats apart in `out`; returns how many, which is the same for all meshes of a tile.
    int sample_block(const Columns& columns, std::vector<Point>& points, const int32_t* y, int n,
                     float* out, size_t row);

private:
    GroupValues group_values(const float* values, int group) const;
    GroupOutput group_output(int group, float* out, size_t row) const;
    EdgeRecipe recipe(int cells);
    void begin_corrected(int group, const float* values, const Rect& part, int cells);
    void correct_for(const Rect& part, int group);
    void bound(int channel, Point p, float* pixel) const;
    void begin_fitted(int group, const float* values, const Rect& part, int cells);

    const Job& m_job;
    Correction m_correction;
    std::vector<int> m_bounded; ///< bounded_channels()
    const TileMesh* m_mesh = nullptr;
    const float* m_values = nullptr;
    Arena* m_arena = nullptr;
    std::vector<ControlNet> m_nets; ///< one a group of channels
    std::vector<EdgeMaker> m_edges;
    std::vector<FittedMaker> m_fitted; ///< in their place
    CorrectedRows m_rounds;            ///< before them, where there are any
    FanRows m_fans;                    ///< all theirs
    std::vector<float> m_corrected;    ///< of many channels, what they make of the values
    Search m_search;
    LocatedRow m_row;
    LocatedBlock m_block;
};

} // namespace ddt
