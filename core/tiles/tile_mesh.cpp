// SPDX-License-Identifier: Apache-2.0
#include "core/tiles/tile_mesh.h"

#include <algorithm>

#include "core/base/arith.h"
#include "core/lattice/neighbours.h"
#include "core/surface/kept_rows.h"
#include "core/tiles/tile_io.h"

namespace ddt {

namespace {

/// Whether vertices are corrected before edges are made.
bool is_corrected(const SurfaceOptions& surface) {
    return surface.consistency > 0 && !is_fitted(surface);
}

/// A recipe that takes the memory of the surface's.
EdgeRecipe recipe_of(const SurfaceOptions& surface) {
    static const float some_gain = 0;
    return {surface.kind != Surface::linear, surface.soft > 0 ? &some_gain : nullptr, surface.soft};
}

} // namespace

bool wants_gains(const SurfaceOptions& surface) {
    return surface.soft > 0 || is_fitted(surface);
}

size_t TileMesh::memory(const Job& job, int width, int height, bool rows) {
    const size_t pixels = size_t(width) * size_t(height), sites = 4 * pixels;
    const size_t lattice = sites * sizeof(Site) + pixels * sizeof(Division);
    const size_t gains = wants_gains(job.surface) ? sites * sizeof(float) : 0;
    const EdgeRecipe recipe = recipe_of(job.surface);
    const size_t kept =
        is_fitted(job.surface)
            ? FittedMaker::memory(width, height, !rows, job.channels, job.surface.soft > 0)
            : EdgeMaker::memory(width, height, rows ? usual_longest : height, job.channels, recipe);
    size_t corrected = 0, rounds = 0;
    if (is_corrected(job.surface)) {
        if (job.mesh.meshes > 1)
            corrected = pixels * sizeof(float) * size_t(job.channels);
        rounds = CorrectedRows::memory(width, height, job.channels,
                                       {job.surface.kind, recipe, job.surface.consistency});
    }
    return lattice + gains + kept * size_t(group_count(job.channels)) + rounds + corrected;
}

void TileMesh::reserve(size_t sites) {
    m_lattice.reserve(sites);
    m_nets.resize(size_t(group_count(m_job.channels)));
    if (is_fitted(m_job.surface))
        m_fitted.resize(m_nets.size());
    else
        m_edges.resize(m_nets.size());
}

void TileMesh::triangulate(const float* guide, int width, int height, Workspace& workspace,
                           Statistics& statistics) {
    const DenormalsAreZero as_on_gpus;
    // The memory of the gains that were kept is that of the next.
    if (wants_gains(m_job.surface) && m_gain.capacity() > workspace.gain.capacity())
        m_gain.swap(workspace.gain);
    start(m_lattice, width, height, guide, m_job.mesh);
    ddt::triangulate(m_lattice, m_job.mesh, workspace, statistics);
    if (!wants_gains(m_job.surface))
        return;
    if (m_job.mesh.scheme != Scheme::one_round)
        find_gains(m_lattice, criterion(m_job.mesh), workspace);
    m_gain.swap(workspace.gain);
}

void TileMesh::make_surface(const Tile& tile, float* values, bool own) {
    const DenormalsAreZero as_on_gpus;
    const SurfaceOptions& surface = m_job.surface;
    const Rect part = sampled_part(tile);
    // Rounds see further than the part.
    const Rect seen = is_corrected(surface) || is_fitted(surface) ? m_lattice.all() : part;
    m_lattice.find_divisions(seen);
    if (surface.kind != Surface::linear)
        m_lattice.find_first_edges(seen);

    float* const corrected = is_corrected(surface) ? place_for_corrected(values, own) : values;
    for (int g = 0; g < int(m_nets.size()); ++g) {
        Net& net = m_nets[size_t(g)];
        set_strictness(g, net);
        if (is_fitted(surface)) {
            begin_fitted(g, values, part);
            continue;
        }
        if (is_corrected(surface))
            begin_corrected(g, corrected, part);
        m_edges[size_t(g)].begin_rows(m_lattice, part, recipe(), group_values(corrected, g), net);
    }
    m_search.begin();
}

GroupValues TileMesh::group_values(const float* values, int group) const {
    return {values, m_job.channels, group * group_size, channels_in_group(m_job.channels, group)};
}

EdgeRecipe TileMesh::recipe() const {
    const SurfaceOptions& surface = m_job.surface;
    return {surface.kind != Surface::linear, surface.soft > 0 ? m_gain.data() : nullptr,
            surface.soft};
}

void TileMesh::set_strictness(int group, Net& net) const {
    for (int c = 0; c < group_size; ++c)
        net.strict[c] = is_strict(m_job, group * group_size + c) ? 1.0f : 0.0f;
}

float* TileMesh::place_for_corrected(float* values, bool own) {
    if (own)
        return values;
    m_corrected.assign(values, values + m_lattice.vertices() * size_t(m_job.channels));
    return m_corrected.data();
}

Rect TileMesh::sampled_part(const Tile& tile) const {
    const Rect &c = tile.cells, &p = tile.pixels;
    const Rect sampled{c.x0 - p.x0, c.y0 - p.y0, c.x1 + 1 - p.x0, c.y1 + 1 - p.y0};
    return with_neighbours(m_lattice, grown(m_lattice, sampled, 0));
}

void TileMesh::begin_corrected(int group, float* values, const Rect& part) {
    const SurfaceOptions& surface = m_job.surface;
    const CorrectionRecipe correction{surface.kind,  recipe(),        surface.consistency,
                                      surface.limit, surface.clipped, nearest_mask(m_job, group)};
    m_rounds.begin(m_lattice, part, correction, group_values(values, group), values,
                   m_nets[size_t(group)].strict);
    // Of many channels one group after the other, in the same memory; else as rows are needed.
    if (m_nets.size() > 1)
        m_rounds.to_row(m_lattice.height());
}

void TileMesh::begin_fitted(int group, const float* values, const Rect& part) {
    const SurfaceOptions& surface = m_job.surface;
    const FittedRecipe recipe{m_gain.data(), surface.soft, surface.limit, surface.clipped,
                              nearest_mask(m_job, group)};
    m_fitted[size_t(group)].begin(m_lattice, part, recipe, group_values(values, group),
                                  m_nets[size_t(group)]);
}

void TileMesh::make_edges_for(int32_t y, int32_t keep) {
    const DenormalsAreZero as_on_gpus;
    const int to = (y >> position_bits) + m_lattice.longest(), from = keep >> position_bits;
    for (EdgeMaker& edges : m_edges) {
        if (is_corrected(m_job.surface))
            m_rounds.to_row(edges.values_end(to));
        edges.to_row(to, from);
    }
    for (FittedMaker& fitted : m_fitted)
        fitted.to_row(to, from);
}

void TileMesh::finish_edges() {
    const DenormalsAreZero as_on_gpus;
    if (is_corrected(m_job.surface))
        m_rounds.to_row(m_lattice.height());
    for (EdgeMaker& edges : m_edges)
        edges.finish();
    for (FittedMaker& fitted : m_fitted)
        fitted.finish();
}

void TileMesh::sample(const Point* points, int n, float* out) {
    const DenormalsAreZero as_on_gpus;
    locate_row(m_lattice, points, n, m_search, m_row);
    for (int g = 0; g < int(m_nets.size()); ++g)
        evaluate_row(m_nets[size_t(g)], m_job.surface.kind, nearest_mask(m_job, g), m_row,
                     m_job.channels, g * group_size, channels_in_group(m_job.channels, g), out);
}

int TileMesh::sample_block(const Columns& columns, std::vector<Point>& points, const int32_t* y,
                           int n, float* out, size_t row) {
    const DenormalsAreZero as_on_gpus;
    const int rows = locate_block(m_lattice, columns, points, y, n, m_search, m_block);
    for (int g = 0; g < int(m_nets.size()); ++g)
        evaluate_block(m_nets[size_t(g)], m_job.surface.kind, columns, m_block, m_job.channels,
                       g * group_size, channels_in_group(m_job.channels, g), out, row);
    return rows;
}

} // namespace ddt
