// The lattice, several tiles at once. C++ twin: core/lattice/lattice.h, which explains it.
//
// Each tile has a slot of slot_sites sites, in rows of `stride` whatever the tile's own width, and
// `site` numbers run through all slots. ACCESS is `coherent` where invocations read what others of
// the same dispatch wrote.
#ifndef ACCESS
#define ACCESS
#endif

layout(std140, binding = 0) uniform Batch {
    int stride;
    int slot_sites;
    int slot_width;  // pixels in a row of a slot
    int slot_pixels;
    ivec4 extent[MAX_TILES]; // xy: a tile's width and height in pixels
};

layout(std430, binding = 0) ACCESS buffer Sites {
    // An edge: the bytes v.x v.y left.x left.y, right.x right.y 0 0. A vertex: the guide's bits,
    // and the key of its first edge (first_edges.comp).
    uvec2 site[];
};

struct Edge {
    ivec2 v, left, right;
};

const int longest_edge = 63;
const uint no_first = 0xffffffffu;

ivec2 bytes(uint word, int first) {
    int w = int(word);
    return ivec2(bitfieldExtract(w, first, 8), bitfieldExtract(w, first + 8, 8));
}
uint pack(ivec2 a, ivec2 b) {
    return uint(a.x & 255) | uint(a.y & 255) << 8 | uint(b.x & 255) << 16 | uint(b.y & 255) << 24;
}
uvec2 pack(Edge e) {
    return uvec2(pack(e.v, e.left), pack(e.right, ivec2(0)));
}

Edge edge_at(int m) {
    uvec2 record = site[m];
    return Edge(bytes(record.x, 0), bytes(record.x, 16), bytes(record.y, 0));
}
float guide_at(int m) {
    return uintBitsToFloat(site[m].x);
}
int offset(ivec2 v) {
    return v.y * stride + v.x;
}
bool is_zero(ivec2 v) {
    return v == ivec2(0);
}

bool flippable(Edge e) {
    return !is_zero(e.left) && e.left == -e.right && abs(e.left.x) <= longest_edge &&
           abs(e.left.y) <= longest_edge;
}

const int division_down = 0, division_up = 1, division_other = 2;

// How the cell of the tile whose slot begins at first_site is divided.
int division(int first_site, ivec2 cell) {
    Edge centre = edge_at(first_site + offset(2 * cell + 1));
    ivec2 v = centre.v.y < 0 ? -centre.v : centre.v, apex = centre.left;
    if (apex != -centre.right)
        return division_other;
    if (v == ivec2(1, 1) && (apex == ivec2(-1, 1) || apex == ivec2(1, -1)))
        return division_down;
    if (v == ivec2(-1, 1) && (apex == ivec2(-1, -1) || apex == ivec2(1, 1)))
        return division_up;
    return division_other;
}

struct Quad {
    ivec2 v, w;
    ivec2 side[4], middle[4], inner[4];
};
Quad quad_of(Edge e) {
    ivec2 v = e.v, w = (e.v + e.left) / 2;
    return Quad(v, w, ivec2[4](w, v - w, -w, w - v), ivec2[4](w - v, w, v - w, -w),
                ivec2[4](v + v - w, -v - w, w - v - v, v + w));
}

ivec2 outer_apex(int m, Quad q, int k) {
    Edge e = edge_at(m + offset(q.middle[k]));
    return e.left + e.right - q.inner[k];
}

// The 2-region of the flippable edge at m without m itself: 12 sites, -1 where there is none.
void region_of(int m, Edge e, out int region[12]) {
    Quad q = quad_of(e);
    for (int k = 0; k < 4; ++k) {
        int middle = m + offset(q.middle[k]);
        ivec2 apex = outer_apex(m, q, k), s = q.side[k];
        bool rim = is_zero(apex);
        region[3 * k] = middle;
        region[3 * k + 1] = rim ? -1 : middle + offset((apex - s) / 2);
        region[3 * k + 2] = rim ? -1 : middle + offset((apex + s) / 2);
    }
}

void flip(int m, Edge e) {
    Quad q = quad_of(e);
    ivec2 c = e.left, d = e.right;
    ivec2 came[4] = ivec2[4](d, d, c, c);
    for (int k = 0; k < 4; ++k) {
        int s = m + offset(q.middle[k]);
        Edge side = edge_at(s);
        ivec2 apex = came[k] - q.middle[k];
        if (side.left == q.inner[k])
            side.left = apex;
        else
            side.right = apex;
        site[s] = pack(side);
    }
    site[m] = pack(Edge(c, -e.v, e.v));
}
