// SPDX-License-Identifier: Apache-2.0
// Which triangle a position lies in. C++ twin: core/lattice/locate.cpp. After net.glsl.

struct Triangle {
    ivec2 vertex[3]; // pixels of the tile, the one with the smallest address first
    ivec3 weight;    // of the position, in 2^-16
};

int det(ivec2 a, ivec2 b) {
    return a.x * b.y - a.y * b.x;
}

bool tie_inside(ivec2 d) {
    return d.y < 0 || (d.y == 0 && d.x > 0);
}

// A triangle's vertices in Triangle's order, relative to the first corner of a cell.
struct Corners {
    ivec2 p0, p1, p2;
};

// In the order of sites.
int address(ivec2 corner) {
    return corner.y * corner_stride + corner.x;
}

// The triangle s, t, c (det > 0).
Corners ordered(ivec2 s, ivec2 t, ivec2 c) {
    int first = address(t) < address(s) ? 1 : 0;
    first = address(c) < address(first == 1 ? t : s) ? 2 : first;
    return Corners(first == 0 ? s : first == 1 ? t : c, first == 0 ? t : first == 1 ? c : s,
                   first == 0 ? c : first == 1 ? s : t);
}

// Whether f, shifted by the tie rule, lies to the left of the line through q along d.
bool left_of(ivec2 d, ivec2 q, ivec2 f) {
    int side = det(d, f - q * position_one);
    return side > 0 || (side == 0 && tie_inside(d));
}

// The triangle that a position belongs to, by its place f in the cell.
Corners locate(int tile, ivec2 cell, ivec2 f) {
    int origin = tile * slot_sites + 2 * cell.y * stride + 2 * cell.x;

    Edge diagonal = edge_at(origin + stride + 1);
    ivec2 s = (1 - diagonal.v) / 2, t = (1 + diagonal.v) / 2, apex = diagonal.left;
    if (!left_of(diagonal.v, s, f)) {
        ivec2 swap = s;
        s = t;
        t = swap;
        apex = diagonal.right;
    }
    ivec2 r = f - position_one / 2, c;
    for (int steps = 0; steps < longest_walk; ++steps) {
        c = (s + t + apex) / 2;
        ivec2 c2 = 2 * c - 1;
        int turn = r.x * c2.y - r.y * c2.x;
        if (turn == 0)
            turn = c2.y != 0 ? c2.y : -c2.x;
        ivec2 from = turn > 0 ? t : c, to = turn > 0 ? c : s, own = turn > 0 ? s : t;
        if (left_of(to - from, from, f))
            break;
        ivec2 middle = from + to;
        Edge side = edge_at(origin + offset(middle));
        apex = apex_beyond(side, 2 * own - middle);
        if (is_zero(apex))
            break;
        s = to;
        t = from;
    }
    return ordered(s, t, c);
}

// The cell that p lies in: the last pixel belongs to the one before it. C++ twin:
// core/lattice/locate.h
ivec2 cell_of(int tile, ivec2 p) {
    return min(p >> position_bits, extent[tile].xy - 2);
}

// The triangle that p belongs to.
Triangle locate(int tile, ivec2 p) {
    ivec2 cell = cell_of(tile, p);
    ivec2 f = p - cell * position_one;
    Corners c = locate(tile, cell, f);
    Triangle r;
    r.vertex[0] = cell + c.p0;
    r.vertex[1] = cell + c.p1;
    r.vertex[2] = cell + c.p2;
    r.weight.x = det(c.p2 - c.p1, f - c.p1 * position_one);
    r.weight.y = det(c.p0 - c.p2, f - c.p2 * position_one);
    r.weight.z = position_one - r.weight.x - r.weight.y;
    return r;
}

// Barycentric weights.
vec3 weights(Triangle t) {
    precise vec3 b = vec3(t.weight) * position_unit;
    return b;
}
