// SPDX-License-Identifier: Apache-2.0
#include "core/tiles/tile_io.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "core/base/zero_small.h"
#include "core/guide/guide.h"
#include "core/tiles/channel_groups.h"

namespace ddt {

namespace {

void repeat_to_two(float* v, int& width, int& height, int channels) {
    const auto n = size_t(channels);
    if (width == 1) {
        for (int y = height - 1; y >= 0; --y)
            for (size_t k = 2; k-- > 0;)
                std::memmove(v + (size_t(y) * 2 + k) * n, v + size_t(y) * n, n * sizeof(float));
        width = 2;
    }
    if (height == 1) {
        const size_t row = size_t(width) * n;
        std::memcpy(v + row, v, row * sizeof(float));
        height = 2;
    }
}

void zero_small_blended(float* values, size_t pixels, const Job& job) {
    const auto channels = size_t(job.channels);
    if (!any_nearest(job))
        return zero_small(values, pixels * channels, least_value);
    for (size_t i = 0; i < pixels; ++i)
        for (size_t c = 0; c < channels; ++c, ++values)
            if (kind_of(job, int(c)) != Channel::nearest)
                zero_small(values, 1, least_value);
}

bool in_columns(const Tile& tile, const Position& p) {
    const int64_t x = p.x >> position_bits;
    return x >= tile.cells.x0 && (tile.last_x || x < tile.cells.x1);
}

bool is_below(const Tile& tile, const Position& p) {
    return !tile.last_y && p.y >> position_bits >= tile.cells.y1;
}

} // namespace

Rect output_of(const Mapping& mapping) {
    constexpr double all = std::numeric_limits<double>::infinity();
    return mapping.reach(-all, -all, all, all);
}

Rect reach_of(const Tile& tile, const Rect& window, const Mapping& mapping) {
    constexpr double beyond = std::numeric_limits<double>::infinity();
    return mapping.reach(tile.cells.x0 == window.x0 ? -beyond : tile.cells.x0,
                         tile.cells.y0 == window.y0 ? -beyond : tile.cells.y0,
                         tile.last_x ? beyond : tile.cells.x1,
                         tile.last_y ? beyond : tile.cells.y1);
}

int most_rows_of_a_tile(const Rect& window, const Mapping& mapping) {
    const Grid grid = shown_tiles(window, mapping);
    int most = 0;
    for (int i = 0; i < grid.count(); ++i)
        if (const Rect reach = reach_of(grid.tile(i), window, mapping); !reach.empty())
            most = std::max(most, reach.height());
    return most;
}

Grid shown_tiles(const Rect& window, const Mapping& mapping) {
    const Grid all(window);
    if (all.count() == 1)
        return all;
    // Whole columns and rows of tiles: there may be many thousands of tiles, and few of them shown.
    const auto shown = [&](const Tile& first, const Tile& last) {
        Tile strip = first;
        strip.cells.x1 = last.cells.x1;
        strip.cells.y1 = last.cells.y1;
        strip.last_x = last.last_x;
        strip.last_y = last.last_y;
        return !reach_of(strip, window, mapping).empty();
    };
    const int columns = all.columns(), rows = all.rows(), last_row = (rows - 1) * columns;
    const auto column = [&](int i) { return shown(all.tile(i), all.tile(last_row + i)); };
    const auto row = [&](int i) {
        return shown(all.tile(i * columns), all.tile(i * columns + columns - 1));
    };
    const auto range = [](int n, const auto& is_shown, int& begin, int& end) {
        for (begin = 0; begin < n && !is_shown(begin);)
            ++begin;
        for (end = n; end > begin && !is_shown(end - 1);)
            --end;
    };
    Rect block;
    range(columns, column, block.x0, block.x1);
    range(rows, row, block.y0, block.y1);
    return all.block(block.empty() ? Rect{} : block);
}

bool serves(const Tile& tile, const Position& p) {
    return in_columns(tile, p) && p.y >> position_bits >= tile.cells.y0 && !is_below(tile, p);
}

bool serves_below(const Tile& tile, const Position& p) {
    return in_columns(tile, p) && is_below(tile, p);
}

Point local(const Tile& tile, const Position& p) {
    const auto along = [](int64_t position, int begin, int end) {
        const int64_t first = int64_t(begin) * position_one;
        // Before the difference is taken: a mapping may hand out any 64 bits.
        return int32_t(std::clamp(position, first, int64_t(end - 1) * position_one) - first);
    };
    return {along(p.x, tile.pixels.x0, tile.pixels.x1), along(p.y, tile.pixels.y0, tile.pixels.y1)};
}

bool follows(const Point& a, const Point& b) {
    constexpr int32_t longest = 2 * position_one;
    return std::abs(b.x - a.x) <= longest && std::abs(b.y - a.y) <= longest;
}

int lattice_width(const Tile& tile) {
    return std::max(tile.pixels.width(), 2);
}

int lattice_height(const Tile& tile) {
    return std::max(tile.pixels.height(), 2);
}

bool read_tile(Source& source, const Tile& tile, const Job& job, float* values, float* guide,
               int& width, int& height) {
    const Rect& r = tile.pixels;
    if (!source.read(r, values, guide))
        return false;
    clean_guide(guide, r.area());
    zero_small_blended(values, r.area(), job);
    width = r.width();
    height = r.height();
    int guide_width = width, guide_height = height;
    repeat_to_two(guide, guide_width, guide_height, 1);
    repeat_to_two(values, width, height, job.channels);
    return true;
}

bool read_tile(Source& source, const Tile& tile, const Job& job, std::vector<float>& values,
               std::vector<float>& guide, int& width, int& height) {
    const size_t pixels = size_t(lattice_width(tile)) * size_t(lattice_height(tile));
    values.resize(pixels * size_t(job.channels));
    guide.resize(pixels);
    return read_tile(source, tile, job, values.data(), guide.data(), width, height);
}

} // namespace ddt
