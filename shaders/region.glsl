// SPDX-License-Identifier: Apache-2.0
// Regions of an edge as arrays. C++ twin: core/lattice/region.h, where any_beyond is recursive.
// After lattice.glsl.

const int region_size = most_in_region - 1, wide_region_size = most_in_wide_region;

// The 2-region of the flippable edge e at m without m itself; -1 where there is none. C++ twin:
// Lattice::any_of_region().
void region_of(int m, Edge e, out int region[region_size]) {
    Side s = first_side(e);
    for (int k = 0; k < 4; ++k) {
        int middle = m + offset(middle_of(s));
        ivec2 beyond = edges_beyond(middle, edge_at(middle), s);
        region[3 * k] = middle;
        region[3 * k + 1] = beyond.x;
        region[3 * k + 2] = beyond.y;
        s = next_side(s);
    }
}

// A side to look beyond: the site, its vector, the apex on the near side.
struct Beyond {
    int site;
    ivec2 side, inner;
};

// The two other sides of the triangle beyond. False on the rim.
bool next_sides(Beyond b, out Beyond minus, out Beyond plus) {
    ivec2 apex = apex_beyond(edge_at(b.site), b.inner);
    ivec2 first = from_first_end(apex, b.side), last = from_last_end(apex, b.side);
    minus = Beyond(b.site + offset(last), first, b.side - last);
    plus = Beyond(b.site + offset(first), last, -b.side - first);
    return !is_zero(apex);
}

// The region of degree 3 of the flippable edge e at m; -1 where there is none, some twice. C++
// twin: any_of_wide_region().
void wide_region_of(int m, Edge e, out int region[wide_region_size]) {
    Side s = first_side(e);
    for (int k = 0; k < 4; ++k) {
        Beyond b = Beyond(m + offset(middle_of(s)), s.vector, s.inner), next[2], last[2];
        region[7 * k] = b.site;
        bool there = next_sides(b, next[0], next[1]);
        for (int i = 0; i < 2; ++i) {
            region[7 * k + 1 + 3 * i] = there ? next[i].site : -1;
            bool further = false;
            if (there)
                further = next_sides(next[i], last[0], last[1]);
            region[7 * k + 2 + 3 * i] = further ? last[0].site : -1;
            region[7 * k + 3 + 3 * i] = further ? last[1].site : -1;
        }
        s = next_side(s);
    }
}
