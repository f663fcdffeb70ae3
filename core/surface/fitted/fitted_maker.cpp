// SPDX-License-Identifier: Apache-2.0
#include "core/surface/fitted/fitted_maker.h"

#include <algorithm>

#include "core/lattice/neighbours.h"

namespace ddt {

namespace {

/// Rows of indices that are in use at a time in most tiles, at most.
constexpr int usual_index_rows = 8;

/// As many rows as are in use at a time in this lattice: from the first that an edge ends in which
/// also ends in the last, or further down.
int most_index_rows(const RowReach& reach, int height) {
    int most = 1;
    for (int last = 0, row = 0; last < height; ++last) {
        while (reach.last_end(row) < last)
            ++row;
        most = std::max(most, last + 1 - reach.first_end(row - 1));
    }
    return most;
}

} // namespace

void FittedMaker::begin(const Lattice& lattice, const Rect& part, const FittedRecipe& recipe,
                        const GroupValues& values, ControlNet& net) {
    m_lattice = &lattice;
    m_reach.find(lattice);
    m_net = &net;
    m_part = part;
    m_recipe = recipe;
    m_values = values;

    const int count = values.count, height = lattice.height();
    m_source = values.values;
    if (values.count < values.channels) {
        take_memory(m_copied, row_size() * size_t(height));
        copy_group(values, lattice.vertices(), m_copied.data());
        m_source = m_copied.data();
    }
    // Softness is made from what is round the ends of edges.
    m_moved = with_neighbours(lattice, part);
    net.stride = lattice.stride();
    const int more = recipe.cells - 1;
    take_rows(lattice, count, m_moved.y0, usual_vertex_rows + more, recipe.arena, net.values.even);
    take_rows(lattice, count, part.y0, usual_edge_rows + more, recipe.arena, net.values.odd);
    EdgeRecipe edges{true, recipe.tau > 0, recipe.tau, nullptr, recipe.arena};
    edges.bounds = recipe.bounds;
    m_crossed.begin(lattice, mean_positions(), 1);
    m_plain.begin(lattice, m_moved, Surface::patch, edges, values, m_crossed);
    // They are bent here.
    edges.bend = false;
    edges.bent = true;
    edges.cells = recipe.cells;
    m_soft.begin_edge_rows(lattice, part, edges, net);

    m_index_rows = most_index_rows(m_reach, height);
    take_memory(m_index, row_size() * size_t(m_index_rows));
    m_vertex_rows = m_moved.y0;
    m_edge_rows = 2 * part.y0;
}

void FittedMaker::to_row(int y, int keep) {
    // As EdgeMaker's.
    for (int next = m_soft.rows() + rows_at_once; next < std::min(y, m_part.y1 - rows_at_once);
         next = m_soft.rows() + rows_at_once)
        go_on(next, std::min(next, keep));
    go_on(y, keep);
}

void FittedMaker::go_on(int y, int keep) {
    const Lattice& lattice = *m_lattice;
    // Softness is made some rows at once, and asks for the apexes of its edges.
    const int end = std::min(m_reach.last_neighbour(y + rows_at_once) + 1, m_moved.y1);
    if (end > m_vertex_rows) {
        const int used =
            std::min(m_reach.first_neighbour(std::min(keep, m_soft.rows())), m_edge_rows / 2);
        make_room(lattice, used, m_vertex_rows, end, m_net->values.even);
        make_room(lattice, used, (m_edge_rows + 1) / 2, bent_end(end) / 2 + 1, m_net->values.odd);
        while (m_vertex_rows < end)
            make_row();
    }
    m_soft.to_row(y, keep);
}

/// Rows of the doubled lattice before this are bent once rows of vertices before `vertices` are
/// there.
int FittedMaker::bent_end(int vertices) const {
    const int last = 2 * m_part.y1 - 1;
    if (vertices == m_moved.y1)
        return last;
    int row = m_edge_rows / 2;
    while (m_reach.last_end(row) < vertices)
        ++row;
    return std::clamp(2 * row - 1, m_edge_rows, last);
}

/// The next row of vertices, and the bends that are then due.
void FittedMaker::make_row() {
    const Lattice& lattice = *m_lattice;
    const int y = m_vertex_rows;
    const float* sums = m_plain.row(y, m_edge_rows / 2);
    const FittedSource source{lattice, m_source, m_values.count};
    set_vertices(lattice, m_values, {m_moved.x0, y, m_moved.x1, y + 1}, *m_net);
    move_fitted(source, m_moved.x0, m_moved.x1, y, m_recipe.correction, sums,
                m_index.data() + size_t(y % m_index_rows) * row_size(), *m_net);
    copy_lanes(source.at(m_moved.x0, y), m_moved.width(), m_values.count, m_recipe.kept_lanes,
               m_net->vertex(lattice.vertex_site(m_moved.x0, y)));
    m_vertex_rows = y + 1;

    const int end = bent_end(m_vertex_rows);
    const IndexRows index{m_index.data(), m_index_rows, row_size(), m_values.count};
    for (; m_edge_rows < end; ++m_edge_rows)
        bend_fitted(source, m_part, m_edge_rows, index, m_plain.net(), m_bends, *m_net);
}

MemoryNeeded FittedMaker::memory(int width, int height, const GroupValues& values, bool soft,
                                 int cells) {
    const size_t row = size_t(width) * size_t(values.count) * sizeof(float);
    const size_t copied = values.count < values.channels ? size_t(height) : 0;
    return MeanRows::memory(width, height, values.count, {true, soft, 1}) +
           EdgeMaker::memory(width, height, values.count,
                             {false, soft, 1, nullptr, nullptr, cells}) +
           MemoryNeeded{0, row * (copied + usual_index_rows) + 7 * size_t(width) * sizeof(float)};
}

} // namespace ddt
