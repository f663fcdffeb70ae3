// SPDX-License-Identifier: Apache-2.0
#include "core/gl/device_mesh.h"

#include <algorithm>

#include "core/gl/transfer.h"
#include "core/gl/work_layout.h"

namespace ddt::gl {

namespace {

// The layout of `Batch` in shaders/lattice.glsl.
struct Batch {
    GLint stride, slot_sites, slot_width, slot_pixels;
    GLint extent[max_tiles][4], served[max_tiles][4];
};

/// Bytes of a tile in each buffer.
size_t bytes_of(MeshPart part, const SlotShape& shape) {
    switch (part) {
    case MeshPart::sites:
        return shape.sites() * 8;
    case MeshPart::encoded:
        return guide_room(shape.pixels());
    case MeshPart::guide:
        return shape.pixels() * 4;
    case MeshPart::contours:
        return shape.sites() * 2;
    case MeshPart::gain:
        return shape.sites() * 4;
    case MeshPart::list0:
    case MeshPart::list1:
        return shape.edges() * 4;
    case MeshPart::blocked_even:
    case MeshPart::blocked_odd:
        return shape.waiting_bytes();
    case MeshPart::work:
        return counts_bytes;
    case MeshPart::marks: // behind those of all tiles, a tile's progress
        return (shape.sites() + size_t(progress_size)) * 4;
    case MeshPart::count:
        break;
    }
    return 0;
}

/// Whether there are marks where meshes are made so.
bool with_marks(const MeshOptions& options) {
    return DeviceMesh::knows(options) && find_rules(options);
}

template <class F>
void each_part(F f) {
    for (int i = 0; i < int(MeshPart::count); ++i)
        f(MeshPart(i));
}

} // namespace

DeviceMesh::DeviceMesh(Gpu& gpu, const SlotShape& shape, int tiles)
    : m_gpu(gpu), m_gl(gpu.context->gl), m_shape(shape), m_capacity(tiles),
      m_batch(m_gl, sizeof(Batch)), m_sites(m_gl, bytes_of_all(MeshPart::sites)),
      m_encoded(m_gl, bytes_of_all(MeshPart::encoded)),
      m_guide(m_gl, bytes_of_all(MeshPart::guide)),
      m_contours(m_gl, bytes_of_all(MeshPart::contours)),
      m_gain(m_gl, bytes_of_all(MeshPart::gain)), m_list0(m_gl, bytes_of_all(MeshPart::list0)),
      m_list1(m_gl, bytes_of_all(MeshPart::list1)),
      m_blocked_even(m_gl, bytes_of_all(MeshPart::blocked_even)),
      m_blocked_odd(m_gl, bytes_of_all(MeshPart::blocked_odd)),
      m_work(m_gl, counts_offset + bytes_of_all(MeshPart::work)) {}

TileSize size_in_slot(const Tile& tile, const Rect& window, int width, int height) {
    const Rect &c = tile.cells, &p = tile.pixels;
    return {width,       height,      c.x0 - p.x0,      c.y0 - p.y0,
            c.x1 - p.x0, c.y1 - p.y0, p.x0 - window.x0, p.y0 - window.y0};
}

size_t DeviceMesh::bytes_of_all(MeshPart part) const {
    return bytes_of(part, m_shape) * size_t(m_capacity);
}

size_t DeviceMesh::bytes(const SlotShape& shape, const MeshOptions& options) {
    size_t sum = 0;
    each_part([&](MeshPart part) {
        if (part != MeshPart::marks || with_marks(options))
            sum += bytes_of(part, shape);
    });
    return sum;
}

size_t DeviceMesh::largest_bytes(const SlotShape& shape) {
    size_t largest = 0;
    each_part([&](MeshPart part) { largest = std::max(largest, bytes_of(part, shape)); });
    return largest;
}

void DeviceMesh::set_tiles(const std::vector<TileSize>& sizes) {
    m_tiles = int(sizes.size());
    // Whatever shaders wrote may now be overwritten from here.
    m_gl.MemoryBarrier(GL_ALL_BARRIER_BITS);
    Batch batch{
        m_shape.stride(), GLint(m_shape.sites()), m_shape.width, GLint(m_shape.pixels()), {}, {}};
    for (size_t i = 0; i < sizes.size(); ++i) {
        const TileSize& size = sizes[i];
        batch.extent[i][0] = size.width;
        batch.extent[i][1] = size.height;
        batch.extent[i][2] = size.origin_x;
        batch.extent[i][3] = size.origin_y;
        batch.served[i][0] = size.served_x0;
        batch.served[i][1] = size.served_y0;
        batch.served[i][2] = size.served_x1;
        batch.served[i][3] = size.served_y1;
    }
    m_batch.write(0, sizeof batch, &batch);
}

size_t DeviceMesh::write_guide(int slot, const HostBuffer& from, size_t at, size_t bytes) {
    from.upload(at, bytes, m_encoded, size_t(slot) * guide_room(m_shape.pixels()));
    return bytes;
}

void DeviceMesh::unpack_guides() {
    m_gpu.programs->use("unpack_guide.comp");
    bind();
    m_encoded.bind(Binding::encoded);
    m_guide.bind(Binding::guide);
    dispatch_over(m_shape.width, m_shape.height, surface_group_x, surface_group_y);
    barrier();
}

void DeviceMesh::read_guide(int slot, float* guide) {
    const size_t bytes = m_shape.pixels() * sizeof(float);
    m_guide.read(size_t(slot) * bytes, bytes, guide);
}

size_t DeviceMesh::write_sites(int slot, const void* sites) {
    const size_t bytes = m_shape.sites() * 8;
    m_sites.write(size_t(slot) * bytes, bytes, sites);
    const GLuint far = GLuint(m_shape.width + m_shape.height); // unknown: everywhere
    const Reach reach{far, far, far, far};
    m_work.write(reach_offset + sizeof reach * size_t(slot), sizeof reach, &reach);
    m_gains_known = false;
    return bytes;
}

void DeviceMesh::read_sites(int slot, void* sites) {
    const size_t bytes = m_shape.sites() * 8;
    m_sites.read(size_t(slot) * bytes, bytes, sites);
}

void DeviceMesh::read_gains(int slot, float* gains) {
    const size_t bytes = m_shape.sites() * sizeof(float);
    m_gain.read(size_t(slot) * bytes, bytes, gains);
}

void DeviceMesh::bind() const {
    m_batch.bind_uniform(UniformBinding::batch);
    m_sites.bind(Binding::sites);
    m_work.bind(Binding::work);
}

void DeviceMesh::barrier(bool with_arguments) {
    m_gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT |
                       (with_arguments ? GL_COMMAND_BARRIER_BIT : 0u));
}

void DeviceMesh::dispatch_over(int width, int height, int group_x, int group_y) {
    m_gl.DispatchCompute(GLuint((width + group_x - 1) / group_x),
                         GLuint((height + group_y - 1) / group_y), GLuint(m_tiles));
}

void DeviceMesh::dispatch_over_sites() {
    dispatch_over(2 * m_shape.width - 1, 2 * m_shape.height - 1, gains_group_x, gains_group_y);
}

std::vector<std::vector<IterationCounts>> DeviceMesh::read_counts() {
    std::vector<std::vector<IterationCounts>> result(static_cast<size_t>(m_tiles));
    if (m_iterations == 0)
        return result;
    std::vector<IterationCounts> counts(size_t(m_tiles) * size_t(m_iterations + 1));
    m_work.read(counts_offset, counts.size() * sizeof(IterationCounts), counts.data());
    for (size_t i = 0; i <= size_t(m_iterations); ++i)
        for (size_t t = 0; t < result.size(); ++t)
            result[t].push_back(counts[i * result.size() + t]);
    return result;
}

std::vector<Statistics> DeviceMesh::read_statistics() {
    std::vector<Statistics> result = m_before;
    result.resize(static_cast<size_t>(m_tiles));
    const auto counts = read_counts();
    for (size_t slot = 0; slot < counts.size(); ++slot)
        for (size_t i = 0; i < counts[slot].size(); ++i) {
            const IterationCounts& c = counts[slot][i];
            result[slot].evaluations += c.evaluated;
            result[slot].flips += c.selected;
            result[slot].rounds += c.rounds;
            if (c.selected > 0)
                result[slot].iterations = std::max(result[slot].iterations, int(i));
        }
    return result;
}

std::vector<Reach> DeviceMesh::read_reach() {
    std::vector<Reach> reach(static_cast<size_t>(m_tiles));
    m_work.read(reach_offset, reach.size() * sizeof(Reach), reach.data());
    return reach;
}

} // namespace ddt::gl
