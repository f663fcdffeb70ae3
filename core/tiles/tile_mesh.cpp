// SPDX-License-Identifier: Apache-2.0
#include "core/tiles/tile_mesh.h"

#include "core/base/float_mode.h"
#include "core/lattice/neighbours.h"
#include "core/surface/corrections.h"

namespace ddt {

namespace {

/// The part of a tile's lattice whose edges are sampled: triangles of its cells reach into the
/// halo.
Rect sampled_part(const Lattice& lattice, const Tile& tile) {
    const Rect &c = tile.cells, &p = tile.pixels;
    const Rect sampled{c.x0 - p.x0, c.y0 - p.y0, c.x1 + 1 - p.x0, c.y1 + 1 - p.y0};
    return with_neighbours(lattice, clipped_to(lattice, sampled));
}

} // namespace

size_t TileMesh::memory(int width, int height) {
    const size_t pixels = size_t(width) * size_t(height), sites = 4 * pixels;
    return sites * sizeof(Site) + pixels * sizeof(Division);
}

void TileMesh::triangulate(const Job& job, const float* guide, int width, int height,
                           Workspace& workspace, Statistics& statistics) {
    const DenormalsAreZero as_on_gpus;
    start(m_lattice, width, height, guide, job.mesh);
    ddt::triangulate(m_lattice, job.mesh, workspace, statistics);
    if (wants_gains(job.surface) && job.mesh.scheme != Scheme::one_round)
        find_all_gains(m_lattice, criterion(job.mesh));
}

Rect TileMesh::sampled(const Tile& part) const {
    return part.cells == m_cells ? m_sampled : sampled_part(m_lattice, part);
}

void TileMesh::find_cells(const Job& job, const Tile& tile) {
    const SurfaceOptions& surface = job.surface;
    // Rounds see further than the part that is sampled.
    const bool all = is_corrected(surface) || is_fitted(surface);
    m_cells = tile.cells;
    m_sampled = sampled_part(m_lattice, tile);
    const Rect seen = all ? m_lattice.all() : m_sampled;
    m_lattice.find_divisions(seen);
    if (surface.kind != Surface::linear)
        m_lattice.find_walked_first_edges(seen);
}

} // namespace ddt
