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

// Whether a comes before b in the order of addresses.
bool before(ivec2 a, ivec2 b) {
    return a.y < b.y || (a.y == b.y && a.x < b.x);
}

// The triangle s, t, c (det > 0), corners relative to the cell, for the position f in it.
Triangle describe(ivec2 cell, ivec2 f, ivec2 s, ivec2 t, ivec2 c) {
    ivec2 p0 = s, p1 = t, p2 = c;
    if (before(t, s) && !before(c, t)) {
        p0 = t;
        p1 = c;
        p2 = s;
    } else if (before(c, s) && before(c, t)) {
        p0 = c;
        p1 = s;
        p2 = t;
    }
    Triangle r;
    r.vertex[0] = cell + p0;
    r.vertex[1] = cell + p1;
    r.vertex[2] = cell + p2;
    r.weight.x = det(p2 - p1, f - p1 * position_one);
    r.weight.y = det(p0 - p2, f - p2 * position_one);
    r.weight.z = position_one - r.weight.x - r.weight.y;
    return r;
}

// Whether f, shifted by the tie rule, lies to the left of the line through q along d.
bool left_of(ivec2 d, ivec2 q, ivec2 f) {
    int side = det(d, f - q * position_one);
    return side > 0 || (side == 0 && tie_inside(d));
}

Triangle locate(int tile, ivec2 p) {
    ivec2 cell = min(p >> position_bits, extent[tile].xy - 2);
    ivec2 f = p - cell * position_one;
    int origin = tile * slot_sites + 2 * cell.y * stride + 2 * cell.x;

    Edge diagonal = edge_at(origin + stride + 1);
    ivec2 s = (1 - diagonal.v) / 2, t = (1 + diagonal.v) / 2, apex = diagonal.left;
    if (!left_of(diagonal.v, s, f)) {
        ivec2 swap = s;
        s = t;
        t = swap;
        apex = diagonal.right;
    }
    ivec2 r = f - position_one / 2;
    for (;;) {
        ivec2 c = (s + t + apex) / 2;
        ivec2 c2 = 2 * c - 1;
        int turn = r.x * c2.y - r.y * c2.x;
        if (turn == 0)
            turn = c2.y != 0 ? c2.y : -c2.x;
        ivec2 from = turn > 0 ? t : c, to = turn > 0 ? c : s, own = turn > 0 ? s : t;
        if (left_of(to - from, from, f))
            return describe(cell, f, s, t, c);
        ivec2 middle = from + to;
        Edge side = edge_at(origin + offset(middle));
        apex = apex_beyond(side, 2 * own - middle);
        if (is_zero(apex))
            return describe(cell, f, s, t, c);
        s = to;
        t = from;
    }
}

// Barycentric weights.
vec3 weights(Triangle t) {
    const float unit = 1.0 / float(position_one);
    precise vec3 b = vec3(t.weight) * unit;
    return b;
}
