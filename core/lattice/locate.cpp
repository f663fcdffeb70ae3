// SPDX-License-Identifier: Apache-2.0
#include "core/lattice/locate.h"

namespace ddt {

namespace {

/// A vertex relative to the corner of the position's cell, in pixels.
struct Corner {
    int x, y;
};
Vec operator-(Corner a, Corner b) {
    return {a.x - b.x, a.y - b.y};
}

/// Whether weight 0 with respect to an edge along d counts as inside: the sign of
/// det(d, (t, t^2)) for tiny t > 0.
bool tie_inside(Vec d) {
    return d.y < 0 || (d.y == 0 && d.x > 0);
}

/// The triangle s, t, c (det > 0) round the cell (cx, cy).
Triangle describe(const Lattice& lattice, int cx, int cy, Corner s, Corner t, Corner c) {
    const Corner corners[3] = {s, t, c};
    const auto before = [&](int i, int k) {
        const Corner a = corners[i], b = corners[k];
        return a.y < b.y || (a.y == b.y && a.x < b.x);
    };
    int first = before(1, 0) ? 1 : 0;
    first = before(2, first) ? 2 : first;
    const Corner p[3] = {corners[first], corners[(first + 1) % 3], corners[(first + 2) % 3]};

    Triangle r;
    for (int i = 0; i < 3; ++i) {
        const Corner a = p[i], b = p[(i + 1) % 3];
        r.vertex[i] = lattice.vertex_site(cx + a.x, cy + a.y);
        r.edge[i] = lattice.site(2 * cx + a.x + b.x, 2 * cy + a.y + b.y);
    }
    for (int i = 0; i < 2; ++i)
        r.at[i] = {(cx + p[i + 1].x) * position_one, (cy + p[i + 1].y) * position_one};
    r.e12 = p[2] - p[1];
    r.e20 = p[0] - p[2];
    r.bias[0] = tie_inside(r.e12) ? 0 : -1;
    r.bias[1] = tie_inside(r.e20) ? 0 : -1;
    r.bias[2] = tie_inside(p[1] - p[0]) ? 0 : -1;
    return r;
}

} // namespace

Triangle locate(const Lattice& lattice, Point p) {
    int cx = p.x >> position_bits, cy = p.y >> position_bits;
    cx = cx < lattice.width() - 1 ? cx : lattice.width() - 2;
    cy = cy < lattice.height() - 1 ? cy : lattice.height() - 2;
    const int32_t fx = p.x - cx * position_one, fy = p.y - cy * position_one;
    // Whether p, shifted by the tie rule, lies to the left of the line through q along d.
    const auto left_of = [&](Vec d, Corner q) {
        const int32_t side = d.x * (fy - q.y * position_one) - d.y * (fx - q.x * position_one);
        return side > 0 || (side == 0 && tie_inside(d));
    };

    // The triangle looked at lies to the left of its edge s t; c is its third vertex.
    const Edge& diagonal = lattice.edge(lattice.site(2 * cx + 1, 2 * cy + 1));
    const Vec v = diagonal.v;
    Corner s{(1 - v.x) / 2, (1 - v.y) / 2}, t{(1 + v.x) / 2, (1 + v.y) / 2};
    Vec apex = diagonal.left;
    if (!left_of(v, s)) {
        const Corner swap = s;
        s = t;
        t = swap;
        apex = diagonal.right;
    }
    // Direction of the walk, from the cell's centre to p.
    const int32_t rx = fx - position_one / 2, ry = fy - position_one / 2;
    for (;;) {
        const Corner c{(s.x + t.x + apex.x) / 2, (s.y + t.y + apex.y) / 2};
        // If c lies to the left of the walk's line, the walk can leave the triangle across t c
        // only, else across c s only. On a tie the shifted p tells.
        const int c2x = 2 * c.x - 1, c2y = 2 * c.y - 1;
        int turn = rx * c2y - ry * c2x;
        if (turn == 0)
            turn = c2y != 0 ? c2y : -c2x;
        const Corner from = turn > 0 ? t : c, to = turn > 0 ? c : s, own = turn > 0 ? s : t;
        if (left_of(to - from, from))
            return describe(lattice, cx, cy, s, t, c);
        const int x = from.x + to.x, y = from.y + to.y;
        const Edge& side = lattice.edge(lattice.site(2 * cx + x, 2 * cy + y));
        apex = apex_beyond(side, Vec(2 * own.x - x, 2 * own.y - y));
        if (apex.zero())
            return describe(lattice, cx, cy, s, t, c);
        s = to;
        t = from;
    }
}

} // namespace ddt
