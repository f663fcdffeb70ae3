// SPDX-License-Identifier: Apache-2.0
#include "tests/core/gl/stages/cpu_stages.h"

#include "core/base/float_mode.h"
#include "core/surface/corrections.h"
#include "core/tiles/channel_groups.h"
#include "core/tiles/tile_io.h"
#include "core/triangulate/triangulate.h"
#include "tests/core/surface/consistency/whole_rounds.h"
#include "tests/core/surface/whole_net.h"

namespace ddt::test {

namespace {

/// A finished mesh with its gains.
void make_mesh(const std::vector<float>& guide, int width, int height, const MeshOptions& options,
               Lattice& lattice) {
    Statistics statistics;
    Workspace w;
    start(lattice, width, height, guide.data(), options);
    triangulate(lattice, options, w, statistics);
    find_all_gains(lattice, criterion(options));
}

} // namespace

MeshStage cpu_mesh(const std::vector<float>& guide, int width, int height,
                   const MeshOptions& options, int iterations) {
    const DenormalsAreZero as_on_gpus;
    MeshOptions some = options;
    some.max_iterations = iterations;
    Lattice lattice;
    make_mesh(guide, width, height, some, lattice);
    MeshStage stage{std::vector<uint64_t>(lattice.size()), std::vector<float>(lattice.size()),
                    lattice.stride()};
    lattice.each_edge([&](int m) {
        stage.sites[size_t(m)] = vectors_of(lattice.edge(m));
        stage.gains[size_t(m)] = lattice.gain(m);
    });
    return stage;
}

SurfaceStage cpu_surface(const std::vector<float>& guide, const std::vector<float>& values,
                         int width, int height, const Job& job, int rounds) {
    const DenormalsAreZero as_on_gpus;
    const SurfaceOptions& surface = job.surface;
    Lattice lattice;
    make_mesh(guide, width, height, job.mesh, lattice);
    lattice.find_divisions(lattice.all());
    lattice.find_first_edges(lattice.all());
    ControlNet net;
    set_all_vertices(lattice, {values.data(), job.channels, 0, channels_in_group(job.channels, 0)},
                     net);
    net.bounds = bounds_of(surface);
    const bool bend = surface.kind != Surface::linear;
    const bool soft = surface.soft > 0;
    WholeEdges edges;
    const auto make_edges = [&] {
        edges.make(lattice, {0, 0, width, height}, bend, soft, surface.soft, net);
    };
    WholeRounds consistency;
    consistency.begin(lattice, net,
                      {surface.limit, surface.clipped, correction_strength(surface_scale)});
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
        if (soft)
            append(net.soft_at(s), stage.softness);
    }
    return stage;
}

} // namespace ddt::test
