// SPDX-License-Identifier: Apache-2.0
// The output of a tile whose positions come in any order, band by band of its cells.
#include <algorithm>

#include "core/tiles/tile_io.h"
#include "core/tiles/tile_writer.h"

namespace ddt {

int TileWriter::cells_in_band(int channels) {
    return std::clamp(96 / channels, 8, 32);
}

Outcome TileWriter::write_bands(RowsLeft& left) {
    const Tile& tile = m_meshed->tile;
    const int rows = cells_in_band(m_job.channels);
    begin_surfaces(with_cells(tile, left.all()), rows);
    take_memory(m_meshed->output);
    m_spans.begin(m_meshed->output);
    for (Rect cells = take(left, rows); !cells.empty(); cells = take(left, rows))
        if (const Outcome written = write_band(with_cells(tile, cells)); written != Outcome::done)
            return written;
    return outcome();
}

Outcome TileWriter::write_band(const Tile& band) {
    const auto y_of_cells = [&](int y) { return (y - band.pixels.y0) * int32_t(position_one); };
    make_edges_for(y_of_cells(band.cells.y1 - 1), y_of_cells(band.cells.y0));
    m_spans.find(band, m_job.window, m_mapping);
    for (int y = m_spans.y0(); y < m_spans.y1(); ++y) {
        const BandSpans::Span span = m_spans.row(y);
        if (span.empty())
            continue;
        const bool rest = m_spans.holds_rest(y);
        BandSpans::Span later{span.x1, span.x0};
        const Outcome outcome = each_panel({span.x0, y, span.x1, y + 1}, [&](const Rect& panel) {
            return write_runs(band, panel, rest ? &later : nullptr);
        });
        if (outcome != Outcome::done)
            return outcome;
        if (rest)
            m_spans.leave(y, later);
    }
    m_clock.lap(m_times.sample);
    return Outcome::done;
}

/// Write those of a row's pixels that are the band's. later: not null: receives those of bands
/// below too.
Outcome TileWriter::write_runs(const Tile& band, const Rect& row, BandSpans::Span* later) {
    const int width = row.width();
    m_mapping.row(row.y0, row.x0, row.x1, m_positions.data(), m_inside.data());
    const auto serves = [&](int i) {
        return m_inside[size_t(i)] && ddt::serves(band, m_positions[size_t(i)]);
    };
    for (int i = 0; i < width;) {
        if (!serves(i)) {
            const int x = row.x0 + i;
            if (later && m_inside[size_t(i)] && serves_below(band, m_positions[size_t(i)]))
                *later = {std::min(later->x0, x), std::max(later->x1, x + 1)};
            ++i;
            continue;
        }
        const int begin = i;
        for (; i < width && serves(i); ++i) {
            m_points[size_t(i - begin)] = local(band, m_positions[size_t(i)]);
            if (i > begin && !follows(m_points[size_t(i - begin) - 1], m_points[size_t(i - begin)]))
                break;
        }
        const int n = i - begin;
        m_out.resize(size_t(n) * size_t(m_job.channels) + row_padding);
        sample(n, m_out.data());
        const Rect run{row.x0 + begin, row.y0, row.x0 + i, row.y1};
        if (!hand_over(run))
            return Outcome::sink_failed;
        if (const Outcome job = wrote(run); job != Outcome::done)
            return job;
    }
    return Outcome::done;
}

} // namespace ddt
