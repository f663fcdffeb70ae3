// SPDX-License-Identifier: Apache-2.0
#include "core/surface/edge_maker.h"

#include <algorithm>
#include <cstring>

#include "core/surface/kept_rows.h"

namespace ddt {

namespace {

void load_row(const Lattice& lattice, const Rect& part, int y, const Net& net, float* row) {
    const int begin = std::max(part.x0 - 1, 0), end = std::min(part.x1 + 1, lattice.width());
    const float* z = net.at(lattice.vertex_site(begin, y));
    for (int x = begin; x < end; ++x, z += 2 * group_size)
        std::memcpy(row + ptrdiff_t(x) * group_size, z, group_size * sizeof(float));
}

void load_cells(const Lattice& lattice, const Rect& part, int y, CellRow& row) {
    const int begin = std::max(part.x0 - 1, 0), end = std::min(part.x1, lattice.width() - 1);
    const Division* divisions = lattice.divisions(y);
    flag_down(divisions, begin, end, row.down.data());
    uint8_t* other = row.other.data();
    for (int x = begin; x < end; ++x)
        other[x] = divisions[x] == Division::other;
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
        load_row(lattice, part, y - 1, net, vertices[(y - 1) % 3].data());
    load_below(lattice, part, y - 1, net);
}

void NearRows::load_below(const Lattice& lattice, const Rect& part, int y, const Net& net) {
    if (y + 1 >= lattice.height())
        return;
    load_row(lattice, part, y + 1, net, vertices[(y + 1) % 3].data());
    if (y >= 0)
        load_cells(lattice, part, y, cells[y % 2]);
}

void EdgeMaker::begin(const Lattice& lattice, const Rect& part, const EdgeRecipe& recipe,
                      bool few_values, bool few_edges, Net& net) {
    m_lattice = &lattice;
    m_net = &net;
    m_part = part;
    m_recipe = recipe;
    m_few_values = few_values;
    m_few_edges = few_edges;
    const auto rows = [&](int used) { return std::min(used + rows_to_go_on, lattice.height()); };
    m_gradient_rows = part.y0;
    m_edge_rows = 2 * part.y0;
    m_scratch.edge_rows.resize(lattice.width());
    m_scratch.gradient_rows.resize(lattice.width());
    // Above the part, edges that end there look for a gradient.
    const int top = few_edges ? std::max(part.y0 - lattice.longest() - 1, 0) : 0;
    m_scratch.first = lattice.vertex_site(0, top);
    if (recipe.bend && few_edges)
        take_memory(m_scratch.gradients, net_row(lattice) / 2, rows(edge_rows(lattice.longest())));
    else if (recipe.bend)
        m_scratch.gradients.resize(2 * (lattice.size() + size_t(lattice.stride())) + edge_padding);
    if (few_values) {
        net.stride = lattice.stride();
        net.first = lattice.vertex_site(0, top);
        m_vertex_rows = top;
        take_memory(net.values, net_row(lattice), rows(vertex_rows(lattice.longest())));
    }
    if (recipe.gain) {
        m_scratch.weights.resize(2 * size_t(lattice.width()) + edge_padding);
        net.first_soft = few_edges ? lattice.vertex_site(0, part.y0) : 0;
        if (few_edges)
            take_memory(net.soft, net_row(lattice), rows(edge_rows(lattice.longest())));
        else
            net.soft.resize(lattice.size() * group_size);
    }
}

void EdgeMaker::begin(const Lattice& lattice, const Rect& part, const EdgeRecipe& recipe,
                      Net& net) {
    begin(lattice, part, recipe, false, false, net);
}

void EdgeMaker::begin_edge_rows(const Lattice& lattice, const Rect& part, const EdgeRecipe& recipe,
                                Net& net) {
    begin(lattice, part, recipe, false, true, net);
}

void EdgeMaker::begin_rows(const Lattice& lattice, const Rect& part, const EdgeRecipe& recipe,
                           const GroupValues& values, Net& net) {
    m_values = values;
    m_value_rows = nullptr;
    begin(lattice, part, recipe, true, true, net);
}

void EdgeMaker::begin_rows(const Lattice& lattice, const Rect& part, const EdgeRecipe& recipe,
                           ValueRows& values, Net& net) {
    m_value_rows = &values;
    begin(lattice, part, recipe, true, true, net);
}

/// Have rows of vertices before `end`, where rows before `keep` may go.
void EdgeMaker::load_vertices(int end, int keep) {
    const Lattice& lattice = *m_lattice;
    end = std::min(end, lattice.height());
    if (end <= m_vertex_rows)
        return;
    int first = m_net->first / (2 * lattice.stride());
    make_room(m_net->values, net_row(lattice), rows_to_go_on, lattice.height(), first, keep,
              m_vertex_rows, end);
    m_net->first = lattice.vertex_site(0, first);
    const int beside = lattice.longest() + 1;
    const Rect part{std::max(m_part.x0 - beside, 0), m_vertex_rows,
                    std::min(m_part.x1 + beside, lattice.width()), end};
    if (m_value_rows)
        set_vertices(lattice, *m_value_rows, part, *m_net);
    else
        set_vertices(lattice, m_values, part, *m_net);
    m_vertex_rows = end;
}

void EdgeMaker::to_row(int y, int keep) {
    // What is far above is made in steps, or all of it would have to be kept.
    for (int next = m_edge_rows / 2 + rows_at_once;
         m_few_edges && next < std::min({y, keep, m_part.y1 - rows_at_once});
         next = m_edge_rows / 2 + rows_at_once)
        go_on(next, next);
    go_on(y, keep);
}

/// The last row of pixels whose edges are made when those of row y are.
int EdgeMaker::last_row(int y) const {
    return std::min(y + rows_at_once, m_part.y1 - 1);
}

/// Rows before this have gradients then.
int EdgeMaker::gradients_end(int last) const {
    return std::min(last + m_lattice->longest(), m_part.y1);
}

/// Rows of values before this are read by go_on(y).
int EdgeMaker::values_end(int y) const {
    const int last = last_row(y), end = std::max(gradients_end(last) - 1, last);
    return std::min(end + m_lattice->longest() + 1, m_lattice->height());
}

void EdgeMaker::go_on(int y, int keep) {
    if (2 * y < m_edge_rows)
        return;
    const Lattice& lattice = *m_lattice;
    const int longest = lattice.longest(), edges = m_edge_rows / 2;
    const int last = last_row(y), gradients = gradients_end(last);
    // What is above the first row in use: a triangle's vertices and edges, and one row more, as
    // positions on the last row belong to the cells before it.
    const int top = keep - longest - 1;
    const auto row_of = [&](int site) { return site / (2 * lattice.stride()); };
    if (m_few_values)
        load_vertices(values_end(y), std::min(top, std::min(edges, m_gradient_rows) - longest - 1));
    if (m_few_edges && m_recipe.gain) {
        int first = row_of(m_net->first_soft);
        make_room(m_net->soft, net_row(lattice), rows_to_go_on, lattice.height(), first,
                  std::min(top, edges), (m_edge_rows + 1) / 2, last + 1);
        m_net->first_soft = lattice.vertex_site(0, first);
    }
    if (m_few_edges && m_recipe.bend) {
        int first = row_of(m_scratch.first);
        make_room(m_scratch.gradients, net_row(lattice) / 2, rows_to_go_on, lattice.height(), first,
                  edges - longest - 1, m_gradient_rows,
                  std::min(last + longest + 1, lattice.height()));
        m_scratch.first = lattice.vertex_site(0, first);
    }
    if (m_recipe.bend)
        make_gradients(lattice, m_part, m_gradient_rows, gradients, *m_net, m_scratch);
    m_gradient_rows = std::max(m_gradient_rows, gradients);
    if (m_recipe.bend || m_recipe.gain)
        make_edges(lattice, m_part, m_edge_rows, 2 * last + 1, m_recipe.bend, m_recipe.gain,
                   1.0f / m_recipe.tau, m_scratch, *m_net);
    m_edge_rows = 2 * last + 1;
}

size_t EdgeMaker::memory(int width, int height, int longest, const EdgeRecipe& recipe) {
    const auto kept = [&](int used) { return size_t(std::min(used + rows_to_go_on, height)); };
    const size_t row = 4 * size_t(width) * group_size * sizeof(float);
    const size_t edges = kept(edge_rows(longest)) * row;
    return kept(vertex_rows(longest)) * row + (recipe.gain ? edges : 0) +
           (recipe.bend ? edges / 2 : 0);
}

} // namespace ddt
