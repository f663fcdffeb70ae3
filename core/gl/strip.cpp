// SPDX-License-Identifier: Apache-2.0
#include "core/gl/strip.h"

#include "core/tiles/tile_io.h"

namespace ddt::gl {

namespace {

/// Columns of the grid of invocations for positions that form no grid themselves.
constexpr int list_columns = 1024;

void plan_grid(const Mapping& mapping, const Tile& tile, Strip& strip) {
    const Rect& r = strip.rows;
    std::vector<Position> row(size_t(r.width()));
    std::vector<uint8_t> inside(row.size());
    mapping.row(r.y0, r.x0, r.x1, row.data(), inside.data());
    for (const Position& p : row)
        strip.positions.push_back(local(tile, p).x);
    for (int y = r.y0; y < r.y1; ++y) {
        mapping.row(y, r.x0, r.x0 + 1, row.data(), inside.data());
        strip.positions.push_back(local(tile, row[0]).y);
    }
    strip.plan.columns = r.width();
    strip.plan.rows = r.height();
    strip.plan.count = r.width() * r.height();
    strip.runs.push_back(r);
}

void plan_list(const Mapping& mapping, const Tile& tile, Strip& strip) {
    const Rect& r = strip.rows;
    std::vector<Position> row(size_t(r.width()));
    std::vector<uint8_t> inside(row.size());
    for (int y = r.y0; y < r.y1; ++y) {
        mapping.row(y, r.x0, r.x1, row.data(), inside.data());
        for (int x = r.x0; x < r.x1; ++x) {
            const auto i = size_t(x - r.x0);
            if (!inside[i] || !serves(tile, row[i]))
                continue;
            if (strip.runs.empty() || strip.runs.back().y0 != y || strip.runs.back().x1 != x)
                strip.runs.push_back({x, y, x, y + 1});
            ++strip.runs.back().x1;
            const Point p = local(tile, row[i]);
            strip.positions.push_back(p.x);
            strip.positions.push_back(p.y);
        }
    }
    strip.plan.count = int(strip.positions.size() / 2);
    strip.plan.columns = list_columns;
    strip.plan.rows = (strip.plan.count + list_columns - 1) / list_columns;
}

} // namespace

void plan_strip(const Mapping& mapping, const Tile& tile, int slot, Strip& strip) {
    strip.positions.clear();
    strip.runs.clear();
    strip.plan.slot = slot;
    strip.plan.separable = mapping.separable();
    if (strip.plan.separable)
        plan_grid(mapping, tile, strip);
    else
        plan_list(mapping, tile, strip);
}

} // namespace ddt::gl
