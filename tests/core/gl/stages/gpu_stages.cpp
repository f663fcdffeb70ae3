// SPDX-License-Identifier: Apache-2.0
#include "tests/core/gl/stages/gpu_stages.h"

#include <cstring>

#include "core/gl/budget.h"
#include "core/gl/job_programs.h"
#include "core/gl/strip.h"
#include "core/surface/control_net.h"
#include "core/surface/corrections.h"
#include "core/triangulate/triangulate.h"

namespace ddt::test {

namespace {

/// Bends and softness of edges, which shaders make where they read them.
const char* const edges_comp = R"(
#include "net.glsl"

layout(local_size_x = 8, local_size_y = 8) in; // a site

layout(std430, binding = BIND_BENDS) writeonly buffer Bends { vec4 bends[]; };
layout(std430, binding = BIND_MADE_EDGES) writeonly buffer Softness { vec4 softnesses[]; };

void main() {
    ivec2 m = ivec2(gl_GlobalInvocationID.xy);
    if (m.x >= 2 * extent[0].x - 1 || m.y >= 2 * extent[0].y - 1 || ((m.x | m.y) & 1) == 0)
        return;
    first_site = 0;
    first_pixel = 0;
    int s = offset(m);
    ivec2 v = edge_at(s).v;
#ifdef QUADRATIC
    bends[s] = bend((m - v) / 2, (m + v) / 2);
#endif
#ifdef SOFT
    softnesses[s] = softness((m - v) / 2, (m + v) / 2);
#endif
}
)";

} // namespace

GpuStages::GpuStages(gl::Gpu& gpu, Source& source, const Job& job)
    : m_gpu(gpu), m_job(job), m_shape(gl::shape_for(job.window)), m_mesh(gpu, m_shape, 1) {
    m_tile.tile = Grid(job.window).tile(0);
    gl::ReadMemory memory;
    gl::read(source, m_job, m_shape, m_numbers, m_tile, memory);
    m_mesh.set_tiles({m_tile.size});
}

MeshStage GpuStages::mesh(const MeshOptions& options, int iterations, bool gains_alone) {
    MeshOptions some = options;
    some.max_iterations = iterations;
    MeshStage stage;
    stage.sites.resize(m_shape.sites());
    stage.gains.resize(m_shape.sites());
    stage.stride = m_shape.stride();
    write_guide();
    m_mesh.triangulate(some);
    gl::finish(m_gpu.context->gl, "triangulation");
    m_mesh.read_sites(0, stage.sites.data());
    for (uint64_t& site : stage.sites)
        site &= vectors_mask;
    if (gains_alone)
        m_mesh.write_sites(0, stage.sites.data()); // of which none are known
    m_mesh.find_gains(criterion(options));
    gl::finish(m_gpu.context->gl, "gains");
    m_mesh.read_gains(0, stage.gains.data());
    return stage;
}

void GpuStages::write_guide() {
    gl::upload_guides(m_tile, m_job, 0, m_mesh);
    if (gl::with_guides(m_job))
        m_mesh.unpack_guides();
}

void GpuStages::finish_mesh() {
    write_guide();
    if (m_tile.sites.empty())
        m_mesh.triangulate(m_job.mesh);
    else
        m_mesh.write_sites(0, m_tile.sites.data());
}

SurfaceStage GpuStages::surface(int rounds) {
    const gl::Functions& gl = m_gpu.context->gl;
    SurfaceOptions options = m_job.surface;
    options.consistency = rounds;
    options.fitted = false; // its vertices and bends are seen in the result
    const auto kinds = gl::kinds_of(m_job);
    gl::Surfaces surfaces(m_gpu, m_shape, 1, kinds, options, correction_strength(surface_scale));
    finish_mesh();
    surfaces.expect(m_numbers, m_job.channels, 1);
    gl::upload_numbers(m_tile, m_job, 0, m_shape, surfaces);
    surfaces.unpack(m_mesh);
    surfaces.make(m_mesh, criterion(m_job.mesh));
    m_mesh.find_gains(criterion(m_job.mesh));

    const bool bend = options.kind != Surface::linear, soft = options.soft > 0;
    const size_t numbers = m_shape.sites() * group_size;
    const gl::Buffer bends(gl, numbers * sizeof(float)), softness(gl, numbers * sizeof(float));
    bends.clear();
    softness.clear();
    const std::string defines = gl::surface_macros(m_job.surface);
    const GLuint program = gl::compile(gl, gl::program_name("edges.comp", defines),
                                       gl::assembled(edges_comp, defines));
    gl.UseProgram(program);
    surfaces.bind_net(m_mesh, 0);
    bends.bind(gl::Binding::bends);
    softness.bind(gl::Binding::made_edges);
    m_mesh.dispatch_over(2 * m_shape.width - 1, 2 * m_shape.height - 1, 8, 8);
    gl::finish(gl, "edges");
    gl.DeleteProgram(program);

    SurfaceStage stage;
    const size_t pixels = m_shape.pixels() * group_size;
    const auto read = [](const gl::Buffer& buffer, size_t floats, std::vector<float>& out) {
        out.resize(floats);
        buffer.read(0, floats * sizeof(float), out.data());
    };
    read(surfaces.vertices(0), pixels, stage.vertices);
    if (bend) {
        read(surfaces.gradients(0), 2 * pixels, stage.gradients);
        read(bends, numbers, stage.bends);
    }
    if (soft)
        read(softness, numbers, stage.softness);
    return stage;
}

std::vector<float> GpuStages::result(int out_width, int out_height) {
    const ResizeMapping mapping(ResizeMapping::Axis::whole(m_job.window.width(), out_width),
                                ResizeMapping::Axis::whole(m_job.window.height(), out_height));
    gl::Surfaces surfaces(m_gpu, m_shape, 1, gl::kinds_of(m_job), m_job.surface,
                          correction_strength(mapping.scale()));
    finish_mesh();
    surfaces.expect(m_numbers, m_job.channels, 1);
    gl::upload_numbers(m_tile, m_job, 0, m_shape, surfaces);
    surfaces.unpack(m_mesh);
    surfaces.make(m_mesh, criterion(m_job.mesh));
    gl::Strip strip;
    strip.rows = {0, 0, out_width, out_height};
    gl::plan_strip(mapping, m_tile.tile, 0, strip);
    std::vector<float> result(size_t(strip.plan.count) * size_t(m_job.channels));
    gl::SampleMemory memory;
    gl::HostBuffer results(result.size() * sizeof(float));
    surfaces.make_room(strip.positions.size(), result.size(), gl::Transfer(), memory);
    surfaces.write_positions(strip.positions, memory);
    surfaces.sample(m_mesh, strip.plan, memory);
    surfaces.download(result.size(), gl::Transfer(), memory, results);
    gl::finish(m_gpu.context->gl, "sampling");
    std::memcpy(result.data(), results.data(), results.bytes());
    return result;
}

} // namespace ddt::test
