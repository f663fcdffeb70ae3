// SPDX-License-Identifier: Apache-2.0
#include "core/tiles/tile_writer.h"

#include <algorithm>

#include "core/base/float_mode.h"
#include "core/base/memory/stream_copy.h"
#include "core/tiles/channel_groups.h"
#include "core/tiles/tile_io.h"

namespace ddt {

namespace {

/// About as many floats of output as a thread takes from the rows that are left at a time.
constexpr size_t strip_floats = size_t(1) << 16;
/// About as many as are handed to the sink at a time where it has no place for them: 64 KiB, or
/// more if a row of cells has more.
constexpr size_t handed_floats = size_t(1) << 14;

/// Rows of so many floats, at least one, that take no more than `floats`.
int rows_of(size_t floats, size_t row) {
    return int(std::max<size_t>(1, floats / row));
}

/// Output pixels in a cell, about: those in the middle of a result.
struct InCell {
    int columns = 1, rows = 1; ///< these no more than are sampled together
};

InCell in_cell(const Mapping& mapping) {
    InCell found;
    const Rect out = output_of(mapping);
    if (!mapping.separable() || out.width() < 2 || out.height() < 2)
        return found;
    const int x = out.x0 + out.width() / 2 - 1, y = out.y0 + out.height() / 2 - 1;
    Position here[2], below;
    uint8_t inside[2];
    mapping.row(y, x, x + 2, here, inside);
    mapping.row(y + 1, x, x + 1, &below, inside);
    const auto in_step = [](int64_t from, int64_t to, int most) {
        const int64_t step = to - from;
        return step > 0 ? int(std::clamp<int64_t>((position_one + step / 2) / step, 1, most)) : 1;
    };
    found.columns = in_step(here[0].x, here[1].x, position_one);
    found.rows = in_step(here[0].y, below.y, LocatedBlock::most_rows);
    return found;
}

/// About as many output pixels as are worth being made by a thread of their own: each part of a
/// tile has the surface round it made once more.
constexpr size_t shared_pixels = size_t(3) << 13;

/// Floats of a result that is larger than what a core has of the caches, by far.
constexpr size_t least_past_caches = size_t(1) << 23;

} // namespace

MemoryNeeded TileWriter::memory(const Job& job, const Mapping& mapping, int width, int height) {
    const InCell pixels = in_cell(mapping);
    const size_t cells = size_t(std::min(width, tile_size));
    const size_t columns = std::min(cells * size_t(pixels.columns), size_t(panel_columns(job)));
    const bool grid = mapping.separable();
    // Where positions come in any order, a run of them may be as long as a panel.
    const size_t made = grid ? size_t(pixels.rows) * columns * size_t(job.channels) : strip_floats;
    const size_t out = std::max(handed_floats, made) + row_padding;
    const size_t spans = grid ? 0 : BandSpans::memory(most_rows_of_a_tile(job.window, mapping));
    return size_t(job.mesh.meshes) *
               TileSurface::memory(job, width, height, grid ? 1 : cells_in_band(job.channels)) +
           MemoryNeeded{0, (job.mesh.meshes > 1 ? 2 : 1) * out * sizeof(float) +
                               columns * (sizeof(Position) + sizeof(Point) + sizeof(float)) +
                               spans};
}

TileWriter::TileWriter(Sink& sink, const Mapping& mapping, const Job& job, StageTimes& times,
                       Arena& arena, JobState* state)
    : m_sink(sink), m_mapping(mapping), m_job(job), m_times(times), m_arena(arena), m_state(state) {
    m_past_caches = output_of(mapping).area() * size_t(job.channels) >= least_past_caches;
    m_rows_in_cell = in_cell(mapping).rows;
}

int TileWriter::panel_columns(const Job& job) {
    constexpr size_t most = size_t(1) << 14;
    return int(std::clamp<size_t>(strip_floats / size_t(job.channels), 1, most));
}

int TileWriter::least_shared_rows(int rows, const Rect& pixels) {
    return int(std::max<size_t>(1, shared_pixels * size_t(rows) / pixels.area()));
}

/// The tile with those of its cells alone that pixels of a grid lie in.
Tile TileWriter::part_of(const Tile& tile, const Rect& pixels) const {
    Position first, last;
    uint8_t inside = 0;
    m_mapping.row(pixels.y0, pixels.x0, pixels.x0 + 1, &first, &inside);
    m_mapping.row(pixels.y1 - 1, pixels.x1 - 1, pixels.x1, &last, &inside);
    const auto cell = [](int64_t position, int begin, int end) {
        return int(std::clamp<int64_t>(position >> position_bits, begin, end - 1));
    };
    const Rect& c = tile.cells;
    return with_cells(tile, {cell(first.x, c.x0, c.x1), cell(first.y, c.y0, c.y1), //
                             cell(last.x, c.x0, c.x1) + 1, cell(last.y, c.y0, c.y1) + 1});
}

/// Make the edges that positions at this y need; positions above `keep` are not asked for again.
void TileWriter::make_edges_for(int32_t y, int32_t keep) {
    m_clock.lap(m_times.sample);
    for (TileSurface& surface : m_surfaces)
        surface.make_edges_for(y, keep);
    m_clock.lap(m_times.surface);
}

/// The same for row y of those that are written; other columns of the same rows may come next.
void TileWriter::make_edges_for_row(int y) {
    make_edges_for(m_ys[size_t(y)], m_ys[m_panels ? 0 : size_t(y)]);
}

/// Whether columns lie at ascending positions, each so near to the one before that it follows it.
bool TileWriter::ascends(const Tile& tile, const Rect& row) {
    const size_t n = size_t(row.width());
    m_mapping.row(row.y0, row.x0, row.x1, m_positions.data(), m_inside.data());
    for (size_t i = 1; i < n; ++i) {
        const Point before = local(tile, m_positions[i - 1]), p = local(tile, m_positions[i]);
        if (p.x < before.x || !follows(before, p))
            return false;
    }
    return true;
}

bool TileWriter::is_grid(const Tile& tile, const Rect& pixels) {
    if (!m_mapping.separable())
        return false;
    take_memory(pixels);
    bool grid = true;
    each_panel({pixels.x0, pixels.y0, pixels.x1, pixels.y0 + 1}, [&](const Rect& panel) {
        grid = grid && ascends(tile, panel);
        return Outcome::done;
    });
    int32_t above = 0;
    for (int y = pixels.y0; grid && y < pixels.y1; ++y) {
        const int32_t here = y_of(tile, y, pixels.x0);
        grid = here >= above;
        above = here;
    }
    return grid;
}

/// Memory for rows as wide as these pixels, or panels of them.
void TileWriter::take_memory(const Rect& pixels) {
    const size_t width = size_t(std::min(pixels.width(), panel_columns(m_job)));
    m_positions.resize(width);
    m_inside.resize(width);
    m_points.resize(width);
    // Vectors that grow by themselves would take up to twice of it.
    m_out.reserve(handed_floats + row_padding);
    if (m_job.mesh.meshes > 1)
        m_last.reserve(handed_floats + row_padding);
}

/// Where a row of a separable mapping lies in the tile's lattice.
int32_t TileWriter::y_of(const Tile& tile, int y, int x) const {
    Position position;
    uint8_t inside = 0;
    m_mapping.row(y, x, x + 1, &position, &inside);
    return local(tile, position).y;
}

/// Find where the columns of `rows` of a grid lie.
void TileWriter::find_columns(const Tile& tile, const Rect& rows) {
    m_points.resize(size_t(rows.width()));
    m_mapping.row(rows.y0, rows.x0, rows.x1, m_positions.data(), m_inside.data());
    for (size_t i = 0; i < m_points.size(); ++i)
        m_points[i] = local(tile, m_positions[i]);
    m_columns.find(m_points.data(), int(m_points.size()), m_meshed->width);
}

Outcome TileWriter::write(RowsLeft& left) {
    m_clock.start();
    m_meshed = &left.of();
    while (m_surfaces.size() < m_meshed->meshes.size())
        m_surfaces.emplace_back(m_job, m_mapping);
    m_written = 0;
    const Outcome written = left.grid() ? write_grid(left) : write_bands(left);
    if (written == Outcome::done)
        report_written();
    return written;
}

/// Count these pixels, which were written; whether to go on.
Outcome TileWriter::wrote(const Rect& r) {
    m_written += int64_t(r.area()) * m_job.channels;
    if (m_written >= told_numbers)
        report_written();
    return outcome();
}

void TileWriter::report_written() {
    // Of numbers there may be more than 2^63.
    const double all = double(m_meshed->output.area()) * m_job.channels;
    if (m_state && m_written > 0 && all > double(told_numbers))
        m_state->wrote(m_written, all, m_meshed->index);
    m_written = 0;
}

/// Lay the surfaces over the cells of a part of the tile, of which so many rows are sampled at
/// once.
void TileWriter::begin_surfaces(const Tile& part, int cells) {
    m_arena.clear();
    for (size_t k = 0; k < m_surfaces.size(); ++k)
        m_surfaces[k].begin(m_meshed->meshes[k], part, cells, m_meshed->values.data(), m_arena);
    m_clock.lap(m_times.surface);
}

Outcome TileWriter::write_grid(RowsLeft& left) {
    const Tile& tile = m_meshed->tile;
    const Rect all = left.all();
    begin_surfaces(part_of(tile, all), 1);
    take_memory(all);
    const int width = int(m_points.size());
    m_panels = all.width() > width;
    if (!m_panels)
        find_columns(tile, all);
    const size_t row = size_t(width) * size_t(m_job.channels);
    const auto next = [&](int y) {
        return take(left, whole_cells(all, y, rows_of(strip_floats, row)));
    };
    for (Rect rows = next(all.y0); !rows.empty(); rows = next(rows.y1))
        if (const Outcome written = write_strip(rows); written != Outcome::done)
            return written;
    return outcome();
}

/// So many of a grid's rows from y on, or fewer that end where a row of cells does.
int TileWriter::whole_cells(const Rect& grid, int y, int rows) const {
    const auto cell = [&](int at) { return y_of(m_meshed->tile, at, grid.x0) >> position_bits; };
    for (int n = rows; n > 0 && y + n < grid.y1; --n)
        if (cell(y + n) != cell(y + n - 1))
            return n;
    return rows;
}

/// Rows of so many floats, of `height`, that are in m_out at a time.
int TileWriter::rows_together(int height, size_t row) const {
    return std::min(height, std::max(rows_of(handed_floats, row), m_rows_in_cell));
}

/// Write some rows of a grid.
Outcome TileWriter::write_strip(const Rect& rows) {
    const Tile& tile = m_meshed->tile;
    return each_panel(rows, [&](const Rect& part) {
        if (m_panels) {
            for (TileSurface& surface : m_surfaces)
                surface.begin_panel();
            find_columns(tile, part);
        }
        return write_rows(tile, part);
    });
}

void TileWriter::sample(int n, float* out) {
    m_surfaces[0].sample(m_points.data(), n, out);
    if (m_surfaces.size() > 1)
        m_last.resize(size_t(n) * size_t(m_job.channels) + row_padding);
    for (size_t k = 1; k < m_surfaces.size(); ++k) {
        m_surfaces[k].sample(m_points.data(), n, m_last.data());
        join(k, m_last.data(), size_t(n), out);
    }
}

/// Sample some of n rows at y[0], y[1], ..., `row` floats apart in `out`; returns how many.
int TileWriter::sample_block(const int32_t* y, int n, float* out, size_t row) {
    const int rows = m_surfaces[0].sample_block(m_columns, m_points, y, n, out, row);
    const size_t positions = m_points.size(), last_row = positions * size_t(m_job.channels);
    if (m_surfaces.size() > 1)
        m_last.resize(size_t(rows) * last_row);
    for (size_t k = 1; k < m_surfaces.size(); ++k) {
        m_surfaces[k].sample_block(m_columns, m_points, y, rows, m_last.data(), last_row);
        for (size_t r = 0; r < size_t(rows); ++r)
            join(k, m_last.data() + r * last_row, positions, out + r * row);
    }
    return rows;
}

/// Running mean over meshes: include in the mean of the first `mesh` of them the next one, whose
/// values are `last`. IDs remain the first's.
void TileWriter::join(size_t mesh, const float* last, size_t positions, float* mean) const {
    const DenormalsAreZero as_on_gpus;
    const float share = 1.0f / float(mesh + 1);
    const auto channels = size_t(m_job.channels);
    if (!any_nearest(m_job))
        return add_to_mean(last, positions * channels, share, mean);
    for (size_t i = 0; i < positions * channels; ++i)
        if (kind_of(m_job, int(i % channels)) != Channel::nearest)
            add_to_mean(last + i, 1, share, mean + i);
}

bool TileWriter::hand_over(const Rect& r) {
    m_clock.lap(m_times.sample);
    const bool taken = m_sink.write(r, m_out.data());
    m_clock.lap(m_times.write);
    return taken;
}

Outcome TileWriter::write_rows(const Tile& tile, const Rect& rows) {
    const auto channels = size_t(m_job.channels);
    m_ys.clear();
    for (int y = rows.y0; y < rows.y1; ++y)
        m_ys.push_back(y_of(tile, y, rows.x0));
    const bool blocks = !any_nearest(m_job);
    size_t row = 0;
    if (float* const place = blocks ? m_sink.place(rows, row) : nullptr) {
        place_rows(rows, place, row);
        return wrote(rows);
    }
    row = size_t(rows.width()) * channels;
    const int height = rows.height(), most = rows_together(height, row);
    m_out.resize(size_t(most) * row + row_padding);
    int handed = 0, made = 1; // rows: all that were, and what was made last
    const auto hand_over_to = [&](int y) {
        const Rect r{rows.x0, rows.y0 + handed, rows.x1, rows.y0 + y};
        handed = y;
        return hand_over(r);
    };
    for (int y = 0; y < height; y += made) {
        // Before a row of cells is divided.
        if (y > handed && y + made > handed + most && !hand_over_to(y))
            return Outcome::sink_failed;
        float* out = m_out.data() + size_t(y - handed) * row;
        make_edges_for_row(y);
        if (blocks) {
            made = sample_block(m_ys.data() + y, std::min(height, handed + most) - y, out, row);
            continue;
        }
        for (Point& p : m_points)
            p.y = m_ys[size_t(y)];
        sample(rows.width(), out);
    }
    return hand_over_to(height) ? wrote(rows) : Outcome::sink_failed;
}

/// The same of rows that the sink has a place for, `row` floats apart.
void TileWriter::place_rows(const Rect& rows, float* place, size_t row) {
    const int height = rows.height();
    const size_t own_row = size_t(rows.width()) * size_t(m_job.channels);
    const int most = rows_together(height, own_row);
    if (m_past_caches)
        m_out.resize(size_t(most) * own_row + row_padding);
    for (int y = 0; y < height;) {
        make_edges_for_row(y);
        const int32_t* ys = m_ys.data() + y;
        float* to = place + size_t(y) * row;
        if (!m_past_caches) {
            y += sample_block(ys, height - y, to, row);
            continue;
        }
        const int made = sample_block(ys, std::min(height - y, most), m_out.data(), own_row);
        for (int r = 0; r < made; ++r)
            stream_copy(m_out.data() + size_t(r) * own_row, own_row, to + size_t(r) * row);
        y += made;
    }
    if (m_past_caches)
        finish_streams();
    m_clock.lap(m_times.sample);
}

} // namespace ddt
