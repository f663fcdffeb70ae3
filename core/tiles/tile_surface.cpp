// SPDX-License-Identifier: Apache-2.0
#include "core/tiles/tile_surface.h"

#include <algorithm>

#include "core/base/float_mode.h"
#include "core/lattice/row_reach.h"
#include "core/sample/bound_alpha.h"
#include "core/surface/corrections.h"
#include "core/surface/kept_rows.h"
#include "core/tiles/channel_groups.h"

namespace ddt {

namespace {

EdgeRecipe recipe_of(const SurfaceOptions& surface, FanRows* fans, Arena* arena, int cells) {
    return {surface.kind != Surface::linear,
            surface.soft > 0,
            surface.soft,
            fans,
            arena,
            cells,
            false,
            bounds_of(surface)};
}

/// Rows of fans that are worth keeping because they are asked for again: by later rounds of
/// corrections, or by other groups of channels, each of which asks for `cells` rows of cells at
/// once. ahead: CorrectedRows::rows_ahead(), if there are rounds.
int fan_rows(int ahead, size_t groups, int cells) {
    return ahead > 0 ? ahead : groups > 1 ? 4 * rows_at_once + cells - 1 : 1;
}

} // namespace

TileSurface::TileSurface(const Job& job, const Mapping& mapping)
    : m_job(job), m_correction{job.surface.limit, job.surface.clipped,
                               correction_strength(mapping.scale())},
      m_bounded(bounded_channels(job)), m_nets(size_t(group_count(job.channels))) {
    if (is_fitted(job.surface))
        m_fitted.resize(m_nets.size());
    else
        m_edges.resize(m_nets.size());
}

MemoryNeeded TileSurface::memory(const Job& job, int width, int height, int cells) {
    const EdgeRecipe recipe = recipe_of(job.surface, nullptr, nullptr, cells);
    const EdgeRecipe row_by_row = recipe_of(job.surface, nullptr, nullptr, 1);
    const int groups = group_count(job.channels);
    MemoryNeeded needed;
    for (int g = 0; g < groups; ++g) {
        const int count = channels_in_group(job.channels, g);
        needed =
            needed + (is_fitted(job.surface)
                          ? FittedMaker::memory(width, height, {nullptr, job.channels, 0, count},
                                                job.surface.soft > 0, cells)
                          : EdgeMaker::memory(width, height, count, recipe));
    }
    if (is_corrected(job.surface)) {
        const MemoryNeeded rounds =
            CorrectedRows::memory(width, height, channels_in_group(job.channels, 0),
                                  {job.surface.kind, row_by_row, job.surface.consistency});
        if (groups == 1)
            needed = needed + rounds;
        else
            needed.other += rounds.all() +
                            size_t(width) * size_t(height) * sizeof(float) * size_t(job.channels);
    }
    // Of a row of cells that are all crossed.
    needed.other += size_t(width) * (sizeof(LocatedBlock::Range) +
                                     usual_crossing_triangles * sizeof(CrossingTriangle)) +
                    CrossedRows::memory(width, 1);
    const int ahead =
        is_corrected(job.surface) ? CorrectedRows::usual_rows_ahead(job.surface.consistency) : 0;
    needed.other +=
        FanRows::memory(width, std::min(fan_rows(ahead, size_t(groups), cells), height));
    return needed;
}

void TileSurface::begin(const TileMesh& mesh, const Tile& tile, int cells, const float* values,
                        Arena& arena) {
    const DenormalsAreZero as_on_gpus;
    const SurfaceOptions& surface = m_job.surface;
    m_mesh = &mesh;
    m_values = values;
    m_arena = &arena;
    const Rect part = mesh.sampled(tile);
    if (is_corrected(surface) && m_nets.size() > 1)
        take_memory(m_corrected, mesh.lattice().vertices() * size_t(m_job.channels));
    const int ahead =
        is_corrected(surface) ? CorrectedRows::rows_ahead(mesh.lattice(), surface.consistency) : 0;
    m_fans.begin(mesh.lattice(), fan_rows(ahead, m_nets.size(), cells));
    for (int g = 0; g < int(m_nets.size()); ++g) {
        ControlNet& net = m_nets[size_t(g)];
        if (is_fitted(surface)) {
            begin_fitted(g, values, part, cells);
            continue;
        }
        if (is_corrected(surface))
            begin_corrected(g, values, part, cells);
        else
            m_edges[size_t(g)].begin_rows(mesh.lattice(), part, recipe(cells),
                                          group_values(values, g), net);
    }
    m_search.begin();
}

GroupValues TileSurface::group_values(const float* values, int group) const {
    return {values, m_job.channels, group * group_size, channels_in_group(m_job.channels, group)};
}

GroupOutput TileSurface::group_output(int group, float* out, size_t row) const {
    return {out, row, m_job.channels, group * group_size, channels_in_group(m_job.channels, group)};
}

EdgeRecipe TileSurface::recipe(int cells) {
    return recipe_of(m_job.surface, &m_fans, m_arena, cells);
}

void TileSurface::begin_corrected(int group, const float* values, const Rect& part, int cells) {
    const SurfaceOptions& surface = m_job.surface;
    CorrectionRecipe correction{surface.kind, recipe(1), surface.consistency, m_correction,
                                nearest_mask(m_job, group)};
    // Of many channels one group after the other, in the same memory.
    const bool alone = m_nets.size() == 1;
    if (!alone)
        correction.edges.arena = nullptr;
    ControlNet& net = m_nets[size_t(group)];
    EdgeMaker& edges = m_edges[size_t(group)];
    const Lattice& lattice = m_mesh->lattice();
    m_rounds.begin(lattice, part, correction, group_values(values, group));
    if (alone)
        return edges.begin_rows(lattice, part, recipe(cells), m_rounds, net);
    correct_for(part, group);
    edges.begin_rows(lattice, part, recipe(cells), group_values(m_corrected.data(), group), net);
}

/// Correct what edges in this part are made from. All of a tile, which is copied beside that, was a
/// fifth of the work where three threads shared it.
void TileSurface::correct_for(const Rect& part, int group) {
    const Lattice& lattice = m_mesh->lattice();
    RowReach reach;
    reach.find(lattice);
    const int begin = reach.first_neighbour(part.y0);
    const int end = reach.last_neighbour(reach.last_end(part.y1 - 1)) + 1;
    const GroupValues to = group_values(m_corrected.data(), group);
    float* p = m_corrected.data() + to.first +
               size_t(begin) * size_t(lattice.width()) * size_t(to.channels);
    for (int y = begin; y < end; ++y) {
        const float* row = m_rounds.row(y);
        for (int x = 0; x < lattice.width(); ++x, row += to.count, p += to.channels)
            std::copy_n(row, to.count, p);
    }
}

void TileSurface::begin_fitted(int group, const float* values, const Rect& part, int cells) {
    const SurfaceOptions& surface = m_job.surface;
    const FittedRecipe recipe{
        surface.soft, bounds_of(surface), m_correction, nearest_mask(m_job, group), m_arena, cells};
    m_fitted[size_t(group)].begin(m_mesh->lattice(), part, recipe, group_values(values, group),
                                  m_nets[size_t(group)]);
}

void TileSurface::make_edges_for(int32_t y, int32_t keep) {
    const DenormalsAreZero as_on_gpus;
    const int cells = y >> position_bits, from = keep >> position_bits;
    for (EdgeMaker& edges : m_edges)
        edges.to_cells(cells, from);
    for (FittedMaker& fitted : m_fitted)
        fitted.to_cells(cells, from);
}

void TileSurface::sample(const Point* points, int n, float* out) {
    const DenormalsAreZero as_on_gpus;
    locate_row(m_mesh->lattice(), points, n, m_search, m_row);
    for (int g = 0; g < int(m_nets.size()); ++g)
        evaluate_row(m_nets[size_t(g)], m_job.surface.kind, nearest_mask(m_job, g), m_row,
                     group_output(g, out, 0));
    for (const int c : m_bounded)
        for (int i = 0; i < n; ++i)
            bound(c, points[i], out + ptrdiff_t(i) * m_job.channels);
}

int TileSurface::sample_block(const Columns& columns, std::vector<Point>& points, const int32_t* y,
                              int n, float* out, size_t row) {
    const DenormalsAreZero as_on_gpus;
    const int rows = locate_block(m_mesh->lattice(), columns, points, y, n, m_search, m_block);
    for (int g = 0; g < int(m_nets.size()); ++g)
        evaluate_block(m_nets[size_t(g)], m_job.surface.kind, columns, m_block,
                       group_output(g, out, row));
    for (const int c : m_bounded)
        for (int r = 0; r < rows; ++r)
            for (int i = 0; i < columns.count; ++i)
                bound(c, {points[size_t(i)].x, y[r]},
                      out + size_t(r) * row + size_t(i) * size_t(m_job.channels));
    return rows;
}

/// What was made of a channel at a position.
void TileSurface::bound(int channel, Point p, float* pixel) const {
    const Lattice& lattice = m_mesh->lattice();
    const ChannelPixels source{m_values + channel, m_job.channels, lattice.width(),
                               lattice.height()};
    pixel[channel] = bound_alpha(pixel[channel], source, p);
}

} // namespace ddt
