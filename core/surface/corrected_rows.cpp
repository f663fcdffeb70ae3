// SPDX-License-Identifier: Apache-2.0
#include "core/surface/corrected_rows.h"

#include <algorithm>
#include <cstring>

#include "core/lattice/neighbours.h"

namespace ddt {

namespace {

/// Of the source that a vertex's limits are found from: its own row and its neighbours.
constexpr int near_rows = 3;

size_t row_size(int width) {
    return size_t(width) * group_size;
}

} // namespace

void CorrectedRows::begin(const Lattice& lattice, const Rect& part, const CorrectionRecipe& recipe,
                          const GroupValues& source, const float* strict) {
    m_lattice = &lattice;
    m_recipe = recipe;
    m_source = source;
    m_limits = {strict, recipe.limit, recipe.clipped};
    m_rounds.resize(size_t(recipe.rounds));
    // Gradients and softness are made from what is round the ends of edges.
    Rect edges = part;
    for (size_t k = m_rounds.size(); k-- > 0;) {
        m_rounds[k].begin(*this, with_neighbours(lattice, edges), k ? &m_rounds[k - 1] : nullptr,
                          strict);
        edges = m_rounds[k].part();
    }
}

void CorrectedRows::Round::begin(const CorrectedRows& all, const Rect& moved, Round* before,
                                 const float* strict) {
    m_all = &all;
    m_moved = moved;
    m_rows = moved.y0;
    const size_t row = row_size(all.m_lattice->width());
    m_near.resize(near_rows * row);
    m_row.resize(row);
    const CorrectionRecipe& recipe = all.m_recipe;
    if (before)
        m_means.begin(*all.m_lattice, moved, recipe.surface, recipe.edges, *before, strict);
    else
        m_means.begin(*all.m_lattice, moved, recipe.surface, recipe.edges, all.m_source, strict);
}

const float* CorrectedRows::Round::row(int y) {
    if (y < m_moved.y0 || y >= m_moved.y1) {
        GroupValues source = m_all->m_source;
        const auto width = size_t(m_all->m_lattice->width());
        source.values += size_t(y) * width * size_t(source.channels);
        copy_group(source, width, m_row.data());
        return m_row.data();
    }
    for (; m_rows <= y; ++m_rows)
        correct();
    return m_row.data();
}

/// Load the source's rows above, at and below the next row, as far as there are any.
void CorrectedRows::Round::load_near() {
    const auto width = size_t(m_all->m_lattice->width());
    const size_t row = row_size(int(width));
    const int y = m_rows, last = m_all->m_lattice->height() - 1;
    // All of them at first; then what has come in sight.
    const bool first = y == m_moved.y0;
    if (!first)
        std::memmove(m_near.data(), m_near.data() + row, (near_rows - 1) * row * sizeof(float));
    for (int k = first ? -1 : 1; k <= 1; ++k) {
        if (y + k < 0 || y + k > last)
            continue;
        GroupValues source = m_all->m_source;
        source.values += size_t(y + k) * width * size_t(source.channels);
        copy_group(source, width, m_near.data() + size_t(k + 1) * row);
    }
}

void CorrectedRows::Round::correct() {
    const Lattice& lattice = *m_all->m_lattice;
    const int y = m_rows;
    load_near();
    const float* source = m_near.data() + row_size(lattice.width());
    std::copy_n(source, m_row.size(), m_row.begin());
    const float* sum = m_means.row(y, y);
    // The rim stays.
    const int x0 = std::max(m_moved.x0, 1), x1 = std::min(m_moved.x1, lattice.width() - 1);
    if (y == 0 || y + 1 == lattice.height() || x0 >= x1)
        return;
    find_limits(lattice.width(), near_rows, m_near.data(), x0, x1, 1, m_all->m_limits, m_limits);
    move_row(lattice, m_means.net(), x0, x1, y, source, sum, m_limits,
             m_row.data() + ptrdiff_t(x0) * group_size, group_size);
    for (int lane = 0; lane < group_size; ++lane)
        for (int x = x0; m_all->m_recipe.kept_lanes >> lane & 1u && x < x1; ++x)
            m_row[size_t(x * group_size + lane)] = source[x * group_size + lane];
}

size_t CorrectedRows::memory(int width, int height, const CorrectionRecipe& recipe) {
    // Beside the source's, what is made of it and its limits, low and high.
    const size_t rows = (near_rows + 3) * row_size(width) * sizeof(float);
    return size_t(recipe.rounds) * (rows + MeanRows::memory(width, height, recipe.edges));
}

} // namespace ddt
