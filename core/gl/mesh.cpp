#include "core/gl/mesh.h"

namespace ddt::gl {

namespace {

size_t work_bytes(int tiles) {
    return arguments_bytes + sizeof(IterationCounts) * size_t(max_iterations + 2) * size_t(tiles);
}

// The layout of `Batch` in shaders/lattice.glsl.
struct Batch {
    GLint stride, slot_sites, slot_width, slot_pixels;
    GLint extent[max_tiles][4];
};

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
    m_gl.DispatchCompute(GLuint((width + group_x - 1) / group_x),
                         GLuint((height + group_y - 1) / group_y), GLuint(m_tiles));
    ++m_dispatches;
}

void Mesh::find_first_edges() {
    bind();
    m_gpu.programs->use("first_edges.comp");
    dispatch_over(2 * m_shape.width - 1, 2 * m_shape.height - 1, 64, 2);
    barrier();
}

std::vector<std::vector<IterationCounts>> Mesh::read_counts() {
    std::vector<std::vector<IterationCounts>> result(static_cast<size_t>(m_tiles));
    if (m_iterations == 0)
        return result;
    std::vector<IterationCounts> counts(size_t(m_tiles) * size_t(m_iterations + 1));
    m_gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    m_work.read(arguments_bytes, counts.size() * sizeof(IterationCounts), counts.data());
    for (size_t i = 1; i <= size_t(m_iterations); ++i)
        for (size_t t = 0; t < result.size(); ++t)
            result[t].push_back(counts[i * result.size() + t]);
    return result;
}

} // namespace ddt::gl
