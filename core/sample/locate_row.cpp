#include "core/sample/evaluate.h"

#include <algorithm>

namespace ddt {

namespace {

constexpr float unit = 1.0f / float(position_one);

Span::Kind kind_of(const Edge& centre) {
    switch (division(centre)) {
    case Division::down:
        return Span::cell_down;
    case Division::up:
        return Span::cell_up;
    case Division::other:
        break;
    }
    return Span::triangle;
}

/// A triangle of the row before that p belongs to, or null; `hint` moves on along the row.
const Triangle* find_hint(const LocatedRow& row, size_t& hint, int i, Point p) {
    const auto& previous = row.previous_hints;
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

void include(const Triangle& t, Rect& reach) {
    const int x1 = t.at[0].x >> position_bits, y1 = t.at[0].y >> position_bits;
    const int x2 = t.at[1].x >> position_bits, y2 = t.at[1].y >> position_bits;
    const int x0 = x2 + t.e20.x, y0 = y2 + t.e20.y;
    reach.x0 = std::min({reach.x0, x0, x1, x2});
    reach.y0 = std::min({reach.y0, y0, y1, y2});
    reach.x1 = std::max({reach.x1, x0 + 1, x1 + 1, x2 + 1});
    reach.y1 = std::max({reach.y1, y0 + 1, y1 + 1, y2 + 1});
}

/// A cell's coordinate along an axis of `size` pixels: the last pixel belongs to the cell before
/// it.
int cell_of(int32_t position, int size) {
    const int cell = position >> position_bits;
    return cell < size - 1 ? cell : size - 2;
}

} // namespace

void locate_row(const Lattice& lattice, const Point* points, int n, LocatedRow& row) {
    row.spans.clear();
    for (auto& weight : row.weight)
        if (weight.size() < size_t(n) + row_padding)
            weight.resize(size_t(n) + row_padding);
    float *w0 = row.weight[0].data(), *w1 = row.weight[1].data(), *w2 = row.weight[2].data();
    row.hints.swap(row.previous_hints);
    row.hints.clear();
    size_t hint = 0;
    for (int i = 0; i < n;) {
        const Point p = points[i];
        const int cx = cell_of(p.x, lattice.width()), cy = cell_of(p.y, lattice.height());
        const int site = lattice.vertex_site(cx, cy);
        const Span::Kind kind = kind_of(lattice.edge(site + lattice.stride() + 1));
        const int begin = i;
        if (kind != Span::triangle) {
            int32_t x = p.x - cx * position_one, y = p.y - cy * position_one;
            do {
                w0[i] = float(x) * unit;
                w1[i] = float(y) * unit;
                if (++i == n)
                    break;
                x = points[i].x - cx * position_one;
                y = points[i].y - cy * position_one;
            } while (x >= 0 && x < position_one && y >= 0 && y < position_one);
            row.spans.push_back({kind, begin, i, {site, 0, 0}, {0, 0, 0}});
            continue;
        }
        const Triangle* known = find_hint(row, hint, i, p);
        row.hints.push_back({known ? *known : locate(lattice, p), 0});
        if (!known)
            include(row.hints.back().triangle, row.reach);
        const Triangle t = row.hints.back().triangle;
        int32_t w[3];
        t.weights(p, w);
        do {
            // On the rim, a tie may belong to a triangle that does not hold it; no weight is
            // negative all the same.
            w0[i] = float(w[0]) * unit;
            w1[i] = float(w[1]) * unit;
            w2[i] = float(w[2]) * unit;
            if (++i == n)
                break;
            t.weights(points[i], w);
        } while (t.holds(w));
        row.hints.back().end = i;
        row.spans.push_back({kind,
                             begin,
                             i,
                             {t.vertex[0], t.vertex[1], t.vertex[2]},
                             {t.edge[0], t.edge[1], t.edge[2]}});
    }
}

} // namespace ddt
