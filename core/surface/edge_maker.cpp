// SPDX-License-Identifier: Apache-2.0
#include "core/surface/edge_maker.h"

#include <algorithm>
#include <cstring>

#include "core/base/large_pages.h"

namespace ddt {

namespace {

/// Rows of pixels that are made at a time, at least.
constexpr int rows_at_once = 8;

/// Floats that the gradients over so many sites take. A last row has no odd row after it, where its
/// gradients' y would be.
size_t gradient_count(size_t sites, size_t stride) {
    return 2 * (sites + stride) + edge_padding;
}

void load_vertices(const Lattice& lattice, const Rect& part, int y, const Net& net, float* row) {
    const int begin = std::max(part.x0 - 1, 0), end = std::min(part.x1 + 1, lattice.width());
    const float* z = net.at(lattice.vertex_site(begin, y));
    for (int x = begin; x < end; ++x, z += 2 * group_size)
        std::memcpy(row + ptrdiff_t(x) * group_size, z, group_size * sizeof(float));
}

void load_cells(const Lattice& lattice, const Rect& part, int y, CellRow& row) {
    const int begin = std::max(part.x0 - 1, 0), end = std::min(part.x1, lattice.width() - 1);
    const Division* divisions = lattice.divisions(y);
    for (int x = begin; x < end; ++x) {
        row.down[size_t(x)] = divisions[x] == Division::down ? 1.0f : 0.0f;
        row.other[size_t(x)] = divisions[x] == Division::other;
    }
}

} // namespace

void NearRows::resize(int width) {
    for (auto& row : vertices)
        row.resize(size_t(width) * group_size + edge_padding);
    for (CellRow& row : cells) {
        row.down.resize(size_t(width) + edge_padding);
        row.other.resize(size_t(width));
    }
}

void NearRows::begin(const Lattice& lattice, const Rect& part, int y, const Net& net) {
    if (y > 0)
        load_vertices(lattice, part, y - 1, net, vertices[(y - 1) % 3].data());
    load_below(lattice, part, y - 1, net);
}

void NearRows::load_below(const Lattice& lattice, const Rect& part, int y, const Net& net) {
    if (y + 1 >= lattice.height())
        return;
    load_vertices(lattice, part, y + 1, net, vertices[(y + 1) % 3].data());
    if (y >= 0)
        load_cells(lattice, part, y, cells[y % 2]);
}

void EdgeMaker::reserve(size_t sites) {
    reserve_large(m_scratch.gradients, gradient_count(sites, 0));
}

void EdgeMaker::begin(const Lattice& lattice, const Rect& part, bool bend, const float* gain,
                      float tau, Net& net) {
    m_lattice = &lattice;
    m_net = &net;
    m_part = part;
    m_bend = bend;
    m_gain = gain;
    m_reciprocal_tau = 1.0f / tau;
    m_gradient_rows = part.y0;
    m_edge_rows = 2 * part.y0;
    if (gain) {
        net.soft.resize(lattice.size() * group_size);
        m_scratch.weights.resize(2 * size_t(lattice.width()) + edge_padding);
    }
    m_scratch.edge_rows.resize(lattice.width());
    m_scratch.gradient_rows.resize(lattice.width());
    if (bend)
        m_scratch.gradients.resize(gradient_count(lattice.size(), size_t(lattice.stride())));
}

void EdgeMaker::to_row(int y) {
    if (2 * y < m_edge_rows)
        return;
    const int last = std::min(y + rows_at_once, m_part.y1 - 1);
    if (m_bend) {
        const int end = std::min(last + m_lattice->longest(), m_part.y1);
        make_gradients(*m_lattice, m_part, m_gradient_rows, end, *m_net, m_scratch);
        m_gradient_rows = std::max(m_gradient_rows, end);
    }
    if (m_bend || m_gain)
        make_edges(*m_lattice, m_part, m_edge_rows, 2 * last + 1, m_bend, m_gain, m_reciprocal_tau,
                   m_scratch, *m_net);
    m_edge_rows = 2 * last + 1;
}

} // namespace ddt
