// SPDX-License-Identifier: Apache-2.0
#include "core/tiles/tile_mesh.h"

#include <algorithm>

#include "core/base/arith.h"
#include "core/base/large_pages.h"
#include "core/tiles/tile_io.h"

namespace ddt {

namespace {

/// Whether the surface depends on the finished mesh's gains.
bool wants_gains(const SurfaceOptions& surface) {
    return surface.soft > 0 || is_fitted(surface);
}

} // namespace

size_t TileMesh::memory(const Job& job, size_t sites) {
    const size_t lattice = sites * sizeof(Site) + sites / 4 * sizeof(Division);
    const size_t nets = sites * sizeof(float) * group_size * size_t(group_count(job.channels));
    const size_t soft = job.surface.soft > 0 ? nets : 0;
    const size_t gains = wants_gains(job.surface) ? sites * sizeof(float) : 0;
    const size_t gradients =
        job.surface.kind == Surface::linear ? 0 : sites * sizeof(float) * group_size / 2;
    return lattice + nets + soft + gains + gradients;
}

void TileMesh::reserve(size_t sites) {
    m_lattice.reserve(sites);
    m_nets.resize(size_t(group_count(m_job.channels)));
    for (Net& net : m_nets)
        reserve_large(net.values, sites * group_size);
    if (wants_gains(m_job.surface))
        m_gain.reserve(sites);
    if (m_job.surface.soft > 0)
        for (Net& net : m_nets)
            reserve_large(net.soft, sites * group_size);
    if (m_job.surface.kind != Surface::linear)
        m_edges.reserve(sites);
}

void TileMesh::triangulate(const float* guide, int width, int height, MeshScratch& scratch,
                           Statistics& statistics) {
    const DenormalsAreZero as_on_gpus;
    start(m_lattice, width, height, guide, m_job.mesh);
    ddt::triangulate(m_lattice, m_job.mesh, scratch.workspace, statistics);
    if (!wants_gains(m_job.surface))
        return;
    if (m_job.mesh.scheme != Scheme::one_round)
        find_gains(m_lattice, criterion(m_job.mesh), scratch.workspace);
    m_gain.swap(scratch.workspace.gain);
}

void TileMesh::make_surface(const Tile& tile, const float* values, MeshScratch& scratch) {
    const DenormalsAreZero as_on_gpus;
    const SurfaceOptions& surface = m_job.surface;
    m_lattice.find_divisions();
    if (surface.kind != Surface::linear)
        m_lattice.find_first_edges();

    const Rect part = sampled_part(tile);
    for (int g = 0; g < int(m_nets.size()); ++g) {
        Net& net = m_nets[size_t(g)];
        set_vertices(m_lattice, values, m_job.channels, g * group_size,
                     channels_in_group(m_job.channels, g), net);
        for (int c = 0; c < group_size; ++c)
            net.strict[c] = is_strict(m_job, g * group_size + c) ? 1.0f : 0.0f;
        if (is_fitted(surface))
            fit(g, part, scratch);
        else if (surface.consistency > 0)
            correct(g, scratch);
    }
    for (Net& net : m_nets) {
        if (is_fitted(surface))
            begin_softness(net, part);
        else
            begin_edges(net, part);
        // Several nets would want as many EdgeMakers.
        if (!edges_wait())
            m_edges.finish();
    }
    m_search.begin();
}

Rect TileMesh::sampled_part(const Tile& tile) const {
    const Rect &c = tile.cells, &p = tile.pixels;
    const int far = m_lattice.longest();
    return {std::max(c.x0 - far - p.x0, 0), std::max(c.y0 - far - p.y0, 0),
            std::min(c.x1 + 1 + far - p.x0, m_lattice.width()),
            std::min(c.y1 + 1 + far - p.y0, m_lattice.height())};
}

void TileMesh::correct(int group, MeshScratch& scratch) {
    const SurfaceOptions& surface = m_job.surface;
    Net& net = m_nets[size_t(group)];
    scratch.consistency.begin(m_lattice, net, surface.limit, surface.clipped);
    for (int round = 0; round < surface.consistency; ++round) {
        begin_edges(net, {0, 0, m_lattice.width(), m_lattice.height()});
        m_edges.finish();
        scratch.consistency.correct(m_lattice, surface.kind, net);
    }
    scratch.consistency.restore(m_lattice, nearest_mask(m_job, group), net);
}

void TileMesh::fit(int group, const Rect& part, MeshScratch& scratch) {
    const SurfaceOptions& surface = m_job.surface;
    Consistency& consistency = scratch.consistency;
    Net& net = m_nets[size_t(group)];
    consistency.begin(m_lattice, net, surface.limit, surface.clipped);
    begin_edges(net, {0, 0, m_lattice.width(), m_lattice.height()});
    m_edges.finish();
    consistency.measure(m_lattice, surface.kind, net);
    scratch.fitted.move_vertices(m_lattice, consistency, net);
    consistency.restore(m_lattice, nearest_mask(m_job, group), net);
    scratch.fitted.bend_edges(m_lattice, part, m_gain.data(), consistency, net);
}

void TileMesh::begin_edges(Net& net, const Rect& part) {
    const SurfaceOptions& surface = m_job.surface;
    m_edges.begin(m_lattice, part, surface.kind != Surface::linear,
                  surface.soft > 0 ? m_gain.data() : nullptr, surface.soft, net);
}

/// As begin_edges(), where edges are bent already.
void TileMesh::begin_softness(Net& net, const Rect& part) {
    const SurfaceOptions& surface = m_job.surface;
    m_edges.begin(m_lattice, part, false, surface.soft > 0 ? m_gain.data() : nullptr, surface.soft,
                  net);
}

void TileMesh::make_edges_for(int32_t y) {
    const DenormalsAreZero as_on_gpus;
    m_edges.to_row((y >> position_bits) + m_lattice.longest());
}

void TileMesh::finish_edges() {
    const DenormalsAreZero as_on_gpus;
    m_edges.finish();
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
