// SPDX-License-Identifier: Apache-2.0
#include "core/gl/check/job_check.h"

#include <climits>
#include <cstring>
#include <memory>
#include <optional>

#include "core/base/arith.h"
#include "core/base/float_bits.h"
#include "core/base/float_mode.h"
#include "core/gl/budget.h"
#include "core/gl/check/checked_job.h"
#include "core/gl/check/difference.h"
#include "core/gl/gpu.h"
#include "core/gl/host_tile.h"
#include "core/gl/strip.h"
#include "core/guide/guide.h"
#include "core/surface/corrections.h"
#include "core/tiles/tile_io.h"
#include "core/tiles/tile_worker.h"
#include "core/triangulate/gain.h"
#include "core/triangulate/schemes.h"
#include "core/triangulate/triangulate.h"
#include "ddt/names.h"

namespace ddt::gl {

namespace {

/// Tiles on the device, all the same.
constexpr int copies = 2;

/// What is compared: of the first mesh its edges' vectors and gains, in the order of addresses, and
/// the job's result by Enlarged and by Turned.
struct Outcomes {
    std::vector<uint64_t> edges;
    Bits gains;
    CheckSink large, turned;
};

uint32_t bits_of_gain(float gain) {
    return bits_of(gain + 0.0f); // whatever a zero's sign
}

/// Call f with the site of each edge of a device's mesh, whose rows are `stride` long.
template <class F>
void each_edge(int stride, const F& f) {
    const int columns = 2 * checked_tile.pixels.width() - 1;
    const int rows = 2 * checked_tile.pixels.height() - 1;
    for (int y = 0; y < rows; ++y)
        for (int x = 1 - (y & 1), step = 2 - (y & 1); x < columns; x += step)
            f(size_t(y) * size_t(stride) + size_t(x));
}

CheckSink result_of(const Job& job, const Mapping& mapping) {
    CheckSource source(job.channels);
    CheckSink sink(reach_of(checked_tile, checked_window, mapping), job.channels);
    TileWorker(source, sink, mapping, job).work(checked_tile, INT_MIN);
    return sink;
}

Outcomes on_cpu(const Job& job) {
    Outcomes o{{}, {}, result_of(job, Enlarged()), result_of(job, Turned())};
    const Tile& tile = checked_tile;
    CheckSource source(job.channels);
    std::vector<float> values, guide;
    int w = 0, h = 0;
    read_tile(source, tile, job, values, guide, w, h);
    if (const float share = blur_share(job.mesh, 0); share > 0)
        blur_guide(guide.data(), w, h, share);
    {
        const DenormalsAreZero as_on_gpus;
        Lattice lattice;
        Workspace workspace;
        workspace.origin_x = tile.pixels.x0 - checked_window.x0;
        workspace.origin_y = tile.pixels.y0 - checked_window.y0;
        Statistics statistics;
        start(lattice, w, h, guide.data(), job.mesh);
        triangulate(lattice, job.mesh, workspace, statistics);
        find_all_gains(lattice, criterion(job.mesh));
        lattice.each_edge([&](int m) {
            o.edges.push_back(vectors_of(lattice.edge(m)));
            o.gains.push_back(bits_of_gain(lattice.gain(m)));
        });
    }
    return o;
}

/// What the device makes of the mesh in a slot, compared.
std::string mesh_differs(DeviceMesh& mesh, int slot, const Job& job, const Outcomes& cpu) {
    const SlotShape& shape = mesh.shape();
    std::vector<uint64_t> sites(shape.sites()), edges;
    mesh.read_sites(slot, sites.data());
    each_edge(shape.stride(), [&](size_t m) { edges.push_back(sites[m] & vectors_mask); });
    const std::string what = difference("edges", cpu.edges, edges);
    if (!what.empty())
        return what;
    mesh.find_gains(criterion(job.mesh));
    std::vector<float> of_sites(shape.sites());
    Bits gains;
    mesh.read_gains(slot, of_sites.data());
    each_edge(shape.stride(), [&](size_t m) { gains.push_back(bits_of_gain(of_sites[m])); });
    return difference("gains", cpu.gains, gains);
}

/// What the device shows of the tile in a slot, compared.
std::string result_differs(const Functions& gl, DeviceMesh& mesh, Surfaces& surfaces, int slot,
                           const Job& job, const Mapping& mapping, const CheckSink& cpu) {
    Strip strip;
    strip.rows = reach_of(checked_tile, checked_window, mapping);
    plan_strip(mapping, checked_tile, slot, strip);
    strip.plan.meshes = job.mesh.meshes;
    const size_t count = size_t(strip.plan.count) * size_t(job.channels);
    SampleMemory memory;
    HostBuffer results(gl, count * sizeof(float));
    surfaces.make_room(strip.positions.size(), count, Transfer(), memory);
    surfaces.write_positions(strip.positions, memory);
    surfaces.sample(mesh, strip.plan, memory);
    surfaces.download(count, Transfer(), memory, results);
    finish(gl, "self-check");
    Bits bits(count);
    std::memcpy(bits.data(), results.data(), count * sizeof(float));
    return difference("numbers", cpu.of(strip.runs), bits);
}

/// Do the job on the device; what differs first.
std::string differs(Gpu& gpu, const Job& job, const Outcomes& cpu) {
    const Functions& gl = gpu.context->gl;
    CheckSource source(job.channels);
    const SlotShape shape = shape_for(job.window);
    const int meshes = job.mesh.meshes, slots = copies * meshes, last = slots - meshes;
    HostTile t;
    t.tile = checked_tile;
    const Numbers numbers;
    t.memory = std::make_unique<HostBuffer>(gl, host_bytes(job, shape, numbers));
    ReadMemory memory;
    read(source, job, shape, numbers, t, memory);
    DeviceMesh mesh(gpu, shape, slots);
    mesh.finish_after(2, 2); // so that each of one_round's programs flips edges
    mesh.pause_after(2000);  // and accept_reject.comp goes on from where it was
    Surfaces surfaces(gpu, shape, slots, kinds_of(job), job.surface,
                      correction_strength(told_scale));
    surfaces.expect(numbers, job.channels, meshes);
    mesh.set_tiles(std::vector<TileSize>(size_t(slots), t.size));
    for (int slot = 0; slot < slots; slot += meshes)
        upload(t, job, slot, mesh, surfaces);
    unpack(job, mesh, surfaces);
    if (t.sites.empty())
        mesh.triangulate(job.mesh);
    // Programs that follow the edges of a spoilt mesh may not come to an end.
    for (const int slot : {0, last})
        if (const std::string what = mesh_differs(mesh, slot, job, cpu); !what.empty())
            return what;
    surfaces.make(mesh, criterion(job.mesh));
    const std::string what = result_differs(gl, mesh, surfaces, last, job, Enlarged(), cpu.large);
    return what.empty() ? result_differs(gl, mesh, surfaces, 0, job, Turned(), cpu.turned) : what;
}

/// Which branches of accept_reject.comp they take.
std::string key_of(const Rules& rules) {
    return std::string("accept_reject") + (rules.by_gain ? " by gain" : "") +
           (rules.wide_iterations == 0               ? ""
            : rules.wide_iterations >= Rules::always ? " wide"
                                                     : " wide at first");
}

std::string scheme_key_of(const MeshOptions& mesh) {
    const std::optional<Rules> rules = find_rules(mesh);
    return !DeviceMesh::knows(mesh)           ? "mesh of the CPU"
           : mesh.scheme == Scheme::pixel     ? "pixel"
           : rules                            ? key_of(*rules)
           : mesh.scheme == Scheme::annealing ? "annealing"
                                              : "one_round";
}

} // namespace

std::string job_differs_from_cpu(Gpu& gpu, const Job& wanted) {
    const Job job = job_to_check(wanted);
    return difference_of(gpu.context->renderer, job_key_of(wanted), differs(gpu, job, on_cpu(job)));
}

std::string job_key_of(const Job& job) {
    const MeshOptions& mesh = job.mesh;
    std::string key = scheme_key_of(mesh) + ' ' + cost_name(mesh.cost);
    key += mesh.start != Start::flat && DeviceMesh::knows(mesh) ? " diagonal" : "";
    key += mesh.max_iterations == 0 ? " still" : "";
    key += mesh.contour > 0 ? " contour" : "";
    key += job.surface.kind == Surface::linear ? " linear" : " patch";
    key += job.surface.soft > 0 ? " soft" : "";
    key += job.surface.consistency > 0 ? " consistency" : "";
    key += is_fitted(job.surface) ? " fitted" : "";
    key += job.surface.consistency > 0 && job.surface.clipped ? " clipped" : "";
    key += mesh.meshes > 1 ? " meshes" : "";
    return key + (job.channels % group_size == 0 ? " whole groups" : "");
}

} // namespace ddt::gl
