// SPDX-License-Identifier: Apache-2.0
#include "tests/core/gl/stages/cpu_stages.h"

#include "core/base/arith.h"
#include "core/surface/consistency.h"
#include "core/surface/edge_maker.h"
#include "core/tiles/tile_io.h"
#include "core/triangulate/triangulate.h"

namespace ddt::test {

namespace {

/// A finished mesh with its gains in w.gain.
void make_mesh(const std::vector<float>& guide, int width, int height, const MeshOptions& options,
               Lattice& lattice, Workspace& w) {
    Statistics statistics;
    start(lattice, width, height, guide.data(), options);
    triangulate(lattice, options, w, statistics);
    find_gains(lattice, criterion(options), w);
}

} // namespace

MeshStage cpu_mesh(const std::vector<float>& guide, int width, int height,
                   const MeshOptions& options, int iterations) {
    const DenormalsAreZero as_on_gpus;
    MeshOptions some = options;
    some.max_iterations = iterations;
    Lattice lattice;
    Workspace w;
    make_mesh(guide, width, height, some, lattice, w);
    w.gain.resize(lattice.size());
    return {{lattice.sites(), lattice.sites() + lattice.size()}, w.gain, lattice.stride()};
}

SurfaceStage cpu_surface(const std::vector<float>& guide, const std::vector<float>& values,
                         int width, int height, const Job& job, int rounds) {
    const DenormalsAreZero as_on_gpus;
    const SurfaceOptions& surface = job.surface;
    Lattice lattice;
    Workspace w;
    make_mesh(guide, width, height, job.mesh, lattice, w);
    lattice.find_divisions(lattice.all());
    lattice.find_first_edges(lattice.all());
    Net net;
    set_vertices(lattice, values.data(), job.channels, 0, channels_in_group(job.channels, 0), net);
    for (int c = 0; c < group_size; ++c)
        net.strict[c] = is_strict(job, c) ? 1.0f : 0.0f;
    const bool bend = surface.kind != Surface::linear;
    const float* gain = surface.soft > 0 ? w.gain.data() : nullptr;
    EdgeMaker edges;
    const auto make_edges = [&] {
        edges.begin(lattice, {0, 0, width, height}, bend, gain, surface.soft, net);
        edges.finish();
    };
    Consistency consistency;
    consistency.begin(lattice, net, surface.limit, surface.clipped);
    for (int i = 0; i < rounds; ++i) {
        make_edges();
        consistency.correct(lattice, surface.kind, net);
    }
    make_edges();

    // As devices have them: group_size numbers each, those that are no channel's 0.
    SurfaceStage stage;
    const auto append = [&](const float* numbers, std::vector<float>& to) {
        to.insert(to.end(), numbers, numbers + net.count());
        to.resize(to.size() + size_t(group_size - net.count()));
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int s = lattice.vertex_site(x, y);
            append(net.vertex(s), stage.vertices);
            if (!bend)
                continue;
            append(edges.gradients().at(s), stage.gradients);
            append(edges.gradients().at(s + lattice.stride()), stage.gradients);
        }
    for (int s = 0; s < int(lattice.size()); ++s) {
        if (bend)
            append(net.at(s), stage.bends);
        if (gain)
            append(net.soft_at(s), stage.softness);
    }
    return stage;
}

} // namespace ddt::test
