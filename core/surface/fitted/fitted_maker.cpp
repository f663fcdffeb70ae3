// SPDX-License-Identifier: Apache-2.0
#include "core/surface/fitted/fitted_maker.h"

#include <algorithm>
#include <cstring>

#include "core/lattice/neighbours.h"
#include "core/surface/kept_rows.h"

namespace ddt {

void FittedMaker::begin(const Lattice& lattice, const Rect& part, const FittedRecipe& recipe,
                        const GroupValues& values, Net& net) {
    m_lattice = &lattice;
    m_net = &net;
    m_part = part;
    m_recipe = recipe;
    m_values = values;
    m_limits = {net.strict, recipe.limit, recipe.clipped};

    const int width = lattice.width(), height = lattice.height(), longest = lattice.longest();
    take_memory(m_source, row_size(), height);
    copy_group(values, size_t(width) * size_t(height), m_source.data());
    // Softness is made from what is round the ends of edges.
    m_moved = with_neighbours(lattice, part);
    EdgeRecipe edges{true, recipe.tau > 0 ? recipe.gain : nullptr, recipe.tau};
    m_plain.begin(lattice, m_moved, Surface::patch, edges, values, net.strict);
    // They are bent here.
    edges.bend = false;
    m_soft.begin_edge_rows(lattice, part, edges, net);

    net.stride = lattice.stride();
    net.first = lattice.vertex_site(0, m_moved.y0);
    take_memory(net.values, net_row(lattice),
                std::min(vertex_rows(longest) + rows_to_go_on, height));
    m_index_rows = 2 * longest + 2;
    take_memory(m_index, row_size(), m_index_rows);
    m_vertex_rows = m_moved.y0;
    m_edge_rows = 2 * part.y0;
}

void FittedMaker::to_row(int y, int keep) {
    // What is far above is made in steps, or all of it would have to be kept.
    for (int next = m_soft.rows() + rows_at_once;
         next < std::min({y, keep, m_part.y1 - rows_at_once}); next = m_soft.rows() + rows_at_once)
        go_on(next, next);
    go_on(y, keep);
}

void FittedMaker::go_on(int y, int keep) {
    const Lattice& lattice = *m_lattice;
    const int longest = lattice.longest();
    // Softness is made some rows at once, and asks for the apexes of its edges.
    const int end = std::min(y + rows_at_once + longest + 2, m_moved.y1);
    if (end > m_vertex_rows) {
        int first = m_net->first / (2 * lattice.stride());
        make_room(m_net->values, net_row(lattice), rows_to_go_on, lattice.height(), first,
                  std::min(std::min(keep, m_soft.rows()) - longest - 1, m_edge_rows / 2),
                  m_vertex_rows, end);
        m_net->first = lattice.vertex_site(0, first);
        while (m_vertex_rows < end)
            make_row();
    }
    m_soft.to_row(y, keep);
}

/// The next row of vertices, and the bends that are then due.
void FittedMaker::make_row() {
    const Lattice& lattice = *m_lattice;
    const int y = m_vertex_rows, longest = lattice.longest();
    const float* sums = m_plain.row(y, m_edge_rows / 2);
    const FittedSource source{lattice, m_source.data()};
    set_vertices(lattice, m_values, {m_moved.x0, y, m_moved.x1, y + 1}, *m_net);
    move_fitted(source, m_moved.x0, m_moved.x1, y, m_limits, sums,
                m_index.data() + size_t(y % m_index_rows) * row_size(), *m_net);
    for (int x = m_moved.x0; x < m_moved.x1 && m_recipe.kept_lanes; ++x)
        for (int c = 0; c < group_size; ++c)
            if (m_recipe.kept_lanes >> c & 1u)
                std::memcpy(m_net->at(lattice.vertex_site(x, y)) + c, source.at(x, y) + c,
                            sizeof(float));
    m_vertex_rows = y + 1;

    const int last = 2 * m_part.y1 - 1;
    const int end =
        m_vertex_rows == m_moved.y1 ? last : std::min(2 * (m_vertex_rows - longest), last);
    const IndexRows index{m_index.data(), m_index_rows, row_size()};
    for (; m_edge_rows < end; ++m_edge_rows)
        bend_fitted(source, m_part.x0, m_part.x1, m_edge_rows, m_recipe.gain, index, m_plain.net(),
                    *m_net);
}

size_t FittedMaker::memory(int width, int height, bool all_rows, bool soft) {
    static const float some_gain = 0;
    const float* gain = soft ? &some_gain : nullptr;
    const size_t row = size_t(width) * group_size * sizeof(float);
    return MeanRows::memory(width, height, {true, gain, 1}) +
           EdgeMaker::memory(width, height, all_rows ? height : usual_longest, {false, gain, 1}) +
           row * (size_t(height) + 2 * usual_longest + 2);
}

} // namespace ddt
