// SPDX-License-Identifier: Apache-2.0
// Triangulation as dispatches. C++ twins: core/triangulate.
#include <algorithm>
#include <cstring>
#include <optional>
#include <utility>

#include "core/base/constants.h"
#include "core/gl/annealing_uniforms.h"
#include "core/gl/context/failure.h"
#include "core/gl/device_mesh.h"
#include "core/gl/job_programs.h"
#include "core/gl/work_layout.h"
#include "core/triangulate/annealing.h"

namespace ddt::gl {

bool DeviceMesh::knows(const MeshOptions& options) {
    switch (options.scheme) {
    case Scheme::one_round:
    case Scheme::annealing:
    case Scheme::pixel:
        return true;
    case Scheme::basic:
    case Scheme::exproi:
    case Scheme::maxgain:
    case Scheme::exproi_maxgain:
    case Scheme::exproi_n_maxgain:
        return options.contour == 0; // the paper's know costs alone here
    case Scheme::lawson:
    case Scheme::look_ahead:
        return false;
    }
    return false;
}

void DeviceMesh::triangulate(const MeshOptions& options) {
    m_iterations = options.scheme == Scheme::pixel ? 0 : options.max_iterations;
    m_min_gain = min_gain(options);
    set_criterion(criterion(options));
    bind();
    prepare_lists(std::vector<Reach>(size_t(m_tiles)));
    m_before.clear();
    if (options.contour != 0)
        find_contours();
    start(options);
    if (m_iterations == 0)
        return;
    if (const std::optional<Rules> rules = find_rules(options))
        accept_reject(*rules);
    else if (options.scheme == Scheme::annealing)
        annealing(options);
    else
        one_round();
}

void DeviceMesh::set_criterion(const Criterion& by) {
    m_criterion = criterion_macros(by);
    m_contour_weight = by.contour * contour_unit;
}

void DeviceMesh::find_contours() {
    m_gpu.programs->use("contours.comp");
    m_contours.bind(Binding::contours);
    m_guide.bind(Binding::guide);
    // An invocation a cell.
    dispatch_over(m_shape.width - 1, m_shape.height - 1, start_group_x, start_group_y);
    barrier();
}

void DeviceMesh::prepare_lists(const std::vector<Reach>& reach) {
    std::vector<GLuint> head(counts_offset / sizeof(GLuint), 1);
    std::memcpy(&head[reach_offset / sizeof(GLuint)], reach.data(), reach.size() * sizeof(Reach));
    for (size_t i = 0; i < reach_offset / sizeof(GLuint); i += argument_words) {
        head[i] = 0;
        head[i + 1] = GLuint(m_tiles);
    }
    m_work.clear();
    m_work.write(0, counts_offset, head.data());
    bind_lists();
    m_gl.BindBuffer(GL_DISPATCH_INDIRECT_BUFFER, m_work.name());
}

void DeviceMesh::bind_lists() {
    m_sites.bind(Binding::sites);
    m_gain.bind(Binding::gains);
    m_contours.bind(Binding::contours);
    m_from->bind(Binding::from);
    m_to->bind(Binding::to);
    m_blocked_even.bind(Binding::blocked_even);
    m_blocked_odd.bind(Binding::blocked_odd);
    m_work.bind(Binding::work);
}

void DeviceMesh::start(const MeshOptions& options) {
    use("start.comp", 1, 1, m_criterion);
    m_gl.Uniform1i(at_flat_start, options.start == Start::flat);
    m_gl.Uniform1i(at_with_gains, m_iterations > 0);
    m_guide.bind(Binding::guide);
    dispatch_over(m_shape.width, m_shape.height, start_group_x, start_group_y);
    barrier(true);
    m_gains_known = false;
}

void DeviceMesh::one_round() {
    const int dispatched = std::min(m_iterations, m_dispatched);
    for (int i = 1; i <= dispatched; ++i) {
        if (i > 1) // else start() has
            step("evaluate.comp", i, Step::evaluate, m_criterion);
        step("select.comp", i, Step::select, {});
        step("flip.comp", i, Step::flip, {});
    }
    m_gains_known = true;
    if (m_iterations == dispatched) {
        step("evaluate.comp", dispatched + 1, Step::evaluate, m_criterion);
        return;
    }
    std::swap(m_from, m_to);
    bind_lists();
    // Four are at most some 60 000 turns: a tile of 321 x 321 pixels has 603 edges for each of the
    // group, in finish.comp every one takes 5 turns to be evaluated and 17 to find a blocker, and
    // every fifth 13 to be flipped. 32 are as many as accept_reject() allows of hardware.
    const int usual = m_gpu.context->short_loops ? 4 : 32,
              some = m_iterations_a_dispatch > 0 ? m_iterations_a_dispatch : usual;
    for (int i = dispatched + 1; i <= m_iterations + 1; i += some) { // one more: the gains
        use("finish.comp", i, m_iterations, m_criterion);
        m_gl.Uniform1i(at_iterations_a_dispatch, some);
        m_gl.DispatchCompute(GLuint(m_tiles), 1, 1);
        barrier();
    }
}

void DeviceMesh::step(const char* shader, int iteration, Step step, const std::string& defines) {
    std::swap(m_from, m_to);
    bind_lists();
    use(shader, iteration, iteration, defines);
    m_gl.DispatchComputeIndirect(GLintptr(arguments_of(iteration, step)));
    barrier(true);
}

void DeviceMesh::accept_reject(const Rules& rules) {
    const size_t marks = m_shape.sites() * size_t(m_capacity), word = sizeof(uint32_t);
    if (!m_marks)
        m_marks = std::make_unique<Buffer>(m_gl, bytes_of_all(MeshPart::marks));
    m_marks->clear();
    bind_lists();
    m_marks->bind(Binding::marks);
    use("accept_reject.comp", 1, m_iterations, m_criterion);
    m_gl.Uniform1i(at_by_gain, rules.by_gain);
    m_gl.Uniform1i(at_wide_iterations, rules.wide_iterations);
    // llvmpipe's loops turn 65535 times a dispatch. Drivers of hardware take a dispatch of seconds
    // for one that hangs: so many turns are half of one where each waits for memory, for a
    // microsecond.
    const int usual = m_gpu.context->short_loops ? 40000 : 500000,
              most_turns = m_turns_a_dispatch > 0 ? m_turns_a_dispatch : usual;
    m_gl.Uniform2i(at_progress, GLint(marks), most_turns);
    std::vector<uint32_t> progress(size_t(progress_size) * size_t(m_tiles));
    const auto goes_on = [&] {
        const std::vector<uint32_t> before = progress;
        m_marks->read(marks * word, progress.size() * word, progress.data());
        // Every dispatch takes each tile that has not ended a step on, from zeros at the beginning.
        if (progress == before)
            throw Failure("accept_reject.comp: a dispatch did nothing");
        bool all_ended = true;
        for (size_t t = 0; t < progress.size(); t += size_t(progress_size)) {
            if (progress[t] == progress_stuck)
                throw Failure("accept_reject.comp: no edge of a round was accepted");
            all_ended &= progress[t] == progress_ended;
        }
        return !all_ended;
    };
    do {
        m_gl.DispatchCompute(GLuint(m_tiles), 1, 1);
        barrier();
    } while (goes_on());
}

void DeviceMesh::annealing(const MeshOptions& options) {
    one_round();
    m_before = read_statistics();
    prepare_lists(read_reach());
    const uint64_t seed = mixed(options.seed);
    for (int i = 0; i < m_iterations; ++i) {
        anneal(annealing_salt(seed, i), seed, annealing_temperature(options.cost, i, m_iterations));
        // All of them asked for at once may take a slow device longer than is waited for it.
        finish(m_gl, "annealing");
    }
    bind_lists();
    use("evaluate.comp", 1, 1, m_criterion + " DENSE CANDIDATES");
    dispatch_over_sites();
    barrier(true);
    one_round();
}

void DeviceMesh::anneal(uint64_t salt, uint64_t seed, float temperature) {
    // What others need of these two buffers they write first.
    m_blocked_even.bind(Binding::drawn);
    m_blocked_odd.bind(Binding::decided);
    const auto dispatch = [&] {
        dispatch_over_sites();
        barrier();
    };
    use("anneal_draw.comp", 0, 0, {});
    set_annealing_uniforms(m_gl, {salt, seed, 0, temperature});
    dispatch();
    for (uint32_t part = 0; part < uint32_t(annealing_parts); ++part) {
        use("anneal_select.comp", 0, 0, m_criterion);
        set_annealing_uniforms(m_gl, {salt, seed, part, temperature});
        dispatch();
        use("anneal_flip.comp", 0, 0, {});
        dispatch();
    }
}

void DeviceMesh::find_gains(const Criterion& by) {
    if (m_gains_known)
        return;
    set_criterion(by);
    bind();
    if (by.contour != 0)
        find_contours();
    bind_lists();
    use("evaluate.comp", 0, 0, m_criterion + " DENSE");
    dispatch_over_sites();
    barrier();
    m_gains_known = true;
}

void DeviceMesh::use(const char* shader, int first_iteration, int last_iteration,
                     const std::string& defines) {
    m_gpu.programs->use(shader, defines);
    m_gl.Uniform1i(at_tiles, m_tiles);
    m_gl.Uniform1i(at_list_size, GLint(m_shape.edges()));
    m_gl.Uniform1i(at_first_iteration, first_iteration);
    m_gl.Uniform1i(at_last_iteration, last_iteration);
    m_gl.Uniform1f(at_min_gain, m_min_gain);
    if (defines.find("CONTOURS") != std::string::npos)
        m_gl.Uniform1f(at_contour_weight, m_contour_weight);
}

} // namespace ddt::gl
