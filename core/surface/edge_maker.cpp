// SPDX-License-Identifier: Apache-2.0
#include "core/surface/edge_maker.h"

#include <algorithm>

#include "core/surface/tame.h"

namespace ddt {

void EdgeMaker::begin(const Lattice& lattice, const Rect& part, const EdgeRecipe& recipe,
                      bool makes_vertices, int count, ControlNet& net) {
    m_lattice = &lattice;
    m_reach.find(lattice);
    m_net = &net;
    m_part = part;
    m_recipe = recipe;
    m_makes_vertices = makes_vertices;
    net.bounds = recipe.bounds;
    m_scratch.tame = makes_vertices; // as load_vertices() finds; of other values it is not known
    m_scratch.bent = recipe.bent;
    if (!recipe.fans)
        m_fans.begin(lattice, 1);
    m_scratch.fans = recipe.fans ? recipe.fans : &m_fans;
    const RowsInUse rows = most_in_use();
    m_gradient_rows = part.y0;
    m_edge_rows = 2 * part.y0;
    m_scratch.edge_cells.resize(lattice.width());
    m_scratch.gradient_cells.resize(lattice.width());
    // Above the part, edges that end there look for a gradient.
    const int top = m_reach.first_neighbour(part.y0);
    if (recipe.bend)
        take_rows(lattice, count, top, rows.edges, recipe.arena, m_scratch.gradients);
    if (makes_vertices) {
        net.stride = lattice.stride();
        m_vertex_rows = top;
        take_rows(lattice, count, top, rows.vertices, recipe.arena, net.values.even);
        take_rows(lattice, count, part.y0, rows.edges, recipe.arena, net.values.odd);
    }
    for (auto& weights : m_scratch.weights)
        weights.resize(recipe.soft ? size_t(lattice.width()) + edge_padding : 0);
    if (recipe.soft) {
        take_rows(lattice, count, part.y0, rows.edges, recipe.arena, net.soft.even);
        take_rows(lattice, count, part.y0, rows.edges, recipe.arena, net.soft.odd);
    }
}

void EdgeMaker::begin_edge_rows(const Lattice& lattice, const Rect& part, const EdgeRecipe& recipe,
                                ControlNet& net) {
    begin(lattice, part, recipe, false, net.count(), net);
}

void EdgeMaker::begin_rows(const Lattice& lattice, const Rect& part, const EdgeRecipe& recipe,
                           const GroupValues& values, ControlNet& net) {
    m_values = values;
    m_value_rows = nullptr;
    begin(lattice, part, recipe, true, values.count, net);
}

void EdgeMaker::begin_rows(const Lattice& lattice, const Rect& part, const EdgeRecipe& recipe,
                           ValueRows& values, ControlNet& net) {
    m_value_rows = &values;
    begin(lattice, part, recipe, true, values.count(), net);
}

/// Have rows of vertices before `end`, where rows before `keep` may go.
void EdgeMaker::load_vertices(int end, int keep) {
    const Lattice& lattice = *m_lattice;
    end = std::min(end, lattice.height());
    if (end <= m_vertex_rows)
        return;
    make_room(lattice, keep, m_vertex_rows, end, m_net->values.even);
    const int beside = lattice.longest() + 1;
    const Rect part{std::max(m_part.x0 - beside, 0), m_vertex_rows,
                    std::min(m_part.x1 + beside, lattice.width()), end};
    if (m_value_rows)
        set_vertices(lattice, *m_value_rows, part, *m_net);
    else
        set_vertices(lattice, m_values, part, *m_net);
    const auto row = size_t(part.width()) * size_t(m_net->count());
    for (int y = part.y0; y < part.y1 && m_scratch.tame; ++y)
        m_scratch.tame = all_tame(m_net->vertex(lattice.vertex_site(part.x0, y)), row);
    m_vertex_rows = end;
}

void EdgeMaker::to_row(int y, int keep) {
    // In steps of rows_at_once: one long advance would need every source row of that stretch at
    // once.
    for (int next = m_edge_rows / 2 + rows_at_once; next < std::min(y, m_part.y1 - rows_at_once);
         next = m_edge_rows / 2 + rows_at_once)
        go_on(next, std::min(next, keep));
    go_on(y, keep);
}

/// The last row of pixels whose edges are made when those of row y are.
int EdgeMaker::last_row(int y) const {
    return std::min(y + rows_at_once, m_part.y1 - 1);
}

/// Rows of values before this are read by go_on(y).
int EdgeMaker::values_end(int y) const {
    const int last = last_row(y);
    return m_reach.last_neighbour(m_recipe.bend ? m_reach.last_end(last) : last) + 1;
}

/// Where to_cells() is asked for some rows of cells after the others, and none above them is kept.
RowsInUse EdgeMaker::most_in_use() const {
    const int more = m_recipe.cells - 1;
    RowsInUse most{usual_vertex_rows + more, usual_edge_rows + more};
    for (int cells = m_part.y0; cells < m_part.y1; ++cells) {
        const int first = m_reach.first_neighbour(cells),
                  to = m_reach.last_neighbour(std::min(cells + more, m_part.y1 - 1));
        most.vertices = std::max(most.vertices, values_end(to) - first);
        most.edges = std::max(most.edges, last_row(to) + 1 - first);
    }
    return most;
}

void EdgeMaker::go_on(int y, int keep) {
    if (2 * y < m_edge_rows)
        return;
    const Lattice& lattice = *m_lattice;
    const int edges = m_edge_rows / 2, last = last_row(y);
    const int gradients = std::min(m_reach.last_end(last) + 1, m_part.y1);
    // The first row in use: of triangles with a vertex at or below row `keep`. Positions on the
    // last row belong to the cells before it.
    const int top = m_reach.first_neighbour(keep);
    const auto make_room_for_edges = [&](SiteRows& rows) {
        make_room(lattice, std::min(top, edges), (m_edge_rows + 1) / 2, last + 1, rows);
    };
    if (m_makes_vertices) {
        load_vertices(values_end(y),
                      std::min(top, m_reach.first_neighbour(std::min(edges, m_gradient_rows))));
        make_room_for_edges(m_net->values.odd);
    }
    if (m_recipe.soft) {
        make_room_for_edges(m_net->soft.even);
        make_room_for_edges(m_net->soft.odd);
    }
    if (m_recipe.bend) {
        make_room(lattice, m_reach.first_end(edges), m_gradient_rows, m_reach.last_end(last) + 1,
                  m_scratch.gradients);
        make_gradients(lattice, m_part, m_gradient_rows, gradients, *m_net, m_scratch);
    }
    m_gradient_rows = std::max(m_gradient_rows, gradients);
    if (m_recipe.bend || m_recipe.soft)
        make_edges(lattice, m_part, m_edge_rows, 2 * last + 1, m_recipe.bend, m_recipe.soft,
                   m_recipe.soft ? 1.0f / m_recipe.tau : 0.0f, m_scratch, *m_net);
    m_edge_rows = 2 * last + 1;
}

MemoryNeeded EdgeMaker::memory(int width, int height, int count, const EdgeRecipe& recipe) {
    const auto kept = [&](int used) {
        return rows_memory(width, height, count, used + recipe.cells - 1);
    };
    MemoryNeeded needed;
    const size_t edges = kept(usual_edge_rows);
    needed.rows =
        kept(usual_vertex_rows) + edges + (recipe.soft ? 2 * edges : 0) + (recipe.bend ? edges : 0);
    // Flags of four rows of cells, two rows of weights, one of columns; what each row reaches.
    needed.other = 7 * size_t(width) * sizeof(float) + 4 * size_t(height) * sizeof(int) +
                   (recipe.bend ? FanRows::memory(width, 1) : 0);
    return needed;
}

} // namespace ddt
