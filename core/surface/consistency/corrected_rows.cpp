// SPDX-License-Identifier: Apache-2.0
#include "core/surface/consistency/corrected_rows.h"

#include <algorithm>

#include "core/lattice/neighbours.h"
#include "core/lattice/row_reach.h"
#include "core/surface/kept_rows.h"

namespace ddt {

namespace {

/// Rows of cells from the one whose means a round takes to the one before that a later round takes,
/// in most tiles at most.
constexpr int usual_rounds_apart = 16;

/// The same of a lattice: values are asked for some rows at once, beyond gradients beyond edges
/// beyond the cells whose means are taken.
int rounds_apart(const Lattice& lattice) {
    RowReach reach;
    reach.find(lattice);
    int most = 1;
    for (int y = 0; y < lattice.height(); ++y) {
        const int edges = reach.last_neighbour(y) + rows_at_once;
        most = std::max(most, reach.last_neighbour(reach.last_end(edges)) + 1 - y);
    }
    return most;
}

} // namespace

void CorrectedRows::begin(const Lattice& lattice, const Rect& part, const CorrectionRecipe& recipe,
                          const GroupValues& source) {
    m_lattice = &lattice;
    m_recipe = recipe;
    m_source = source;
    m_rounds.resize(size_t(recipe.rounds));
    for (Round& round : m_rounds)
        round.belong_to(*this);
    // What a round found the next still finds.
    m_crossed.begin(lattice, mean_positions(), rounds_apart(lattice));
    // Gradients and softness are made from what is round the ends of edges.
    Rect edges = part;
    for (size_t k = m_rounds.size(); k-- > 0;) {
        m_rounds[k].begin(with_neighbours(lattice, edges), k ? &m_rounds[k - 1] : nullptr);
        edges = m_rounds[k].part();
    }
}

void CorrectedRows::Round::begin(const Rect& moved, Round* before) {
    CorrectedRows& all = *m_all;
    m_moved = moved;
    m_rows = moved.y0;
    for (SourceRow& kept : m_source_rows)
        kept.y = -1;
    m_row.resize(size_t(all.m_lattice->width()) * size_t(count()) + edge_padding);
    const CorrectionRecipe& recipe = all.m_recipe;
    if (before)
        m_means.begin(*all.m_lattice, moved, recipe.surface, recipe.edges, *before, all.m_crossed);
    else
        m_means.begin(*all.m_lattice, moved, recipe.surface, recipe.edges, all.m_source,
                      all.m_crossed);
}

const float* CorrectedRows::Round::row(int y) {
    if (y < m_moved.y0 || y >= m_moved.y1)
        return source_row(y);
    for (; m_rows <= y; ++m_rows)
        correct();
    return m_row.data();
}

/// The source's row y; there until those three rows away are asked for.
const float* CorrectedRows::Round::source_row(int y) {
    SourceRow& kept = m_source_rows[y % 3];
    if (kept.y != y)
        kept.row = group_row(m_all->m_source, m_all->m_lattice->width(), y, kept.copied);
    kept.y = y;
    return kept.row;
}

void CorrectedRows::Round::correct() {
    const Lattice& lattice = *m_all->m_lattice;
    const int y = m_rows, width = lattice.width();
    const float* source = source_row(y);
    const float* sum = m_means.row(y, y);
    // The rim stays.
    const bool rim = y == 0 || y + 1 == lattice.height();
    const int x0 = std::max(m_moved.x0, 1), x1 = rim ? x0 : std::min(m_moved.x1, width - 1);
    const auto float_of = [&](int x) { return ptrdiff_t(x) * count(); };
    std::copy(source, source + float_of(std::min(x0, width)), m_row.begin());
    std::copy(source + float_of(x1), source + float_of(width), m_row.begin() + float_of(x1));
    if (x0 >= x1)
        return;
    move_row(lattice, m_means.net(), x0, x1, y, {source_row(y - 1), source, source_row(y + 1)}, sum,
             m_all->m_recipe.correction, m_row.data());
    copy_lanes(source + float_of(x0), x1 - x0, count(), m_all->m_recipe.kept_lanes,
               m_row.data() + float_of(x0));
}

int CorrectedRows::usual_rows_ahead(int rounds) {
    return rounds * usual_rounds_apart + 2 * rows_at_once;
}

int CorrectedRows::rows_ahead(const Lattice& lattice, int rounds) {
    return rounds * rounds_apart(lattice) + 2 * rows_at_once;
}

MemoryNeeded CorrectedRows::memory(int width, int height, int count,
                                   const CorrectionRecipe& recipe) {
    // Of the source, where it has more channels; what is made of it.
    const size_t rows = (3 + 1) * size_t(width) * size_t(count) * sizeof(float);
    const MemoryNeeded round =
        MemoryNeeded{0, rows} + MeanRows::memory(width, height, count, recipe.edges);
    return size_t(recipe.rounds) * round +
           MemoryNeeded{0, CrossedRows::memory(width, usual_rounds_apart)};
}

} // namespace ddt
