#include <cstring>

#include "core/sample/evaluate.h"

namespace ddt {

namespace {

constexpr float unit = 1.0f / float(position_one);

/// The two triangles of a cell that its own diagonal divides, which most cells are. By the tie rule
/// a position on the diagonal belongs to the second triangle.
///
///     down: 0 > 1    up:  0 > 1     first triangle of `down`: (0,0) (1,1) (0,1), second:
///           | \ |         | / |     (0,0) (1,0) (1,1); of `up`: (0,0) (1,0) (0,1) and
///           2 > 3         2 > 3     (1,0) (1,1) (0,1).
enum class Cell { down, up, other };

Cell kind_of(const Edge& diagonal) {
    // The diagonal may run either way; its apexes must be the cell's other corners.
    const Vec v = diagonal.v.y < 0 ? -diagonal.v : diagonal.v;
    const Vec apex = diagonal.left;
    if (diagonal.left != -diagonal.right)
        return Cell::other;
    if (v == Vec(1, 1) && (apex == Vec(-1, 1) || apex == Vec(1, -1)))
        return Cell::down;
    if (v == Vec(-1, 1) && (apex == Vec(-1, -1) || apex == Vec(1, 1)))
        return Cell::up;
    return Cell::other;
}

/// Adds spans and weights position by position.
class RowWriter {
public:
    RowWriter(const Lattice& lattice, LocatedRow& row, int n) : m_lattice(lattice), m_row(row) {
        row.spans.clear();
        row.weights.resize(size_t(n) * 3);
        m_out = row.weights.data();
    }

    /// The triangle of three corners of a cell, in Triangle's order; `site` is the cell's vertex.
    void begin_span(int site, Vec p0, Vec p1, Vec p2, int begin) {
        const int o0 = m_lattice.offset(p0), o1 = m_lattice.offset(p1), o2 = m_lattice.offset(p2);
        m_row.spans.push_back({{site + 2 * o0, site + 2 * o1, site + 2 * o2},
                               {site + o0 + o1, site + o1 + o2, site + o2 + o0},
                               begin,
                               begin});
    }
    void begin_span(const Triangle& t, int begin) {
        m_row.spans.push_back({{t.vertex[0], t.vertex[1], t.vertex[2]},
                               {t.edge[0], t.edge[1], t.edge[2]},
                               begin,
                               begin});
    }
    void add(int32_t w0, int32_t w1, int32_t w2) {
        m_out[0] = float(w0) * unit;
        m_out[1] = float(w1) * unit;
        m_out[2] = float(w2) * unit;
        m_out += 3;
    }
    void end_span(int end) { m_row.spans.back().end = end; }

private:
    const Lattice& m_lattice;
    LocatedRow& m_row;
    float* m_out;
};

/// The positions from i on that lie in one cell of kind `down` or `up`; returns the first beyond.
int locate_in_cell(Cell kind, int cx, int cy, int site, const Point* points, int i, int n,
                   RowWriter& writer) {
    constexpr int32_t one = position_one;
    int32_t fx = points[i].x - cx * one, fy = points[i].y - cy * one;
    const auto next = [&] {
        if (++i == n)
            return false;
        fx = points[i].x - cx * one;
        fy = points[i].y - cy * one;
        return fx >= 0 && fx < one && fy >= 0 && fy < one;
    };
    for (bool inside = true; inside;) {
        if (kind == Cell::down && fx < fy) {
            writer.begin_span(site, {0, 0}, {1, 1}, {0, 1}, i);
            for (; inside && fx < fy; inside = next())
                writer.add(one - fy, fx, fy - fx);
        } else if (kind == Cell::down) {
            writer.begin_span(site, {0, 0}, {1, 0}, {1, 1}, i);
            for (; inside && fx >= fy; inside = next())
                writer.add(one - fx, fx - fy, fy);
        } else if (fx + fy < one) {
            writer.begin_span(site, {0, 0}, {1, 0}, {0, 1}, i);
            for (; inside && fx + fy < one; inside = next())
                writer.add(one - fx - fy, fx, fy);
        } else {
            writer.begin_span(site, {1, 0}, {1, 1}, {0, 1}, i);
            for (; inside && fx + fy >= one; inside = next())
                writer.add(one - fy, fx + fy - one, one - fx);
        }
        writer.end_span(i);
    }
    return i;
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

} // namespace

void locate_row(const Lattice& lattice, const Point* points, int n, LocatedRow& row) {
    RowWriter writer(lattice, row, n);
    row.hints.swap(row.previous_hints);
    row.hints.clear();
    size_t hint = 0;
    for (int i = 0; i < n;) {
        const Point p = points[i];
        int cx = p.x >> position_bits, cy = p.y >> position_bits;
        cx = cx < lattice.width() - 1 ? cx : lattice.width() - 2;
        cy = cy < lattice.height() - 1 ? cy : lattice.height() - 2;
        const int site = lattice.vertex_site(cx, cy);
        const Cell kind = kind_of(lattice.edge(site + lattice.stride() + 1));
        if (kind != Cell::other) {
            i = locate_in_cell(kind, cx, cy, site, points, i, n, writer);
            continue;
        }
        const Triangle* known = find_hint(row, hint, i, p);
        row.hints.push_back({known ? *known : locate(lattice, p), 0});
        const Triangle t = row.hints.back().triangle;
        writer.begin_span(t, i);
        int32_t w[3];
        t.weights(p, w);
        do {
            // On the rim, a tie may belong to a triangle that does not hold it; no weight is
            // negative all the same.
            writer.add(w[0], w[1], w[2]);
            if (++i == n)
                break;
            t.weights(points[i], w);
        } while (t.holds(w));
        writer.end_span(i);
        row.hints.back().end = i;
    }
}

} // namespace ddt
