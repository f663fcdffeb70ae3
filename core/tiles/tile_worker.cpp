#include "core/tiles/tile_worker.h"

#include <algorithm>

#include "core/arith/arith.h"
#include "core/tiles/tile_io.h"

namespace ddt {

namespace {

/// Floats of output that are handed to the sink at once, about: half a megabyte.
constexpr size_t strip_floats = size_t(1) << 17;

/// Pixels of the largest tile of a window; a lattice has at least 2 x 2.
size_t largest_tile(const Rect& window) {
    const auto along = [](int pixels) {
        return size_t(std::clamp(pixels, 2, tile_size + 1 + 2 * tile_halo));
    };
    return along(window.width()) * along(window.height());
}

} // namespace

size_t TileWorker::memory(const Job& job) {
    const size_t pixels = largest_tile(job.window);
    const size_t sites = 4 * pixels;
    // Lattice, gains, work lists; then what the surface takes; guide and values.
    const size_t mesh =
        sites * (sizeof(Site) + sizeof(float) + 4 * sizeof(int)) + pixels * sizeof(Division);
    const size_t nets = sites * sizeof(float) * group_size * size_t(group_count(job.channels));
    const size_t soft = job.surface.soft > 0 ? nets : 0;
    const size_t gradients = sites * sizeof(float) * group_size / 2;
    const size_t consistency = job.surface.consistency > 0 ? 2 * gradients : 0;
    const size_t planes = pixels * sizeof(float) * (1 + size_t(job.channels));
    return mesh + nets + soft + gradients + consistency + planes + 2 * strip_floats * sizeof(float);
}

void TileWorker::reserve() {
    const size_t pixels = largest_tile(m_job.window), sites = 4 * pixels;
    m_values.reserve(pixels * size_t(m_job.channels));
    m_guide.reserve(pixels);
    m_lattice.reserve(sites);
    m_workspace.gain.reserve(sites);
    m_nets.resize(size_t(group_count(m_job.channels)));
    for (Net& net : m_nets)
        net.values.reserve(sites * group_size);
    if (m_job.surface.soft > 0)
        for (Net& net : m_nets)
            net.soft.reserve(sites * group_size);
    if (m_job.surface.kind != Surface::linear)
        m_edges.reserve(sites);
}

Outcome TileWorker::work(const Tile& tile, int first_row) {
    Rect reach = reach_of(tile, m_job.window, m_mapping);
    reach.y0 = std::max(reach.y0, first_row);
    if (reach.empty())
        return Outcome::done;
    if (m_nets.empty())
        reserve();
    StageTimes& times = m_statistics.times;
    m_clock.start();
    if (!read(tile))
        return Outcome::source_failed;
    m_clock.lap(times.read);
    triangulate_tile();
    m_clock.lap(times.triangulate);
    make_surface(tile);
    m_clock.lap(times.surface);
    return write(tile, reach);
}

bool TileWorker::read(const Tile& tile) {
    m_workspace.origin_x = tile.pixels.x0 - m_job.window.x0;
    m_workspace.origin_y = tile.pixels.y0 - m_job.window.y0;
    return read_tile(m_source, tile, m_job, m_values, m_guide, m_width, m_height);
}

void TileWorker::triangulate_tile() {
    const DenormalsAreZero as_on_gpus;
    m_lattice.start(m_width, m_height, m_guide.data(), m_job.mesh.start == Start::flat);
    triangulate(m_lattice, m_job.mesh, m_workspace, m_statistics);
}

void TileWorker::make_surface(const Tile& tile) {
    const DenormalsAreZero as_on_gpus;
    const SurfaceOptions& surface = m_job.surface;
    m_lattice.find_divisions();
    if (surface.kind != Surface::linear)
        m_lattice.find_first_edges();
    if (surface.soft > 0 && m_job.mesh.scheme != Scheme::one_round)
        find_gains(m_lattice, m_job.mesh.cost, m_workspace);

    const Rect whole{0, 0, m_lattice.width(), m_lattice.height()};
    for (int g = 0; g < int(m_nets.size()); ++g) {
        Net& net = m_nets[size_t(g)];
        set_vertices(m_lattice, m_values.data(), m_job.channels, g * group_size,
                     channels_in_group(m_job.channels, g), net);
        for (int c = 0; c < group_size; ++c)
            net.strict[c] = is_strict(m_job, g * group_size + c) ? 1.0f : 0.0f;
        if (surface.consistency == 0)
            continue;
        m_consistency.begin(m_lattice, net, surface.limit, surface.clipped);
        for (int round = 0; round < surface.consistency; ++round) {
            begin_edges(net, whole);
            m_edges.finish();
            m_consistency.correct(m_lattice, surface.kind, net);
        }
        m_consistency.restore(m_lattice, nearest_mask(m_job, g), net);
    }
    // The halo is not sampled, but triangles of the tile reach into it.
    const Rect &c = tile.cells, &p = tile.pixels;
    const int far = m_lattice.longest();
    const Rect part{std::max(c.x0 - far - p.x0, 0), std::max(c.y0 - far - p.y0, 0),
                    std::min(c.x1 + 1 + far - p.x0, whole.x1),
                    std::min(c.y1 + 1 + far - p.y0, whole.y1)};
    for (Net& net : m_nets) {
        begin_edges(net, part);
        // One net's edges are made as they are needed; several would want as many EdgeMakers.
        if (m_nets.size() > 1)
            m_edges.finish();
    }
}

void TileWorker::begin_edges(Net& net, const Rect& part) {
    const SurfaceOptions& surface = m_job.surface;
    m_edges.begin(m_lattice, part, surface.kind != Surface::linear,
                  surface.soft > 0 ? m_workspace.gain.data() : nullptr, surface.soft, net);
}

/// Make the edges that positions up to this y may need.
void TileWorker::make_edges_for(int32_t y) {
    if (m_nets.size() > 1)
        return;
    m_clock.lap(m_statistics.times.sample);
    const DenormalsAreZero as_on_gpus;
    m_edges.to_row((y >> position_bits) + m_lattice.longest());
    m_clock.lap(m_statistics.times.surface);
}

Outcome TileWorker::write(const Tile& tile, const Rect& reach) {
    const size_t row = size_t(reach.width()) * size_t(m_job.channels);
    m_positions.resize(size_t(reach.width()));
    m_inside.resize(size_t(reach.width()));
    m_points.resize(size_t(reach.width()));
    m_search.begin();
    if (m_mapping.separable()) {
        m_mapping.row(reach.y0, reach.x0, reach.x1, m_positions.data(), m_inside.data());
        for (size_t i = 0; i < m_points.size(); ++i)
            m_points[i] = local(tile, m_positions[i]);
        m_columns.find(m_points.data(), int(m_points.size()), m_lattice.width());
    } else if (m_nets.size() == 1)
        m_edges.finish();
    const int strip = m_mapping.separable() ? int(std::max<size_t>(1, strip_floats / row)) : 1;
    for (int y = reach.y0; y < reach.y1; y += strip) {
        const Rect rows{reach.x0, y, reach.x1, std::min(y + strip, reach.y1)};
        const Outcome outcome =
            m_mapping.separable() ? write_rows(tile, rows) : write_runs(tile, rows);
        if (outcome != Outcome::done)
            return outcome;
    }
    return Outcome::done;
}

void TileWorker::sample(int n, float* out) {
    const DenormalsAreZero as_on_gpus;
    locate_row(m_lattice, m_points.data(), n, m_search, m_row);
    for (int g = 0; g < int(m_nets.size()); ++g)
        evaluate_row(m_nets[size_t(g)], m_job.surface.kind, nearest_mask(m_job, g), m_row,
                     m_job.channels, g * group_size, channels_in_group(m_job.channels, g), out);
}

/// Sample some of n rows at y[0], y[1], ..., `row` floats apart in `out`; returns how many.
int TileWorker::sample_block(const int32_t* y, int n, float* out, size_t row) {
    const DenormalsAreZero as_on_gpus;
    const int rows = locate_block(m_lattice, m_columns, m_points, y, n, m_search, m_block);
    for (int g = 0; g < int(m_nets.size()); ++g)
        evaluate_block(m_nets[size_t(g)], m_job.surface.kind, m_columns, m_block, m_job.channels,
                       g * group_size, channels_in_group(m_job.channels, g), out, row);
    return rows;
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

Outcome TileWorker::write_rows(const Tile& tile, const Rect& rows) {
    const auto channels = size_t(m_job.channels);
    m_ys.clear();
    for (int y = rows.y0; y < rows.y1; ++y) {
        // Only y changes from row to row.
        m_mapping.row(y, rows.x0, rows.x0 + 1, m_positions.data(), m_inside.data());
        m_ys.push_back(local(tile, m_positions[0]).y);
    }
    const bool blocks = !any_nearest();
    size_t row = size_t(rows.width()) * channels;
    float* const place = blocks ? m_sink.place(rows, row) : nullptr;
    if (!place)
        m_out.resize(rows.area() * channels + row_padding);
    for (int y = 0; y < rows.height();) {
        float* out = (place ? place : m_out.data()) + size_t(y) * row;
        make_edges_for(m_ys[size_t(y)]);
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
        for (; i < width && serves(i); ++i)
            m_points[size_t(i - begin)] = local(tile, m_positions[size_t(i)]);
        const int n = i - begin;
        m_out.resize(size_t(n) * size_t(m_job.channels) + row_padding);
        sample(n, m_out.data());
        if (!hand_over({row.x0 + begin, row.y0, row.x0 + i, row.y1}))
            return Outcome::sink_failed;
    }
    return Outcome::done;
}

} // namespace ddt
