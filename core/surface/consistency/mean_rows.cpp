// SPDX-License-Identifier: Apache-2.0
#include "core/surface/consistency/mean_rows.h"

#include <algorithm>

#include "core/lattice/neighbours.h"

namespace ddt {

template <class Values>
void MeanRows::begin_any(const Lattice& lattice, const Rect& wanted, Surface surface,
                         const EdgeRecipe& recipe, Values& values, CrossedRows& crossed) {
    m_lattice = &lattice;
    m_wanted = wanted;
    m_surface = surface;
    m_crossed = &crossed;
    // The triangles that meet the cells round the vertices.
    m_edges.begin_rows(lattice, with_neighbours(lattice, grown(lattice, wanted, 1)), recipe, values,
                       m_net);
    m_sums.assign(2 * (size_t(lattice.width()) * size_t(m_net.count()) + edge_padding), 0.0f);
    m_cell_rows = std::max(wanted.y0 - 1, 0);
}

void MeanRows::begin(const Lattice& lattice, const Rect& wanted, Surface surface,
                     const EdgeRecipe& recipe, const GroupValues& values, CrossedRows& crossed) {
    begin_any(lattice, wanted, surface, recipe, values, crossed);
}

void MeanRows::begin(const Lattice& lattice, const Rect& wanted, Surface surface,
                     const EdgeRecipe& recipe, ValueRows& values, CrossedRows& crossed) {
    begin_any(lattice, wanted, surface, recipe, values, crossed);
}

const float* MeanRows::row(int y, int keep) {
    for (; m_cell_rows < std::min(y + 1, m_lattice->height() - 1); ++m_cell_rows) {
        const int cells = m_cell_rows;
        m_edges.to_cells(cells, std::min(cells, keep));
        add_means(*m_lattice, m_surface, m_net, m_wanted, cells, *m_crossed, m_scratch, sums(cells),
                  sums(cells + 1));
    }
    return sums(y);
}

MemoryNeeded MeanRows::memory(int width, int height, int count, const EdgeRecipe& recipe) {
    // Two rows of sums, four of quadrants' means.
    return EdgeMaker::memory(width, height, count, recipe) +
           MemoryNeeded{0, 6 * size_t(width) * size_t(count) * sizeof(float)};
}

} // namespace ddt
