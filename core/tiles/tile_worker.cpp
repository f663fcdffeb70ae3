// SPDX-License-Identifier: Apache-2.0
#include "core/tiles/tile_worker.h"

#include <algorithm>

#include "core/guide/contour.h"
#include "core/guide/guide.h"
#include "core/tiles/tile_io.h"
#include "core/triangulate/start_gains.h"

namespace ddt {

namespace {

/// Pixels of the largest tile along an axis of a window; a lattice has at least 2.
int largest_tile(int pixels) {
    return std::clamp(pixels, 2, tile_size + 1 + 2 * tile_halo);
}

} // namespace

size_t TileWorker::memory(const Job& job, bool separable) {
    const int width = largest_tile(job.window.width()), height = largest_tile(job.window.height());
    const size_t pixels = size_t(width) * size_t(height), sites = 4 * pixels;
    const size_t meshes = size_t(job.mesh.meshes) * TileMesh::memory(job, width, height);
    // Gains, where no mesh keeps them, and work lists, which are longest in noise.
    const size_t workspace = (wants_gains(job.surface) ? 0 : sites * sizeof(float)) + pixels * 10 +
                             start_gains_memory(width);
    const size_t guides = job.mesh.meshes > 1 ? 2 : 1;
    const size_t planes = pixels * sizeof(float) * (guides + size_t(job.channels));
    return meshes + workspace + planes + ContourRows::memory(width) +
           TileWriter::memory(job, width, height, separable);
}

void TileWorker::reserve() {
    const size_t pixels =
        size_t(largest_tile(m_job.window.width())) * size_t(largest_tile(m_job.window.height()));
    const size_t sites = 4 * pixels;
    m_memory->meshed.values.reserve(pixels * size_t(m_job.channels) + group_size);
    m_memory->guide.reserve(pixels);
    m_memory->meshed.meshes.resize(size_t(m_job.mesh.meshes));
    m_memory->meshed.meshes[0].give_gain(m_memory->workspace);
    m_memory->workspace.gain.reserve(sites);
    for (TileMesh& mesh : m_memory->meshed.meshes)
        mesh.reserve(sites);
    m_reserved = true;
}

Outcome TileWorker::work(const Tile& tile, int first_row) {
    const Outcome begun = begin(tile, first_row);
    return begun == Outcome::done ? finish() : begun;
}

Outcome TileWorker::begin(const Tile& tile, int first_row) {
    Rect reach = reach_of(tile, m_job.window, m_mapping);
    reach.y0 = std::max(reach.y0, first_row);
    MeshedTile& meshed = m_memory->meshed;
    m_left.begin(meshed, {}, false, 0);
    if (reach.empty())
        return Outcome::done;
    if (!m_reserved)
        reserve();
    StageTimes& times = m_statistics.times;
    m_clock.start();
    if (!read(tile))
        return Outcome::source_failed;
    m_clock.lap(times.read);
    for (size_t k = 0; k < meshed.meshes.size(); ++k) {
        TileMesh& mesh = meshed.meshes[k];
        mesh.triangulate(m_job, guide_of(k), meshed.width, meshed.height, m_memory->workspace,
                         m_statistics);
        m_clock.lap(times.triangulate);
        mesh.find_cells(m_job, tile);
        m_clock.lap(times.surface);
    }
    // Where positions come in any order all of a tile's surface is made before any of it is
    // sampled.
    const bool grid = m_writer.is_grid(tile, reach);
    m_left.begin(meshed, reach, grid, grid ? TileWriter::least_shared_rows(reach) : 0);
    m_clock.lap(times.sample);
    return Outcome::done;
}

Outcome TileWorker::finish() {
    return m_left.pixels().empty() ? Outcome::done : m_writer.write(m_left);
}

bool TileWorker::read(const Tile& tile) {
    Workspace& workspace = m_memory->workspace;
    workspace.origin_x = tile.pixels.x0 - m_job.window.x0;
    workspace.origin_y = tile.pixels.y0 - m_job.window.y0;
    MeshedTile& meshed = m_memory->meshed;
    meshed.tile = tile;
    if (!read_tile(m_source, tile, m_job, meshed.values, m_memory->guide, meshed.width,
                   meshed.height))
        return false;
    meshed.values.resize(meshed.values.size() + group_size);
    return true;
}

const float* TileWorker::guide_of(size_t mesh) {
    const float share = blur_share(m_job.mesh, int(mesh));
    const MeshedTile& meshed = m_memory->meshed;
    const bool last = mesh + 1 == meshed.meshes.size();
    if (!last)
        m_memory->blurred = m_memory->guide;
    std::vector<float>& guide = last ? m_memory->guide : m_memory->blurred;
    if (share > 0)
        blur_guide(guide, meshed.width, meshed.height, share);
    return guide.data();
}

} // namespace ddt
