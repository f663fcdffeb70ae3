#include "core/gl/surfaces.h"

#include <algorithm>

#include "core/gl/failure.h"

namespace ddt::gl {

namespace {

size_t gradient_bytes(const SlotShape& shape, Surface surface) {
    return surface == Surface::linear ? 0 : shape.pixels() * 32;
}

} // namespace

Surfaces::Surfaces(Gpu& gpu, const SlotShape& shape, int tiles, int groups, Surface surface)
    : m_gpu(gpu), m_gl(gpu.context->gl), m_shape(shape), m_surface(surface) {
    for (int g = 0; g < groups; ++g)
        m_groups.push_back(std::unique_ptr<Group>(
            new Group{{m_gl, shape.pixels() * 16 * size_t(tiles)},
                      {m_gl, gradient_bytes(shape, surface) * size_t(tiles)}}));
}

size_t Surfaces::bytes(const SlotShape& shape, int groups, Surface surface) {
    return (shape.pixels() * 16 + gradient_bytes(shape, surface)) * size_t(groups);
}

size_t Surfaces::largest_bytes(const SlotShape& shape, Surface surface) {
    return std::max(shape.pixels() * 16, gradient_bytes(shape, surface));
}

void Surfaces::write_values(int slot, int group, const float* values) {
    const size_t bytes = m_shape.pixels() * 16;
    m_groups[size_t(group)]->values.write(size_t(slot) * bytes, bytes, values);
}

void Surfaces::make(Mesh& mesh) {
    if (m_surface == Surface::linear)
        return;
    mesh.find_first_edges();
    m_gpu.programs->use("gradients.comp");
    for (const auto& group : m_groups) {
        group->values.bind(1);
        group->gradients.bind(2);
        mesh.dispatch_over(m_shape.width, m_shape.height, 32, 4);
    }
    m_gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void Surfaces::reserve(std::unique_ptr<Buffer>& buffer, size_t bytes) {
    if (buffer && buffer->bytes() >= bytes)
        return;
    if (bytes > m_gpu.block_limit)
        throw Failure("a row of output is larger than a storage block");
    buffer.reset();
    buffer = std::make_unique<Buffer>(m_gl, bytes);
}

void Surfaces::write_positions(const std::vector<int32_t>& positions) {
    reserve(m_positions, positions.size() * sizeof(int32_t));
    m_positions->write(0, positions.size() * sizeof(int32_t), positions.data());
}

void Surfaces::sample(Mesh& mesh, const SamplePlan& plan, int channels,
                      const std::vector<unsigned>& nearest) {
    reserve(m_result, size_t(plan.count) * size_t(channels) * sizeof(float));
    std::string defines = m_surface == Surface::linear ? "" : "QUADRATIC";
    if (channels % channels_a_group == 0)
        defines += " WHOLE_GROUPS";
    m_gpu.programs->use("sample.comp", defines);
    mesh.bind();
    m_positions->bind(3);
    m_result->bind(4);
    m_gl.Uniform1i(0, plan.slot);
    m_gl.Uniform1i(1, plan.separable);
    m_gl.Uniform3i(2, plan.columns, plan.rows, plan.count);
    m_gl.Uniform2i(3, plan.first_x, plan.first_y);
    for (size_t g = 0; g < m_groups.size(); ++g) {
        const int first = int(g) * channels_a_group;
        m_gl.Uniform3i(4, channels, first, std::min(channels_a_group, channels - first));
        m_gl.Uniform1ui(5, nearest[g]);
        m_groups[g]->values.bind(1);
        m_groups[g]->gradients.bind(2);
        m_gl.DispatchCompute(GLuint(plan.columns + 15) / 16, GLuint(plan.rows + 7) / 8, 1);
    }
}

void Surfaces::read_result(size_t floats, float* out) {
    m_gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    m_result->read(0, floats * sizeof(float), out);
}

} // namespace ddt::gl
