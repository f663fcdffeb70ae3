// SPDX-License-Identifier: Apache-2.0
#include "core/gl/surfaces.h"

#include <algorithm>
#include <cstring>

#include "core/base/float_bits.h"
#include "core/gl/context/failure.h"
#include "core/gl/job_programs.h"
#include "core/surface/control_net.h"
#include "core/surface/corrections.h"
#include "core/surface/fitted/weights.h"

namespace ddt::gl {

namespace {

// A vertex has group_size floats as its value, twice that as its gradient.
size_t value_bytes(const SlotShape& shape) {
    return shape.pixels() * group_size * sizeof(float);
}
size_t gradient_bytes(const SlotShape& shape, const SurfaceOptions& options) {
    return options.kind == Surface::linear ? 0 : 2 * value_bytes(shape);
}
int corrected_buffers(const SurfaceOptions& options) {
    return is_fitted(options) ? 1 : std::min(options.consistency, 2);
}
// A site has group_size floats.
size_t bend_bytes(const SlotShape& shape, const SurfaceOptions& options) {
    return is_fitted(options) ? shape.sites() * group_size * sizeof(float) : 0;
}
// A site has group_size floats for its edge's bend, and as many for its softness.
size_t edge_bytes(const SlotShape& shape, const SurfaceOptions& options) {
    const auto numbers = size_t(options.kind != Surface::linear) + size_t(options.soft > 0);
    return options.consistency > 0 ? numbers * shape.sites() * group_size * sizeof(float) : 0;
}

/// Groups of invocations that go over n things.
GLuint groups(int n, int size) {
    return GLuint((n + size - 1) / size);
}

} // namespace

Surfaces::Surfaces(Gpu& gpu, const SlotShape& shape, int tiles,
                   const std::vector<GroupKinds>& groups, const SurfaceOptions& options,
                   float strength)
    : m_gpu(gpu), m_gl(gpu.context->gl), m_shape(shape), m_slots(tiles), m_options(options),
      m_strength(strength) {
    const auto n = size_t(tiles);
    for (const GroupKinds& kinds : groups) {
        Group g;
        g.kinds = kinds;
        g.source = std::make_unique<Buffer>(m_gl, value_bytes(shape) * n);
        for (int i = 0; i < corrected_buffers(options); ++i)
            g.corrected[i] = std::make_unique<Buffer>(m_gl, value_bytes(shape) * n);
        g.gradients = std::make_unique<Buffer>(m_gl, gradient_bytes(shape, options) * n);
        if (is_fitted(options))
            g.bends = std::make_unique<Buffer>(m_gl, bend_bytes(shape, options) * n);
        m_groups.push_back(std::move(g));
    }
    if (const size_t bytes = edge_bytes(shape, options); bytes > 0)
        m_edges = std::make_unique<Buffer>(m_gl, bytes * n);
    if (is_fitted(options)) {
        m_table = std::make_unique<Buffer>(m_gl, sizeof(FittedTable));
        m_table->write(0, sizeof(FittedTable), &fitted_table());
    }
}

size_t Surfaces::bytes(const SlotShape& shape, size_t groups, const SurfaceOptions& options) {
    return edge_bytes(shape, options) +
           groups * (value_bytes(shape) * size_t(1 + corrected_buffers(options)) +
                     gradient_bytes(shape, options) + bend_bytes(shape, options));
}

size_t Surfaces::largest_bytes(const SlotShape& shape, const SurfaceOptions& options) {
    return std::max({value_bytes(shape), gradient_bytes(shape, options), bend_bytes(shape, options),
                     edge_bytes(shape, options)});
}

size_t Surfaces::tile_bytes() const {
    return m_expected.room(m_shape.pixels() * size_t(m_channels));
}

void Surfaces::expect(const Numbers& numbers, int channels, int meshes) {
    m_expected = numbers;
    m_channels = channels;
    m_meshes = meshes;
    const size_t bytes_of_all = size_t(m_slots / meshes) * tile_bytes();
    if (bytes_of_all > m_gpu.block_limit)
        throw Failure("the numbers of a tile are larger than a storage block");
    m_numbers = std::make_unique<Buffer>(m_gl, bytes_of_all);
    if (!numbers.coded())
        return;
    const size_t bytes = numbers.table.size() * sizeof(float);
    m_codes = std::make_unique<Buffer>(m_gl, bytes);
    m_codes->write(0, bytes, numbers.table.data());
}

size_t Surfaces::write_numbers(int tile, const TileSize& size, const HostBuffer& from, size_t at) {
    const size_t bytes =
        size_t(size.width) * size_t(size.height) * size_t(m_channels) * size_t(m_expected.bytes);
    from.upload(at, bytes, *m_numbers, size_t(tile) * tile_bytes());
    return bytes;
}

void Surfaces::unpack(DeviceMesh& mesh) {
    m_gpu.programs->use("unpack.comp", unpack_macros(m_expected));
    mesh.bind();
    m_numbers->bind(Binding::numbers);
    if (m_codes)
        m_codes->bind(Binding::codes);
    m_gl.Uniform2i(at_layout, m_meshes, GLint(tile_bytes() / sizeof(GLuint)));
    for (size_t g = 0; g < m_groups.size(); ++g) {
        m_groups[g].values = m_groups[g].source.get();
        m_groups[g].values->bind(Binding::values);
        set_channels(int(g));
        mesh.dispatch_over(m_shape.width, m_shape.height, surface_group_x, surface_group_y);
    }
    m_gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

/// The uniform of which channels of a pixel are a group's.
void Surfaces::set_channels(int group) const {
    const int first = group * group_size;
    m_gl.Uniform3i(at_channels, m_channels, first, std::min(group_size, m_channels - first));
}

void Surfaces::make(DeviceMesh& mesh, const Criterion& by) {
    if (m_options.soft > 0 || fitted())
        mesh.find_gains(by);
    for (Group& group : m_groups) {
        group.values = group.source.get();
        if (fitted()) {
            fit(mesh, group);
            continue;
        }
        for (int round = 0; round < m_options.consistency; ++round) {
            // Values are read as far off as the surface and the apexes beyond its triangles go;
            // each later round reads as far again round those.
            const int later = m_options.consistency - 1 - round;
            find_gradients(mesh, group, 3 + 2 * later);
            find_edges(mesh, group, 3 + 2 * later);
            correct(mesh, group, round, 2 + 2 * later);
        }
        find_gradients(mesh, group, 1);
    }
}

void Surfaces::find_gradients(DeviceMesh& mesh, const Group& group, int margin) {
    if (m_options.kind == Surface::linear)
        return;
    m_gpu.programs->use("gradients.comp", gradient_macros(m_options));
    mesh.bind();
    group.values->bind(Binding::values);
    group.gradients->bind(Binding::gradients);
    m_gl.Uniform1i(at_margin, margin);
    mesh.dispatch_over(m_shape.width, m_shape.height, surface_group_x, surface_group_y);
    m_gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void Surfaces::bind_net(const DeviceMesh& mesh, int group) {
    const Group& g = m_groups[size_t(group)];
    bind_net(mesh, g, edges_of(g));
}

void Surfaces::bind_net(const DeviceMesh& mesh, const Group& group, const Buffer& edges) {
    mesh.bind();
    group.values->bind(Binding::values);
    edges.bind(Binding::gradients);
    mesh.gains().bind(Binding::gains);
    m_gl.Uniform1f(at_reciprocal_tau, m_options.soft > 0 ? 1.0f / m_options.soft : 0.0f);
}

void Surfaces::fit(DeviceMesh& mesh, Group& group) {
    // As in a last round; bends are wanted of edges of triangles that are read.
    m_table->bind_uniform(UniformBinding::fitted);
    group.bends->bind(Binding::bends);
    find_gradients(mesh, group, 3);
    find_edges(mesh, group, 3);
    bend_edges(mesh, group, 1);
    correct(mesh, group, 0, 2);
}

void Surfaces::find_edges(DeviceMesh& mesh, const Group& group, int margin) {
    if (!has_edges())
        return;
    m_gpu.programs->use("net_edges.comp", surface_macros(m_options));
    bind_net(mesh, group, *group.gradients);
    m_edges->bind(Binding::made_edges);
    m_gl.Uniform1i(at_margin, margin);
    mesh.dispatch_over_sites();
    m_gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void Surfaces::bend_edges(DeviceMesh& mesh, const Group& group, int margin) {
    m_gpu.programs->use("fitted_bends.comp", bend_macros(m_options));
    bind_net(mesh, group, *m_edges);
    m_gl.Uniform1i(at_margin, margin);
    mesh.dispatch_over_sites();
    m_gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void Surfaces::correct(DeviceMesh& mesh, Group& group, int round, int margin) {
    const Buffer* to = group.corrected[round & 1].get();
    m_gpu.programs->use("correct.comp", correct_macros(m_options));
    bind_net(mesh, group, has_edges() ? *m_edges : *group.gradients);
    group.source->bind(Binding::source);
    to->bind(Binding::corrected);
    m_gl.Uniform1f(at_limit, m_options.limit);
    m_gl.Uniform1i(at_clipped, m_options.clipped);
    m_gl.Uniform1f(at_strength, m_strength);
    m_gl.Uniform1i(at_margin, margin);
    mesh.dispatch_over(m_shape.width, m_shape.height, surface_group_x, surface_group_y);
    m_gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    group.values = to;
}

void Surfaces::reserve(std::unique_ptr<Buffer>& buffer, size_t bytes) {
    if (buffer && buffer->bytes() >= bytes)
        return;
    if (bytes > m_gpu.block_limit)
        throw Failure("a row of output is larger than a storage block");
    buffer.reset();
    buffer = std::make_unique<Buffer>(m_gl, bytes);
}

namespace {

/// Room for results as they travel, in whole words.
size_t packed_bytes(size_t numbers, const Transfer& transfer) {
    return transfer.packed() ? whole_words(numbers * transfer.download_bytes()) : 0;
}

} // namespace

void Surfaces::make_room(size_t coordinates, size_t numbers, const Transfer& transfer,
                         SampleMemory& memory) {
    reserve(memory.positions, coordinates * sizeof(int32_t));
    if (!memory.sent || memory.sent->bytes() < memory.positions->bytes())
        memory.sent = std::make_unique<HostBuffer>(m_gl, memory.positions->bytes());
    reserve(memory.results, numbers * sizeof(float));
    if (transfer.packed())
        reserve(memory.packed, packed_bytes(numbers, transfer));
}

void Surfaces::write_positions(const std::vector<int32_t>& positions, SampleMemory& memory) {
    const size_t bytes = positions.size() * sizeof(int32_t);
    if (bytes == 0)
        return;
    std::memcpy(memory.sent->data(), positions.data(), bytes);
    memory.sent->upload(0, bytes, *memory.positions, 0);
}

void Surfaces::sample(DeviceMesh& mesh, const SamplePlan& plan, const SampleMemory& memory) {
    for (int i = 0; i < plan.meshes; ++i)
        sample_mesh(mesh, plan, i, memory);
}

void Surfaces::sample_mesh(DeviceMesh& mesh, const SamplePlan& plan, int index,
                           const SampleMemory& memory) {
    m_gpu.programs->use("sample.comp", sample_macros(m_options, m_channels, index));
    m_gl.Uniform1i(at_tile, plan.slot + index);
    m_gl.Uniform1i(at_separable, plan.separable);
    m_gl.Uniform3i(at_size, plan.columns, plan.rows, plan.count);
    if (index > 0) {
        m_gl.Uniform1f(at_share, 1.0f / float(index + 1));
        m_gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    }
    for (size_t g = 0; g < m_groups.size(); ++g) {
        const Group& group = m_groups[g];
        bind_net(mesh, group, edges_of(group));
        memory.positions->bind(Binding::positions);
        memory.results->bind(Binding::results);
        group.source->bind(Binding::source);
        set_channels(int(g));
        m_gl.Uniform1ui(at_nearest, group.kinds.nearest);
        m_gl.Uniform1ui(at_alpha, group.kinds.bounded);
        m_gl.DispatchCompute(groups(plan.columns, sample_group_x),
                             groups(plan.rows, sample_group_y), 1);
    }
}

size_t Surfaces::download(size_t count, const Transfer& transfer, SampleMemory& memory,
                          HostBuffer& to) {
    if (transfer.packed())
        pack(count, transfer, memory);
    const size_t bytes = count * transfer.download_bytes();
    to.download(m_gl, transfer.packed() ? *memory.packed : *memory.results, bytes);
    return bytes;
}

void Surfaces::pack(size_t count, const Transfer& transfer, SampleMemory& memory) {
    constexpr size_t packing_groups = 4096; // which go on where there is more
    m_gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    m_gpu.programs->use("pack.comp", pack_macros(transfer.download));
    if (transfer.download == Transfer::Download::codes) {
        const CodeTable& table = *transfer.download_codes;
        if (!m_code_table) {
            const size_t bytes = table.entries.size() * sizeof(uint32_t);
            m_code_table = std::make_unique<Buffer>(m_gl, bytes);
            m_code_table->write(0, bytes, table.entries.data());
        }
        m_code_table->bind(Binding::code_table);
        m_gl.Uniform4ui(at_code_table, GLuint(table.shift), table.first, bits_of(table.lowest),
                        bits_of(table.top));
    }
    m_gl.Uniform1i(at_count, GLint(count));
    memory.results->bind(Binding::results);
    memory.packed->bind(Binding::packed);
    const size_t words = packed_bytes(count, transfer) / sizeof(uint32_t);
    m_gl.DispatchCompute(GLuint(std::clamp<size_t>(words / list_group, 1, packing_groups)), 1, 1);
}

} // namespace ddt::gl
