#include "core/gl/mesh.h"

#include <algorithm>

#include "core/triangulate/triangulate.h"

namespace ddt::gl {

namespace {

/// Iterations done by dispatches over all tiles; the rest by one group a tile (finish.comp). By
/// then a tile has a few hundred edges to look at.
constexpr int wide_iterations = 6;

// The layout of `Work` in shaders/work.glsl.
constexpr size_t arguments_bytes = sizeof(GLuint) * 6 * (max_iterations + 2);
struct Counts {
    GLuint evaluated, selected, blocked, dirty;
};
size_t work_bytes(int tiles) {
    return arguments_bytes + sizeof(Counts) * size_t(max_iterations + 2) * size_t(tiles);
}

// The layout of `Batch` in shaders/lattice.glsl.
struct Batch {
    GLint stride, slot_sites, slot_width, slot_pixels;
    GLint extent[max_tiles][4];
};

int groups(int invocations, int group) {
    return (invocations + group - 1) / group;
}

std::string define(Cost cost) {
    switch (cost) {
    case Cost::abn:
        return "COST_abn";
    case Cost::scf:
        return "COST_scf";
    }
    return "";
}

} // namespace

Mesh::Mesh(Gpu& gpu, const SlotShape& shape, int tiles)
    : m_gpu(gpu), m_gl(gpu.context->gl), m_shape(shape), m_batch(m_gl, sizeof(Batch)),
      m_sites(m_gl, shape.sites() * 8 * size_t(tiles)),
      m_guide(m_gl, shape.pixels() * 4 * size_t(tiles)),
      m_gain(m_gl, shape.sites() * 4 * size_t(tiles)),
      m_stamp(m_gl, shape.sites() * 4 * size_t(tiles)),
      m_dirty(m_gl, shape.edges() * 4 * size_t(tiles)),
      m_selected(m_gl, shape.edges() * 4 * size_t(tiles)),
      m_blocked_even(m_gl, shape.edges() * 8 * size_t(tiles)),
      m_blocked_odd(m_gl, shape.edges() * 8 * size_t(tiles)), m_work(m_gl, work_bytes(tiles)) {}

size_t Mesh::bytes(const SlotShape& shape) {
    return shape.sites() * 16 + shape.pixels() * 4 + shape.edges() * 24;
}

size_t Mesh::largest_bytes(const SlotShape& shape) {
    return shape.sites() * 8;
}

void Mesh::set_tiles(const std::vector<TileSize>& sizes) {
    m_tiles = int(sizes.size());
    // Whatever shaders wrote may now be overwritten from here.
    m_gl.MemoryBarrier(GL_ALL_BARRIER_BITS);
    Batch batch{
        m_shape.stride(), GLint(m_shape.sites()), m_shape.width, GLint(m_shape.pixels()), {}};
    for (size_t i = 0; i < sizes.size(); ++i) {
        batch.extent[i][0] = sizes[i].width;
        batch.extent[i][1] = sizes[i].height;
    }
    m_batch.write(0, sizeof batch, &batch);
}

void Mesh::write_guide(int slot, const float* guide) {
    const size_t bytes = m_shape.pixels() * 4;
    m_guide.write(size_t(slot) * bytes, bytes, guide);
}

void Mesh::write_sites(int slot, const void* sites) {
    const size_t bytes = m_shape.sites() * 8;
    m_sites.write(size_t(slot) * bytes, bytes, sites);
}

void Mesh::read_sites(int slot, void* sites) {
    const size_t bytes = m_shape.sites() * 8;
    m_sites.read(size_t(slot) * bytes, bytes, sites);
}

void Mesh::bind() const {
    m_batch.bind_uniform(0);
    m_sites.bind(0);
}

void Mesh::barrier(bool with_arguments) {
    m_gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT |
                       (with_arguments ? GL_COMMAND_BARRIER_BIT : 0u));
}

void Mesh::dispatch_over(int width, int height, int group_x, int group_y) {
    m_gl.DispatchCompute(GLuint(groups(width, group_x)), GLuint(groups(height, group_y)),
                         GLuint(m_tiles));
    ++m_dispatches;
}

void Mesh::dispatch_indirect(size_t offset) {
    m_gl.DispatchComputeIndirect(GLintptr(offset));
    ++m_dispatches;
}

bool Mesh::knows(Scheme scheme) {
    return scheme == Scheme::one_round || scheme == Scheme::pixel;
}

void Mesh::start(const MeshOptions& options) {
    m_gpu.programs->use("start.comp");
    m_gl.Uniform1i(0, options.start == Start::flat);
    m_guide.bind(1);
    dispatch_over(m_shape.width, m_shape.height, 32, 4);
    barrier();
}

void Mesh::triangulate(const MeshOptions& options) {
    m_dispatches = 0;
    m_iterations = options.scheme == Scheme::pixel ? 0 : options.max_iterations;
    m_min_gain = min_gain(options);
    bind();
    start(options);
    if (m_iterations == 0)
        return;
    prepare_lists();
    const std::string cost = define(options.cost);
    first_iteration(cost);
    const int wide = std::min(m_iterations, wide_iterations);
    for (int i = 2; i <= wide; ++i)
        iteration(i, cost);
    if (m_iterations > wide) {
        m_gpu.programs->use("finish.comp", cost);
        set_uniforms(wide + 1, m_iterations);
        m_gl.DispatchCompute(GLuint(m_tiles), 1, 1);
        ++m_dispatches;
        barrier();
    }
}

void Mesh::prepare_lists() {
    std::vector<GLuint> arguments(arguments_bytes / sizeof(GLuint));
    for (size_t i = 0; i < arguments.size(); i += 3) {
        arguments[i + 1] = GLuint(m_tiles);
        arguments[i + 2] = 1;
    }
    m_work.clear();
    m_work.write(0, arguments_bytes, arguments.data());
    m_stamp.clear();
    bind_lists();
    m_gl.BindBuffer(GL_DISPATCH_INDIRECT_BUFFER, m_work.name());
}

void Mesh::bind_lists() {
    const Buffer* const bindings[] = {&m_sites,    &m_gain,         &m_stamp,       &m_dirty,
                                      &m_selected, &m_blocked_even, &m_blocked_odd, &m_work};
    for (GLuint i = 0; i < 8; ++i)
        bindings[i]->bind(i);
}

void Mesh::first_iteration(const std::string& cost) {
    const int width = 2 * m_shape.width - 1, height = 2 * m_shape.height - 1;
    m_gpu.programs->use("evaluate.comp", cost + " DENSE");
    set_uniforms(1, 1);
    dispatch_over(width, height, 64, 2);
    barrier();
    m_gpu.programs->use("select.comp", cost + " DENSE");
    set_uniforms(1, 1);
    dispatch_over(width, height, 64, 2);
    barrier(true);
    m_gpu.programs->use("flip.comp", cost);
    set_uniforms(1, 1);
    dispatch_indirect(sizeof(GLuint) * 9);
    barrier(true);
}

void Mesh::iteration(int i, const std::string& cost) {
    const size_t arguments = sizeof(GLuint) * 6 * size_t(i);
    m_gpu.programs->use("evaluate.comp", cost);
    set_uniforms(i, i);
    dispatch_indirect(arguments);
    barrier();
    m_gpu.programs->use("select.comp", cost);
    set_uniforms(i, i);
    dispatch_indirect(arguments);
    barrier(true);
    m_gpu.programs->use("flip.comp", cost);
    set_uniforms(i, i);
    dispatch_indirect(arguments + sizeof(GLuint) * 3);
    barrier(true);
}

void Mesh::set_uniforms(int first_iteration, int last_iteration) {
    m_gl.Uniform1i(0, m_tiles);
    m_gl.Uniform1i(1, GLint(m_shape.edges()));
    m_gl.Uniform1i(2, first_iteration);
    m_gl.Uniform1i(3, last_iteration);
    m_gl.Uniform1f(4, m_min_gain);
}

void Mesh::find_first_edges() {
    bind();
    m_gpu.programs->use("first_edges.comp");
    dispatch_over(2 * m_shape.width - 1, 2 * m_shape.height - 1, 64, 2);
    barrier();
}

void Mesh::find_gains(Cost cost) {
    bind();
    bind_lists();
    m_gpu.programs->use("evaluate.comp", define(cost) + " DENSE");
    set_uniforms(0, 0); // counts as iteration 0, which nobody reads
    dispatch_over(2 * m_shape.width - 1, 2 * m_shape.height - 1, 64, 2);
    barrier();
}

std::vector<std::vector<IterationCounts>> Mesh::read_counts() {
    std::vector<std::vector<IterationCounts>> result(static_cast<size_t>(m_tiles));
    if (m_iterations == 0)
        return result;
    std::vector<Counts> counts(size_t(m_tiles) * size_t(m_iterations + 1));
    m_gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    m_work.read(arguments_bytes, counts.size() * sizeof(Counts), counts.data());
    for (size_t i = 1; i <= size_t(m_iterations); ++i)
        for (size_t t = 0; t < result.size(); ++t) {
            const Counts& c = counts[i * result.size() + t];
            result[t].push_back({c.evaluated, c.selected, c.blocked, c.dirty});
        }
    return result;
}

} // namespace ddt::gl
