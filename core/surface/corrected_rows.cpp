// SPDX-License-Identifier: Apache-2.0
#include "core/surface/corrected_rows.h"

#include <algorithm>
#include <cstring>

#include "core/lattice/neighbours.h"

namespace ddt {

namespace {

/// Of the source that a vertex's limits are found from: its own row and its neighbours.
constexpr int near_rows = 3;

} // namespace

void CorrectedRows::begin(const Lattice& lattice, const Rect& part, const CorrectionRecipe& recipe,
                          const GroupValues& source, float* values, const float* strict) {
    m_lattice = &lattice;
    m_recipe = recipe;
    m_source = source;
    m_values = values;
    m_limits = {strict, recipe.limit, recipe.clipped};
    const size_t row = size_t(lattice.width()) * group_size;
    m_moved.resize(row);
    m_rounds.resize(size_t(recipe.rounds));
    // Gradients and softness are made from what is round the ends of edges.
    Rect edges = part;
    for (int k = recipe.rounds - 1; k >= 0; --k) {
        Round& round = m_rounds[size_t(k)];
        round.moved = with_neighbours(lattice, edges);
        round.rows = round.moved.y0;
        round.near.resize(size_t(near_rows) * row);
        GroupValues before = source;
        if (k > 0)
            before.values = values;
        round.means.begin(lattice, round.moved, recipe.surface, recipe.edges, before, strict);
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

/// The source's rows above, at and below the round's next row, none of which are the rim's.
const float* CorrectedRows::source_near(Round& round) const {
    const auto width = size_t(m_lattice->width()), row = width * group_size;
    const int y = round.rows;
    float* near = round.near.data();
    // All of them at first; then what has come in sight.
    const bool first = y == std::max(round.moved.y0, 1);
    if (!first)
        std::memmove(near, near + row, size_t(near_rows - 1) * row * sizeof(float));
    const int rows = first ? near_rows : 1;
    GroupValues come = m_source;
    come.values += size_t(y + 2 - rows) * width * size_t(m_source.channels);
    copy_group(come, size_t(rows) * width, near + size_t(near_rows - rows) * row);
    return near;
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
    const float* near = source_near(round);
    find_limits(lattice.width(), near_rows, near, x0, x1, 1, m_limits, m_limit_row);
    move_row(lattice, round.means.net(), x0, x1, y, near + size_t(lattice.width()) * group_size,
             sum, m_limit_row, m_moved.data(), group_size);
    const int channels = m_source.channels;
    const float* from = m_moved.data();
    float* to = m_values + (ptrdiff_t(y) * lattice.width() + x0) * channels + m_source.first;
    for (int x = x0; x < x1; ++x, from += group_size, to += channels)
        for (int c = 0; c < m_source.count; ++c)
            if (!(m_recipe.kept_lanes >> c & 1u))
                to[c] = from[c];
}

size_t CorrectedRows::memory(int width, int height, int channels, const CorrectionRecipe& recipe) {
    const size_t row = size_t(width) * group_size * sizeof(float);
    return 3 * row +
           size_t(recipe.rounds) *
               (size_t(near_rows) * row + MeanRows::memory(width, height, channels, recipe.edges));
}

} // namespace ddt
