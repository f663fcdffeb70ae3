// SPDX-License-Identifier: Apache-2.0
#include "core/sample/locate_row.h"

#include <algorithm>

#include "core/lattice/crossed_columns.h"
#include "core/lattice/crossed_search.h"
#include "core/surface/near_cells.h"

namespace ddt {

namespace {

/// Branch-free: the branch would be mispredicted.
Span::Kind kind_of(Division division) {
    constexpr Span::Kind kinds[] = {Span::cell_down, Span::cell_up, Span::triangle};
    return kinds[int(division)];
}

/// A triangle of the row before that p belongs to, or null; `hint` moves on along the row.
const Triangle* find_hint(const Search& search, size_t& hint, int i, Point p) {
    const auto& previous = search.previous_hints;
    while (hint < previous.size() && previous[hint].end <= i)
        ++hint;
    for (size_t h = hint; h < hint + 2 && h < previous.size(); ++h) {
        const Triangle& t = previous[h].triangle;
        int32_t w[3];
        if (!t.near(p))
            continue;
        t.weights(p, w);
        if (t.holds(w))
            return &t;
    }
    return nullptr;
}

/// Locates the positions of one row from left to right.
class RowLocator {
public:
    RowLocator(const Lattice& lattice, const Point* points, int n, Search& search, LocatedRow& row)
        : m_lattice(lattice), m_points(points), m_search(search), m_row(row) {
        row.spans.clear();
        for (auto& weight : row.weight)
            if (weight.size() < size_t(n) + row_padding)
                weight.resize(size_t(n) + row_padding);
        search.hints.swap(search.previous_hints);
        search.hints.clear();
    }

    /// Add the span of one triangle from `begin` on; returns where it ends, at most at `end`.
    int triangle(int begin, int end) {
        float *w0 = m_row.weight[0].data(), *w1 = m_row.weight[1].data(),
              *w2 = m_row.weight[2].data();
        int i = begin;
        const Point p = m_points[i];
        const Triangle* known = find_hint(m_search, m_hint, i, p);
        if (known)
            m_search.hints.emplace_back(*known);
        else
            m_search.hints.emplace_back(m_lattice, p);
        const Triangle& t = m_search.hints.back().triangle;
        int32_t w[3];
        t.weights(p, w);
        do {
            // On the rim, a tie may belong to a triangle that does not hold it; no weight is
            // negative all the same.
            w0[i] = float(w[0]) * position_unit;
            w1[i] = float(w[1]) * position_unit;
            w2[i] = float(w[2]) * position_unit;
            if (++i == end)
                break;
            t.weights(m_points[i], w);
        } while (t.holds(w));
        m_search.hints.back().end = i;
        Span& span = m_row.spans.emplace_back();
        span.kind = Span::triangle;
        span.begin = begin;
        span.end = i;
        for (int k = 0; k < 3; ++k)
            span.vertex[k] = t.vertex[k], span.edge[k] = t.edge[k];
        return i;
    }

    /// Add the span of a plain cell with first corner (cx, cy); returns where it ends.
    int cell(Span::Kind kind, int cx, int cy, int begin, int end) {
        float *w0 = m_row.weight[0].data(), *w1 = m_row.weight[1].data();
        int i = begin;
        int32_t x = m_points[i].x - cx * position_one, y = m_points[i].y - cy * position_one;
        do {
            w0[i] = float(x) * position_unit;
            w1[i] = float(y) * position_unit;
            if (++i == end)
                break;
            x = m_points[i].x - cx * position_one;
            y = m_points[i].y - cy * position_one;
        } while (x >= 0 && x < position_one && y >= 0 && y < position_one);
        m_row.spans.push_back({kind, begin, i, {m_lattice.vertex_site(cx, cy), 0, 0}, {0, 0, 0}});
        return i;
    }

private:
    const Lattice& m_lattice;
    const Point* m_points;
    Search& m_search;
    LocatedRow& m_row;
    size_t m_hint = 0;
};

} // namespace

void locate_row(const Lattice& lattice, const Point* points, int n, Search& search,
                LocatedRow& row) {
    RowLocator locator(lattice, points, n, search, row);
    for (int i = 0; i < n;) {
        const int cx = cell_of(points[i].x, lattice.width());
        const int cy = cell_of(points[i].y, lattice.height());
        const Span::Kind kind = kind_of(lattice.divisions(cy)[cx]);
        i = kind == Span::triangle ? locator.triangle(i, n) : locator.cell(kind, cx, cy, i, n);
    }
}

void Columns::find(const Point* points, int n, int width) {
    runs.clear();
    count = n;
    x.resize(size_t(n) + row_padding);
    for (int i = 0; i < n; ++i) {
        const int cell = cell_of(points[i].x, width);
        if (runs.empty() || runs.back().cell != cell)
            runs.push_back({cell, i, i});
        runs.back().end = i + 1;
        x[size_t(i)] = float(points[i].x - cell * position_one) * position_unit;
    }
    find_alike();
}

/// Find the longest stretch of such cells.
void Columns::find_alike() {
    // Fewer may not fill a vector.
    constexpr int least_cells = most_lanes;
    const auto follows = [&](const Run& last, const Run& run) {
        const int n = run.end - run.begin;
        return run.cell == last.cell + 1 && n == last.end - last.begin &&
               std::equal(&x[size_t(run.begin)], &x[size_t(run.begin)] + n, &x[size_t(last.begin)]);
    };
    alike = {};
    for (size_t i = 0, end = 0; i < runs.size(); i = end) {
        for (end = i + 1; end < runs.size() && follows(runs[end - 1], runs[end]);)
            ++end;
        const Alike found{runs[i].cell, int(end - i), runs[i].begin, runs[i].end - runs[i].begin};
        if (least_phases <= found.phases && found.phases <= most_phases &&
            found.cells >= std::max(least_cells, alike.cells + 1))
            alike = found;
    }
}

namespace {

/// Whether so many of these cells are plain that it is worth evaluating all as if they were
/// (measured): of two or three positions along x half of them, of four 5/8.
bool are_mostly_plain(const Division* divisions, const Columns::Alike& alike) {
    constexpr int least_eighths[] = {4, 4, 5};
    static_assert(least_phases == 2 && most_phases == 4, "the cases");
    if (alike.cells == 0)
        return false;
    int crossed = 0;
    for (int x = 0; x < alike.cells; ++x)
        crossed += divisions[x] == Division::crossed;
    return 8 * (alike.cells - crossed) >= least_eighths[alike.phases - least_phases] * alike.cells;
}

/// Find the crossed ones of cells in which positions lie alike, many at a time. Returns whether
/// that could be done.
bool find_crossed_alike(const Lattice& lattice, const Columns& columns, int cy,
                        LocatedBlock& block) {
    const Columns::Alike& alike = columns.alike;
    block.crossed.cells.clear();
    if (alike.cells == 0 || alike.phases * block.count > CrossedSearch::most_positions)
        return false;
    CellPositions positions;
    positions.set(columns.x.data() + alike.begin, alike.phases, block.y, block.count);
    find_crossed(lattice, positions, cy, alike.cell, alike.cell + alike.cells, block.crossed);
    return true;
}

/// Decide whether the cells in which positions lie alike are evaluated together, and if so flag how
/// they are divided.
void choose_phases(const Division* divisions, const Columns::Alike& alike, LocatedBlock& block) {
    const Division* alike_divisions = divisions + alike.cell;
    block.phases = are_mostly_plain(alike_divisions, alike);
    if (block.phases) {
        block.down.resize(size_t(alike.cells) + row_padding);
        flag_down(alike_divisions, 0, alike.cells, block.down.data());
    }
}

/// Find the triangles of the crossed cell (cx, cy) that a range is of.
void find_triangles(const Lattice& lattice, int cx, int cy, const CellPositions& positions,
                    LocatedBlock& block, LocatedBlock::Range& range) {
    range.triangle = int(block.crossing.size());
    // A vector that grows by itself would take up to twice of it.
    if (block.crossing.capacity() == 0)
        block.crossing.reserve(usual_crossing_triangles * size_t(lattice.width()));
    find_crossing_triangles(lattice, cx, cy, positions, block.crossing);
    range.triangles = int(block.crossing.size()) - range.triangle;
}

/// Add a range that is in rows, to the last one if that is and ends where it begins.
void add_in_rows(const LocatedBlock::Range& range, std::vector<LocatedBlock::Range>& ranges) {
    if (!ranges.empty() && ranges.back().is_in_rows() && ranges.back().end == range.begin)
        ranges.back().end = range.end;
    else
        ranges.push_back(range);
}

/// Find what the columns lie in, in row cy of cells, and the triangles of crossed cells. Returns
/// whether any of them have more positions than CellPositions.
bool find_ranges(const Lattice& lattice, const Columns& columns, int cy, LocatedBlock& block) {
    const int first_site = lattice.vertex_site(0, cy);
    const Division* divisions = lattice.divisions(cy);
    const Columns::Alike& alike = columns.alike;
    block.cell_row = cy;
    choose_phases(divisions, alike, block);
    std::vector<LocatedBlock::Range>& ranges = block.ranges;
    ranges.clear();
    ranges.reserve(columns.runs.size());
    block.crossing.clear();
    CellPositions positions;
    const bool crossed_found = find_crossed_alike(lattice, columns, cy, block);
    const auto is_found = [&](int cell) {
        return crossed_found && alike.cell <= cell && cell < alike.cell + alike.cells;
    };
    bool any_in_rows = false;
    // Of alike cells that are evaluated together only the crossed ones need a range.
    const int alike_end = block.phases ? alike.cell + alike.cells : 0;
    const auto crossed = [&](int x) { return crossed_cells(divisions + x); };
    const Columns::Run* const end = columns.runs.data() + columns.runs.size();
    const auto next = [&](const Columns::Run* run) {
        if (run == end)
            return end;
        if (block.phases && is_found(run->cell))
            return run + (alike_end - run->cell);
        return run + (next_crossed(run->cell, alike.cell, alike_end, crossed) - run->cell);
    };
    for (const Columns::Run* at = next(columns.runs.data()); at != end; at = next(at + 1)) {
        const Columns::Run& run = *at;
        LocatedBlock::Range range{kind_of(divisions[run.cell]), run.begin, run.end,
                                  first_site + 2 * run.cell};
        const int n = run.end - run.begin;
        if (range.is_cell()) {
            ranges.push_back(range);
        } else if (is_found(run.cell)) {
            continue;
        } else if (n * block.count <= CellPositions::most) {
            positions.set(columns.x.data() + run.begin, n, block.y, block.count);
            find_triangles(lattice, run.cell, cy, positions, block, range);
            ranges.push_back(range);
        } else {
            any_in_rows = true;
            add_in_rows(range, ranges);
        }
    }
    return any_in_rows;
}

} // namespace

int locate_block(const Lattice& lattice, const Columns& columns, std::vector<Point>& points,
                 const int32_t* y, int n, Search& search, LocatedBlock& block) {
    const int cy = cell_of(y[0], lattice.height());
    int& rows = block.count;
    for (rows = 0; rows < std::min(n, LocatedBlock::most_rows); ++rows) {
        if (cell_of(y[rows], lattice.height()) != cy)
            break;
        block.y[rows] = float(y[rows] - cy * position_one) * position_unit;
    }
    if (!find_ranges(lattice, columns, cy, block))
        return rows;
    for (int r = 0; r < rows; ++r) {
        RowLocator locator(lattice, points.data(), int(points.size()), search, block.rows[r]);
        for (const LocatedBlock::Range& range : block.ranges) {
            if (!range.is_in_rows())
                continue;
            for (int i = range.begin; i < range.end; ++i)
                points[size_t(i)].y = y[r];
            for (int i = range.begin; i < range.end;)
                i = locator.triangle(i, range.end);
        }
    }
    return rows;
}

} // namespace ddt
