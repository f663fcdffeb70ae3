// SPDX-License-Identifier: Apache-2.0
// A mesh of a tile.
#pragma once

#include <vector>

#include "core/tiles/grid.h"
#include "core/triangulate/triangulate.h"
#include "ddt/core.h"

namespace ddt {

/// A mesh and its memory, kept from one tile to the next, and from job to job.
class TileMesh {
public:
    /// Take the memory that a lattice of so many sites needs: a vector that grows from tile to tile
    /// would take up to twice of it.
    void reserve(size_t sites) { m_lattice.reserve(sites); }
    /// Room for the guide of the next mesh, within its own memory.
    float* guide_place(int width, int height) { return m_lattice.guide_place(width, height); }
    /// About the bytes that this takes for a lattice of width x height pixels.
    static size_t memory(int width, int height);
    /// Those that it takes.
    size_t bytes() const { return m_lattice.bytes(); }

    /// Make the mesh of a width x height guide, and find its gains if the job's surface wants them.
    /// Adds to `statistics`.
    void triangulate(const Job& job, const float* guide, int width, int height,
                     Workspace& workspace, Statistics& statistics);
    /// Find what surfaces over the tile, or parts of it, ask the lattice for. Nothing changes from
    /// here on, whoever reads it.
    void find_cells(const Job& job, const Tile& tile);
    /// The part of the lattice whose edges are sampled in the tile's cells, or in those of one that
    /// has some of them: their triangles reach into the halo.
    Rect sampled(const Tile& part) const;

    const Lattice& lattice() const { return m_lattice; }

private:
    Lattice m_lattice;
    Rect m_cells, m_sampled; ///< the tile's, and sampled() of them
};

/// A tile that was read and triangulated: what its output is made from.
struct MeshedTile {
    Tile tile;
    int index = 0;             ///< in the job's grid
    Rect output;               ///< holds the output pixels that are wanted of it
    int width = 0, height = 0; ///< of the lattices
    std::vector<float> values; ///< the job's channels, pixel by pixel, and group_size more floats
    std::vector<TileMesh> meshes;
};

} // namespace ddt
