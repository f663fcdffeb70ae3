// Triangulation as dispatches. C++ twins: core/triangulate.
#include <algorithm>

#include "core/gl/mesh.h"
#include "ddt/names.h"

namespace ddt::gl {

namespace {

/// Iterations of one_round done by dispatches over all tiles; the rest by one group a tile
/// (finish.comp). By then a tile has a few thousand edges to look at, soon a few hundred.
constexpr int dispatched_iterations = 8;

} // namespace

bool Mesh::knows(const MeshOptions& options) {
    Rules rules;
    return options.scheme == Scheme::one_round || options.scheme == Scheme::pixel ||
           find_rules(options, rules);
}

void Mesh::triangulate(const MeshOptions& options) {
    m_dispatches = 0;
    m_iterations = options.scheme == Scheme::pixel ? 0 : options.max_iterations;
    m_min_gain = min_gain(options);
    m_cost = std::string("COST_") + cost_name(options.cost);
    bind();
    start(options);
    if (m_iterations == 0)
        return;
    prepare_lists();
    Rules rules;
    if (find_rules(options, rules))
        accept_reject(rules);
    else
        one_round();
}

void Mesh::start(const MeshOptions& options) {
    m_gpu.programs->use("start.comp");
    m_gl.Uniform1i(0, options.start == Start::flat);
    m_guide.bind(1);
    dispatch_over(m_shape.width, m_shape.height, 32, 4);
    barrier();
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

void Mesh::one_round() {
    evaluate_all(1);
    use("select.comp", 1, 1, " DENSE");
    dispatch_over(2 * m_shape.width - 1, 2 * m_shape.height - 1, 64, 2);
    barrier(true);
    use("flip.comp", 1, 1);
    dispatch_indirect(sizeof(GLuint) * 9);
    barrier(true);
    const int dispatched = std::min(m_iterations, dispatched_iterations);
    for (int i = 2; i <= dispatched; ++i)
        iteration(i);
    if (m_iterations == dispatched)
        return;
    use("finish.comp", dispatched + 1, m_iterations);
    m_gl.DispatchCompute(GLuint(m_tiles), 1, 1);
    ++m_dispatches;
    barrier();
}

void Mesh::iteration(int i) {
    const size_t arguments = sizeof(GLuint) * 6 * size_t(i);
    use("evaluate.comp", i, i);
    dispatch_indirect(arguments);
    barrier();
    use("select.comp", i, i);
    dispatch_indirect(arguments);
    barrier(true);
    use("flip.comp", i, i);
    dispatch_indirect(arguments + sizeof(GLuint) * 3);
    barrier(true);
}

void Mesh::accept_reject(const Rules& rules) {
    evaluate_all(1);
    use("accept_reject.comp", 1, m_iterations);
    m_gl.Uniform1i(5, rules.by_gain);
    m_gl.Uniform1i(6, rules.wide_iterations);
    m_gl.Uniform1i(7, rules.all_rounds);
    m_gl.DispatchCompute(GLuint(m_tiles), 1, 1);
    ++m_dispatches;
    barrier();
}

void Mesh::evaluate_all(int iteration) {
    use("evaluate.comp", iteration, iteration, " DENSE");
    dispatch_over(2 * m_shape.width - 1, 2 * m_shape.height - 1, 64, 2);
    barrier();
}

void Mesh::find_gains(Cost cost) {
    m_cost = std::string("COST_") + cost_name(cost);
    bind();
    bind_lists();
    evaluate_all(0); // counts as iteration 0, which nobody reads
}

void Mesh::use(const char* shader, int first_iteration, int last_iteration, const char* defines) {
    m_gpu.programs->use(shader, m_cost + defines);
    m_gl.Uniform1i(0, m_tiles);
    m_gl.Uniform1i(1, GLint(m_shape.edges()));
    m_gl.Uniform1i(2, first_iteration);
    m_gl.Uniform1i(3, last_iteration);
    m_gl.Uniform1f(4, m_min_gain);
}

void Mesh::dispatch_indirect(size_t offset) {
    m_gl.DispatchComputeIndirect(GLintptr(offset));
    ++m_dispatches;
}

} // namespace ddt::gl
