// SPDX-License-Identifier: Apache-2.0
// A mesh of a tile and the surface over it.
#pragma once

#include <vector>

#include "core/sample/evaluate.h"
#include "core/surface/corrected_rows.h"
#include "core/surface/edge_maker.h"
#include "core/surface/fitted/fitted_maker.h"
#include "core/surface/net.h"
#include "core/tiles/grid.h"
#include "core/triangulate/triangulate.h"
#include "ddt/core.h"

namespace ddt {

/// Whether a surface depends on the finished mesh's gains.
bool wants_gains(const SurfaceOptions& surface);

/// The memory of one mesh, kept from one tile to the next.
class TileMesh {
public:
    explicit TileMesh(const Job& job) : m_job(job) {}

    /// Take the memory that a lattice of so many sites needs: a vector that grows from tile to tile
    /// would take up to twice of it.
    void reserve(size_t sites);
    /// About the bytes that this takes for a lattice of width x height pixels; `rows`: where only
    /// rows of it are kept (finish_edges() is not called).
    static size_t memory(const Job& job, int width, int height, bool rows);

    /// Make the mesh of a width x height guide. Adds to `statistics`.
    void triangulate(const float* guide, int width, int height, Workspace& workspace,
                     Statistics& statistics);
    /// Lay the surface over it, through `values`, the job's channels for each pixel, which must
    /// stay there while it is in use. Where vertices are corrected, the corrected ones take the
    /// values' place, if `own`.
    void make_surface(const Tile& tile, float* values, bool own);

    const Lattice& lattice() const { return m_lattice; }
    /// Edges are made as they are needed: before what needs them is sampled, make_edges_for() its
    /// y, in ascending order, or finish_edges(), is to be called. What is above `keep` may be gone
    /// then.
    void make_edges_for(int32_t y, int32_t keep);
    void finish_edges();

    /// To be called before positions are sampled that are not those of the columns before.
    void begin_panel() { m_search.begin(); }

    /// Sample at n points; row_padding floats more may be written.
    void sample(const Point* points, int n, float* out);
    /// Sample some of n rows at y[0], y[1], ... and the x of `points`, whose y is overwritten,
    /// `row` floats apart in `out`; returns how many, which is the same for all meshes of a tile.
    int sample_block(const Columns& columns, std::vector<Point>& points, const int32_t* y, int n,
                     float* out, size_t row);

private:
    /// The part of the lattice whose edges are sampled: triangles of the tile reach into the halo.
    Rect sampled_part(const Tile& tile) const;
    GroupValues group_values(const float* values, int group) const;
    EdgeRecipe recipe() const;
    void set_strictness(int group, Net& net) const;
    float* place_for_corrected(float* values, bool own);
    void begin_corrected(int group, float* values, const Rect& part);
    void begin_fitted(int group, const float* values, const Rect& part);

    const Job& m_job;
    Lattice m_lattice;
    std::vector<float> m_gain; ///< Workspace::gain of the finished mesh, for soft edges
    std::vector<Net> m_nets;   ///< one a group of channels
    std::vector<EdgeMaker> m_edges;
    std::vector<FittedMaker> m_fitted; ///< in their place
    CorrectedRows m_rounds;            ///< before them, where there are any
    std::vector<float> m_corrected;    ///< values, where they are not to be changed in their place
    Search m_search;
    LocatedRow m_row;
    LocatedBlock m_block;
};

} // namespace ddt
