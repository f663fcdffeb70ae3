// SPDX-License-Identifier: Apache-2.0
#include "core/lattice/locate.h"

namespace ddt {

namespace {

/// The triangle s, t, c (det > 0).
Corners ordered(Corner s, Corner t, Corner c) {
    // Branch-free: the branches would be mispredicted.
    const auto address = [](Corner a) { return a.y * corner_stride + a.x; };
    const Corner around[5] = {s, t, c, s, t};
    int first = int(address(t) < address(s));
    first = address(c) < address(around[first]) ? 2 : first;
    return {{around[first], around[first + 1], around[first + 2]}};
}

} // namespace

Corners locate(const Lattice& lattice, int cx, int cy, Point in_cell) {
    const int32_t fx = in_cell.x, fy = in_cell.y;
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
        apex = diagonal.right();
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
            return ordered(s, t, c);
        const int x = from.x + to.x, y = from.y + to.y;
        const Edge& side = lattice.edge(lattice.site(2 * cx + x, 2 * cy + y));
        apex = apex_beyond(side, Vec(2 * own.x - x, 2 * own.y - y));
        if (apex.zero())
            return ordered(s, t, c);
        s = to;
        t = from;
    }
}

Triangle locate(const Lattice& lattice, Point at) {
    const int cx = cell_of(at.x, lattice.width()), cy = cell_of(at.y, lattice.height());
    const Corners corners =
        locate(lattice, cx, cy, {at.x - cx * position_one, at.y - cy * position_one});
    const Corner* p = corners.p;
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

} // namespace ddt
