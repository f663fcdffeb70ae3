// SPDX-License-Identifier: Apache-2.0
#include "core/surface/corrected_rows.h"

#include <algorithm>

#include "core/lattice/neighbours.h"
#include "core/surface/kept_rows.h"

namespace ddt {

void CorrectedRows::begin(const Lattice& lattice, const Rect& part, const CorrectionRecipe& recipe,
                          const GroupValues& group, float* values, const float* strict) {
    m_lattice = &lattice;
    m_recipe = recipe;
    m_group = group;
    m_values = values;
    m_limits = {strict, recipe.limit, recipe.clipped};
    const size_t row = size_t(lattice.width()) * group_size;
    take_memory(m_source, row, lattice.height());
    copy_group(group, lattice.vertices(), m_source.data());
    m_moved.resize(row);
    m_rounds.resize(size_t(recipe.rounds));
    // Gradients and softness are made from what is round the ends of edges.
    Rect edges = part;
    for (int k = recipe.rounds - 1; k >= 0; --k) {
        Round& round = m_rounds[size_t(k)];
        round.moved = with_neighbours(lattice, edges);
        round.rows = round.moved.y0;
        round.means.begin(lattice, round.moved, recipe.surface, recipe.edges, group, strict);
        edges = round.means.part();
    }
}

void CorrectedRows::make(int k, int end) {
    Round& round = m_rounds[size_t(k)];
    for (end = std::min(end, round.moved.y1); round.rows < end; ++round.rows) {
        if (k > 0)
            make(k - 1, round.means.values_end(round.rows));
        make_row(round);
    }
}

/// The rows that a round reads from are in its net already, so what it makes takes their place.
void CorrectedRows::make_row(Round& round) {
    const Lattice& lattice = *m_lattice;
    const int y = round.rows;
    const float* sum = round.means.row(y, y);
    // The rim stays.
    const int x0 = std::max(round.moved.x0, 1), x1 = std::min(round.moved.x1, lattice.width() - 1);
    if (y == 0 || y + 1 == lattice.height() || x0 >= x1)
        return;
    const float* source = m_source.data() + size_t(y) * size_t(lattice.width()) * group_size;
    find_limits(lattice, m_source.data(), x0, x1, y, m_limits, m_limit_row);
    move_row(lattice, round.means.net(), x0, x1, y, source, sum, m_limit_row, m_moved.data(),
             group_size);
    const float* from = m_moved.data();
    float* to = m_values + (ptrdiff_t(y) * lattice.width() + x0) * m_group.channels + m_group.first;
    for (int x = x0; x < x1; ++x, from += group_size, to += m_group.channels)
        for (int c = 0; c < m_group.count; ++c)
            if (!(m_recipe.kept_lanes >> c & 1u))
                to[c] = from[c];
}

size_t CorrectedRows::memory(int width, int height, int channels, const CorrectionRecipe& recipe) {
    const size_t row = size_t(width) * group_size * sizeof(float);
    return row * (size_t(height) + 3) +
           size_t(recipe.rounds) * MeanRows::memory(width, height, channels, recipe.edges);
}

} // namespace ddt
