// SPDX-License-Identifier: Apache-2.0
#include "core/tiles/band_spans.h"

#include <algorithm>

#include "core/tiles/tile_io.h"

namespace ddt {

namespace {

/// Columns of cells whose reach is asked for: a turned band is long and narrow, and what holds all
/// of it would hold far more.
constexpr int columns_at_once = 32;

} // namespace

void BandSpans::begin(const Rect& all) {
    m_all = all;
    m_y0 = m_y1 = all.y0;
    m_left.assign(size_t(all.height()), {all.x0, all.x1});
    m_found.resize(m_left.size());
}

void BandSpans::find(const Tile& band, const Rect& window, const Mapping& mapping) {
    std::fill(m_found.begin(), m_found.end(), Span{m_all.x1, m_all.x0});
    m_y0 = m_all.y1;
    m_y1 = m_all.y0;
    const Rect& c = band.cells;
    for (int x = c.x0; x < c.x1; x += columns_at_once) {
        const Rect columns{x, c.y0, std::min(x + columns_at_once, c.x1), c.y1};
        const Rect r = reach_of(with_cells(band, columns), window, mapping);
        if (r.empty())
            continue;
        const int y0 = std::max(r.y0, m_all.y0), y1 = std::min(r.y1, m_all.y1);
        m_y0 = std::min(m_y0, y0);
        m_y1 = std::max(m_y1, y1);
        for (int y = y0; y < y1; ++y) {
            Span& row = m_found[index(y)];
            row = {std::min(row.x0, r.x0), std::max(row.x1, r.x1)};
        }
    }
}

BandSpans::Span BandSpans::row(int y) const {
    const Span &found = m_found[index(y)], &left = m_left[index(y)];
    return {std::max(found.x0, left.x0), std::min(found.x1, left.x1)};
}

bool BandSpans::holds_rest(int y) const {
    const Span &found = m_found[index(y)], &left = m_left[index(y)];
    return found.x0 <= left.x0 && left.x1 <= found.x1;
}

} // namespace ddt
