// SPDX-License-Identifier: Apache-2.0
#include "core/tiles/tile_worker.h"

#include <algorithm>

#include "core/guide/guide.h"
#include "core/tiles/tile_io.h"

namespace ddt {

namespace {

/// Of a mesh of the largest tile.
SchemeMemory mesh_memory(const Job& job) {
    return scheme_memory(job.mesh.scheme, largest_pixels(job));
}

/// The guide of a mesh; to be called in ascending order.
const float* guide_of(size_t mesh, const Job& job, TileMemory& memory) {
    const float share = blur_share(job.mesh, int(mesh));
    const MeshedTile& meshed = memory.meshed;
    const bool last = mesh + 1 == meshed.meshes.size();
    if (!last)
        memory.blurred = memory.guide;
    float* const guide =
        last ? memory.guide_place(meshed.width, meshed.height) : memory.blurred.data();
    if (share > 0)
        blur_guide(guide, meshed.width, meshed.height, share);
    return guide;
}

} // namespace

size_t TileWorker::memory(const Job& job, const Mapping& mapping) {
    const MemoryNeeded needed =
        TileWriter::memory(job, mapping, largest_width(job), largest_height(job));
    const SchemeMemory mesh = mesh_memory(job);
    return needed.other + std::max(mesh.lists + mesh.other, needed.rows);
}

Outcome TileWorker::work(const Tile& tile, int first_row) {
    const KeptMemory memory;
    const Outcome begun = begin(tile, 0, first_row, *memory);
    return begun == Outcome::done ? finish() : begun;
}

Outcome TileWorker::begin(const Tile& tile, int index, int first_row, TileMemory& memory) {
    Rect reach = reach_of(tile, m_job.window, m_mapping);
    reach.y0 = std::max(reach.y0, first_row);
    MeshedTile& meshed = memory.meshed;
    m_left.begin(meshed, {}, false, 0);
    if (reach.empty())
        return Outcome::done;
    memory.reserve(m_job);
    m_clock.start();
    if (!read(tile, memory))
        return Outcome::source_failed;
    triangulate(tile, memory);
    meshed.index = index;
    meshed.output = reach;
    const bool grid = m_writer.is_grid(tile, reach);
    const Rect& rows = grid ? reach : tile.cells;
    m_left.begin(meshed, rows, grid, TileWriter::least_shared_rows(rows.height(), reach));
    m_clock.lap(m_statistics.times.sample);
    return Outcome::done;
}

Outcome TileWorker::finish() {
    return m_left.all().empty() ? Outcome::done : m_writer.write(m_left);
}

bool TileWorker::read(const Tile& tile, TileMemory& memory) {
    MeshedTile& meshed = memory.meshed;
    meshed.tile = tile;
    const int width = lattice_width(tile), height = lattice_height(tile);
    meshed.values.resize(size_t(width) * size_t(height) * size_t(m_job.channels) + group_size);
    if (!read_tile(m_source, tile, m_job, meshed.values.data(), memory.guide_place(width, height),
                   meshed.width, meshed.height))
        return false;
    m_clock.lap(m_statistics.times.read);
    return true;
}

void TileWorker::triangulate(const Tile& tile, TileMemory& memory) {
    MeshedTile& meshed = memory.meshed;
    m_arena.clear();
    m_arena.reserve(mesh_memory(m_job).lists);
    Workspace workspace(m_arena);
    workspace.origin_x = tile.pixels.x0 - m_job.window.x0;
    workspace.origin_y = tile.pixels.y0 - m_job.window.y0;
    for (size_t k = 0; k < meshed.meshes.size(); ++k) {
        TileMesh& mesh = meshed.meshes[k];
        mesh.triangulate(m_job, guide_of(k, m_job, memory), meshed.width, meshed.height, workspace,
                         m_statistics);
        m_clock.lap(m_statistics.times.triangulate);
        mesh.find_cells(m_job, tile);
        m_clock.lap(m_statistics.times.surface);
    }
}

} // namespace ddt
