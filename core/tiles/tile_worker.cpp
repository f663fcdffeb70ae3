// SPDX-License-Identifier: Apache-2.0
#include "core/tiles/tile_worker.h"

#include <algorithm>
#include <cstdlib>

#include "core/base/arith.h"
#include "core/guide/contour.h"
#include "core/guide/guide.h"
#include "core/tiles/tile_io.h"

namespace ddt {

namespace {

/// Floats of output that are handed to the sink at once, about: half a megabyte.
constexpr size_t strip_floats = size_t(1) << 17;

/// Columns of output that are worked on at once: what is kept for each column stays small however
/// long the rows are.
int panel_columns(const Job& job) {
    constexpr size_t most = size_t(1) << 14;
    return int(std::clamp<size_t>(strip_floats / size_t(job.channels), 1, most));
}

/// Pixels of the largest tile along an axis of a window; a lattice has at least 2.
int largest_tile(int pixels) {
    return std::clamp(pixels, 2, tile_size + 1 + 2 * tile_halo);
}

} // namespace

size_t TileWorker::memory(const Job& job, bool separable) {
    const int width = largest_tile(job.window.width()), height = largest_tile(job.window.height());
    const size_t pixels = size_t(width) * size_t(height), sites = 4 * pixels;
    const size_t meshes = size_t(job.mesh.meshes) * TileMesh::memory(job, width, height, separable);
    // Gains, where no mesh keeps them, and work lists, which are longest in noise.
    const size_t workspace = (wants_gains(job.surface) ? 0 : sites * sizeof(float)) + pixels * 10;
    const size_t guides = job.mesh.meshes > 1 ? 2 : 1;
    const size_t planes = pixels * sizeof(float) * (guides + size_t(job.channels));
    const size_t contours = ContourRows::memory(width);
    return meshes + workspace + planes + contours + 2 * strip_floats * sizeof(float);
}

void TileWorker::reserve() {
    const size_t pixels =
        size_t(largest_tile(m_job.window.width())) * size_t(largest_tile(m_job.window.height()));
    const size_t sites = 4 * pixels;
    m_values.reserve(pixels * size_t(m_job.channels));
    m_guide.reserve(pixels);
    m_workspace.gain.reserve(sites);
    m_meshes.reserve(size_t(m_job.mesh.meshes));
    for (int k = 0; k < m_job.mesh.meshes; ++k)
        m_meshes.emplace_back(m_job).reserve(sites);
}

Outcome TileWorker::work(const Tile& tile, int first_row) {
    Rect reach = reach_of(tile, m_job.window, m_mapping);
    reach.y0 = std::max(reach.y0, first_row);
    if (reach.empty())
        return Outcome::done;
    if (m_meshes.empty())
        reserve();
    StageTimes& times = m_statistics.times;
    m_clock.start();
    if (!read(tile))
        return Outcome::source_failed;
    m_clock.lap(times.read);
    for (size_t k = 0; k < m_meshes.size(); ++k) {
        m_meshes[k].triangulate(guide_of(k), m_width, m_height, m_workspace, m_statistics);
        m_clock.lap(times.triangulate);
        m_meshes[k].make_surface(tile, m_values.data(), m_meshes.size() == 1);
        m_clock.lap(times.surface);
    }
    return write(tile, reach);
}

bool TileWorker::read(const Tile& tile) {
    m_workspace.origin_x = tile.pixels.x0 - m_job.window.x0;
    m_workspace.origin_y = tile.pixels.y0 - m_job.window.y0;
    return read_tile(m_source, tile, m_job, m_values, m_guide, m_width, m_height);
}

const float* TileWorker::guide_of(size_t mesh) {
    const float share = blur_share(m_job.mesh, int(mesh));
    const bool last = mesh + 1 == m_meshes.size();
    if (!last)
        m_blurred = m_guide;
    std::vector<float>& guide = last ? m_guide : m_blurred;
    if (share > 0)
        blur_guide(guide, m_width, m_height, share);
    return guide.data();
}

/// Make the edges that positions at this y need; positions above `keep` are not asked for again.
void TileWorker::make_edges_for(int32_t y, int32_t keep) {
    m_clock.lap(m_statistics.times.sample);
    for (TileMesh& mesh : m_meshes)
        mesh.make_edges_for(y, keep);
    m_clock.lap(m_statistics.times.surface);
}

/// Sampling follows a row from position to position, by exact arithmetic in 32 bits.
bool TileWorker::follows(const Point& a, const Point& b) {
    constexpr int32_t longest = 2 * position_one;
    return std::abs(b.x - a.x) <= longest && std::abs(b.y - a.y) <= longest;
}

/// Find where the columns of `rows`, of a separable mapping, lie. False if neighbours are too far
/// apart to be sampled as a grid.
bool TileWorker::find_columns(const Tile& tile, const Rect& rows) {
    m_points.resize(size_t(rows.width()));
    m_mapping.row(rows.y0, rows.x0, rows.x1, m_positions.data(), m_inside.data());
    for (size_t i = 0; i < m_points.size(); ++i)
        m_points[i] = local(tile, m_positions[i]);
    for (size_t i = 1; i < m_points.size(); ++i)
        if (!follows(m_points[i - 1], m_points[i]))
            return false;
    m_columns.find(m_points.data(), int(m_points.size()), m_width);
    return true;
}

/// Call f(panel) for parts of r that are no wider than a panel, from left to right, until it
/// returns something else than `done`.
template <class F>
Outcome TileWorker::each_panel(const Rect& r, F&& f) const {
    const int columns = panel_columns(m_job);
    for (int x = r.x0; x < r.x1; x += columns) {
        const Outcome outcome =
            f(Rect{x, r.y0, r.x0 + std::min(x - r.x0 + columns, r.width()), r.y1});
        if (outcome != Outcome::done)
            return outcome;
    }
    return Outcome::done;
}

Outcome TileWorker::write(const Tile& tile, const Rect& reach) {
    const int width = std::min(reach.width(), panel_columns(m_job));
    const bool panels = reach.width() > width;
    m_positions.resize(size_t(width));
    m_inside.resize(size_t(width));
    m_points.resize(size_t(width));
    bool grid = m_mapping.separable();
    if (grid)
        each_panel({reach.x0, reach.y0, reach.x1, reach.y0 + 1}, [&](const Rect& panel) {
            grid = grid && find_columns(tile, panel);
            return Outcome::done;
        });
    if (!grid)
        for (TileMesh& mesh : m_meshes)
            mesh.finish_edges();
    const size_t row = size_t(width) * size_t(m_job.channels);
    const int strip = grid ? int(std::max<size_t>(1, strip_floats / row)) : 1;
    for (int y = reach.y0; y < reach.y1; y += strip) {
        const Rect rows{reach.x0, y, reach.x1, std::min(y + strip, reach.y1)};
        const Outcome outcome = each_panel(rows, [&](const Rect& part) {
            if (panels)
                for (TileMesh& mesh : m_meshes)
                    mesh.begin_panel();
            if (!grid)
                return write_runs(tile, part);
            if (panels)
                find_columns(tile, part);
            return write_rows(tile, part, panels);
        });
        if (outcome != Outcome::done)
            return outcome;
    }
    return Outcome::done;
}

void TileWorker::sample(int n, float* out) {
    m_meshes[0].sample(m_points.data(), n, out);
    if (m_meshes.size() > 1)
        m_last.resize(size_t(n) * size_t(m_job.channels) + row_padding);
    for (size_t k = 1; k < m_meshes.size(); ++k) {
        m_meshes[k].sample(m_points.data(), n, m_last.data());
        join(k, m_last.data(), size_t(n), out);
    }
}

/// Sample some of n rows at y[0], y[1], ..., `row` floats apart in `out`; returns how many.
int TileWorker::sample_block(const int32_t* y, int n, float* out, size_t row) {
    const int rows = m_meshes[0].sample_block(m_columns, m_points, y, n, out, row);
    const size_t positions = m_points.size(), last_row = positions * size_t(m_job.channels);
    if (m_meshes.size() > 1)
        m_last.resize(size_t(rows) * last_row);
    for (size_t k = 1; k < m_meshes.size(); ++k) {
        m_meshes[k].sample_block(m_columns, m_points, y, rows, m_last.data(), last_row);
        for (size_t r = 0; r < size_t(rows); ++r)
            join(k, m_last.data() + r * last_row, positions, out + r * row);
    }
    return rows;
}

/// Make the mean of the first `mesh` meshes that of one more, whose values are `last`. Identifiers
/// remain the first's.
void TileWorker::join(size_t mesh, const float* last, size_t positions, float* mean) const {
    const DenormalsAreZero as_on_gpus;
    const float share = 1.0f / float(mesh + 1);
    const auto channels = size_t(m_job.channels);
    if (!any_nearest())
        return join_last(last, positions * channels, share, mean);
    for (size_t i = 0; i < positions * channels; ++i)
        if (kind_of(m_job, int(i % channels)) != Channel::nearest)
            join_last(last + i, 1, share, mean + i);
}

bool TileWorker::any_nearest() const {
    const auto& kinds = m_job.kinds;
    return std::find(kinds.begin(), kinds.end(), Channel::nearest) != kinds.end();
}

bool TileWorker::hand_over(const Rect& r) {
    m_clock.lap(m_statistics.times.sample);
    const bool taken = m_sink.write(r, m_out.data());
    m_clock.lap(m_statistics.times.write);
    return taken;
}

Outcome TileWorker::write_rows(const Tile& tile, const Rect& rows, bool panels) {
    const auto channels = size_t(m_job.channels);
    m_ys.clear();
    for (int y = rows.y0; y < rows.y1; ++y) {
        // Only y changes from row to row.
        m_mapping.row(y, rows.x0, rows.x0 + 1, m_positions.data(), m_inside.data());
        m_ys.push_back(local(tile, m_positions[0]).y);
    }
    const bool blocks = !any_nearest();
    size_t row = size_t(rows.width()) * channels, place_row = row;
    float* const place = blocks ? m_sink.place(rows, place_row) : nullptr;
    if (place)
        row = place_row; // a sink without a place may have set it to anything
    else
        m_out.resize(rows.area() * channels + row_padding);
    for (int y = 0; y < rows.height();) {
        float* out = (place ? place : m_out.data()) + size_t(y) * row;
        // Other columns of the same rows may come next.
        make_edges_for(m_ys[size_t(y)], m_ys[panels ? 0 : size_t(y)]);
        if (blocks) {
            y += sample_block(m_ys.data() + y, rows.height() - y, out, row);
            continue;
        }
        for (Point& p : m_points)
            p.y = m_ys[size_t(y)];
        sample(rows.width(), out);
        ++y;
    }
    if (!place)
        return hand_over(rows) ? Outcome::done : Outcome::sink_failed;
    m_clock.lap(m_statistics.times.sample);
    return Outcome::done;
}

Outcome TileWorker::write_runs(const Tile& tile, const Rect& row) {
    const int width = row.width();
    m_mapping.row(row.y0, row.x0, row.x1, m_positions.data(), m_inside.data());
    const auto serves = [&](int i) {
        return m_inside[size_t(i)] && ddt::serves(tile, m_positions[size_t(i)]);
    };
    for (int i = 0; i < width;) {
        if (!serves(i)) {
            ++i;
            continue;
        }
        const int begin = i;
        for (; i < width && serves(i); ++i) {
            m_points[size_t(i - begin)] = local(tile, m_positions[size_t(i)]);
            if (i > begin && !follows(m_points[size_t(i - begin) - 1], m_points[size_t(i - begin)]))
                break;
        }
        const int n = i - begin;
        m_out.resize(size_t(n) * size_t(m_job.channels) + row_padding);
        sample(n, m_out.data());
        if (!hand_over({row.x0 + begin, row.y0, row.x0 + i, row.y1}))
            return Outcome::sink_failed;
    }
    return Outcome::done;
}

} // namespace ddt
