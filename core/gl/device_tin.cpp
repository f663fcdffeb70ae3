// SPDX-License-Identifier: Apache-2.0
// C++ twins: core/triangulate/accept_reject.h and one_round.h on a TinMesh: one_round() is MaxGain
// whose rounds end with the first.
#include "core/gl/device_tin.h"

#include <algorithm>
#include <utility>

#include "core/gl/context/failure.h"
#include "core/gl/guarded.h"
#include "core/gl/offload.h"
#include "core/tin/tin_mesh.h"
#include "core/triangulate/annealing.h"
#include "ddt/names.h"

namespace ddt {

namespace gl {

namespace {

constexpr size_t group = tin_group;

// The shaders read these as they are.
static_assert(sizeof(Tin::Vertex) == 12 && sizeof(Tin::Triangle) == 24 && sizeof(Tin::Edge) == 8 &&
                  sizeof(TinFace) == 16,
              "without gaps");

template <class T>
size_t bytes_of(const std::vector<T>& records) {
    return records.size() * sizeof(T);
}

} // namespace

DeviceTin::DeviceTin(Gpu& gpu, const Tin& tin)
    : m_gpu(gpu), m_gl(gpu.context->gl), m_tin(tin), m_triangles(tin.triangles.size()),
      m_edges(tin.edges.size()), m_pixel(tin.pixel), m_vertex_buffer(m_gl, bytes_of(tin.vertices)),
      m_triangle_buffer(m_gl, bytes_of(tin.triangles)), m_edge_buffer(m_gl, bytes_of(tin.edges)),
      m_face_buffer(m_gl, m_triangles * sizeof(TinFace)),
      m_gain_buffer(m_gl, m_edges * sizeof(float)), m_mark_buffer(m_gl, m_edges * sizeof(uint32_t)),
      m_count_buffer(m_gl, sizeof(Counts)) {
    const size_t largest = std::max(bytes_of(tin.triangles), bytes_of(tin.vertices));
    if (largest > gpu.block_limit)
        throw Failure("the mesh is too large for the device");
    m_vertex_buffer.write(0, bytes_of(tin.vertices), tin.vertices.data());
    m_triangle_buffer.write(0, bytes_of(tin.triangles), tin.triangles.data());
    m_edge_buffer.write(0, bytes_of(tin.edges), tin.edges.data());
    mark_all_dirty();
    m_gain_buffer.clear();
}

void DeviceTin::mark_all_dirty() {
    const std::vector<uint32_t> marks(m_edges, uint32_t(mark_dirty));
    m_mark_buffer.write(0, bytes_of(marks), marks.data());
}

void DeviceTin::triangulate(const MeshOptions& options, const Workspace& workspace,
                            Statistics& statistics) {
    m_cost = std::string("COST_") + cost_name(options.cost);
    m_min_gain = min_gain(options);
    if (options.scheme == Scheme::pixel)
        return;
    pass("tin_faces.comp", m_triangles);
    if (options.scheme == Scheme::annealing) {
        Workspace silent;
        flip_by({}, options.max_iterations, silent, statistics);
        anneal(options, workspace, statistics);
        there([this] { mark_all_dirty(); });
        flip_by({}, options.max_iterations, silent, statistics);
    } else {
        flip_by(find_rules(options), options.max_iterations, workspace, statistics);
    }
    there([this] { finish(m_gl, "tin"); });
}

void DeviceTin::flip_by(const std::optional<Rules>& rules, int iterations,
                        const Workspace& workspace, Statistics& statistics) {
    m_by_gain = !rules || rules->by_gain;
    for (int i = 1; i <= iterations; ++i) {
        const bool wide = rules && i <= rules->wide_iterations;
        const Counts found = pass("tin_evaluate.comp", m_edges);
        statistics.evaluations += found.evaluated;
        if (found.candidates == 0)
            break;
        uint32_t waiting = found.candidates;
        do {
            // The first in order is accepted, if anything is right.
            const uint32_t before = waiting;
            waiting = pass("tin_accept.comp", m_edges, wide).waiting;
            if (waiting >= before)
                throw DoesNotEnd("no edge of a round was accepted");
            pass("tin_reject.comp", m_edges, wide);
            statistics.rounds += rules.has_value();
        } while (rules && waiting > 0);
        statistics.flips += pass("tin_flip.comp", m_edges).flipped;
        statistics.iterations = std::max(statistics.iterations, i);
        if (!workspace.go_on(found.candidates, m_edges))
            break;
    }
}

void DeviceTin::anneal(const MeshOptions& options, const Workspace& workspace,
                       Statistics& statistics) {
    there([&] {
        Tin now = m_tin;
        read(now);
        const std::vector<uint64_t> places = places_of(now, workspace.origin_x, workspace.origin_y);
        m_place_buffer = std::make_unique<Buffer>(m_gl, bytes_of(places));
        m_place_buffer->write(0, bytes_of(places), places.data());
        m_drawn_buffer = std::make_unique<Buffer>(m_gl, m_edges * sizeof(uint32_t));
    });
    AnnealingUniforms chance{0, mixed(options.seed), 0, 0};
    const int iterations = options.max_iterations;
    for (int i = 0; i < iterations; ++i) {
        chance.salt = annealing_salt(chance.seed, i);
        chance.temperature = annealing_temperature(options.cost, i, iterations);
        pass("tin_anneal_draw.comp", m_edges, false, &chance);
        for (chance.part = 0; chance.part < uint32_t(annealing_parts); ++chance.part) {
            statistics.evaluations +=
                pass("tin_anneal_select.comp", m_edges, false, &chance).evaluated;
            statistics.flips += pass("tin_flip.comp", m_edges).flipped;
        }
        if (!workspace.go_on(size_t(iterations - i), size_t(iterations)))
            break;
    }
}

DeviceTin::Counts DeviceTin::pass(const char* shader, size_t invocations, bool wide,
                                  const AnnealingUniforms* chance) {
    return there([&] { return pass_there(shader, invocations, wide, chance); });
}

void DeviceTin::bind() const {
    m_vertex_buffer.bind(Binding::tin_vertices);
    m_triangle_buffer.bind(Binding::tin_triangles);
    m_edge_buffer.bind(Binding::tin_edges);
    m_face_buffer.bind(Binding::tin_faces);
    m_gain_buffer.bind(Binding::tin_gains);
    m_mark_buffer.bind(Binding::tin_marks);
    m_count_buffer.bind(Binding::tin_counts);
}

DeviceTin::Counts DeviceTin::pass_there(const char* shader, size_t invocations, bool wide,
                                        const AnnealingUniforms* chance) {
    m_gpu.programs->use(shader, m_cost);
    bind();
    if (chance) {
        m_place_buffer->bind(Binding::tin_places);
        m_drawn_buffer->bind(Binding::tin_drawn);
        set_annealing_uniforms(m_gl, *chance);
    }
    m_count_buffer.clear();
    m_gl.Uniform1i(at_count, GLint(invocations));
    m_gl.Uniform1f(at_pixel, m_pixel);
    m_gl.Uniform1f(at_min_gain, m_min_gain);
    m_gl.Uniform1i(at_by_gain, m_by_gain);
    m_gl.Uniform1i(at_wide, wide);
    const size_t groups = (invocations + group - 1) / group;
    const size_t across = std::min(groups, size_t(most_groups));
    m_gl.DispatchCompute(GLuint(across), GLuint((groups + across - 1) / across), 1);
    m_gl.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    Counts counts;
    m_count_buffer.read(0, sizeof counts, &counts);
    return counts;
}

void DeviceTin::read(Tin& tin) const {
    // Both or none: when one cannot be read, the CPU goes on with the mesh as it was.
    std::vector<Tin::Triangle> triangles(tin.triangles.size());
    std::vector<Tin::Edge> edges(tin.edges.size());
    m_triangle_buffer.read(0, bytes_of(triangles), triangles.data());
    m_edge_buffer.read(0, bytes_of(edges), edges.data());
    tin.triangles = std::move(triangles);
    tin.edges = std::move(edges);
}

void DeviceTin::read_work(std::vector<TinFace>& faces, std::vector<float>& gains) const {
    m_face_buffer.read(0, bytes_of(faces), faces.data());
    m_gain_buffer.read(0, bytes_of(gains), gains.data());
}

} // namespace gl

std::string flip_on_gpu(gl::Gpu& gpu, Tin& tin, const MeshOptions& options,
                        const Workspace& workspace, Statistics& statistics) {
    return gl::guarded_on(gpu, [&]() -> std::string {
        Statistics own = statistics;
        const auto drop = [&](gl::DeviceTin* device) {
            gpu.thread.call([device] { delete device; });
        };
        std::unique_ptr<gl::DeviceTin, decltype(drop)> device(nullptr, drop);
        const auto begin = [&] {
            std::string difference = gpu.checks.differs(gpu, options);
            if (difference.empty())
                device.reset(new gl::DeviceTin(gpu, tin));
            return difference;
        };
        std::string difference = gpu.thread.post(begin).get();
        if (!difference.empty())
            return difference;
        device->triangulate(options, workspace, own);
        gpu.thread.post([&] { device->read(tin); }).get();
        statistics = own;
        return {};
    });
}

} // namespace ddt
