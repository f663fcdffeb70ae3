// SPDX-License-Identifier: Apache-2.0
// The lattice, several tiles at once. C++ twin: core/lattice/lattice.h, which explains it.
//
// Each tile has a slot of slot_sites sites, in rows of `stride` whatever the tile's own width, and
// `site` numbers run through all slots. ACCESS is `coherent` where invocations read what others of
// the same dispatch wrote. SITE and STRIDE are set where a part of the lattice is looked at in
// another array.
#ifndef ACCESS
#define ACCESS
#endif
#ifndef SITE
#define SITE(m) site[m]
#define STRIDE stride
#endif

layout(std140, binding = BIND_BATCH) uniform Batch {
    int stride;
    int slot_sites;
    int slot_width;  // pixels in a row of a slot
    int slot_pixels;
    // A tile's width and height in pixels; where its first pixel is in the image.
    ivec4 extent[MAX_TILES];
    ivec4 served[MAX_TILES]; // first and last pixels about the positions a tile serves
};

layout(std430, binding = BIND_SITES) ACCESS buffer Sites {
    // An edge: the bytes v.x v.y left.x left.y, right.x right.y and its stamp (touch.glsl). A
    // vertex: the guide's bits, and the key of one of its edges.
    uvec2 site[];
};

struct Edge {
    ivec2 v, left, right;
};

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

// One of a vertex's edges, given as its midpoint relative to the vertex, in a key that orders
// midpoints as their addresses do.
uint edge_key(ivec2 midpoint) {
    return uint(midpoint.y + 128) << 8 | uint(midpoint.x + 128);
}
ivec2 midpoint_of_key(uint key) {
    return ivec2(int(key & 255u) - 128, int(key >> 8) - 128);
}

uint stamp_at(int m) {
    return site[m].y >> 16;
}
Edge edge_at(int m) {
    uvec2 record = SITE(m);
    return Edge(bytes(record.x, 0), bytes(record.x, 16), bytes(record.y, 0));
}
float guide_at(int m) {
    return uintBitsToFloat(SITE(m).x);
}
int offset(ivec2 v) {
    return v.y * STRIDE + v.x;
}
bool is_zero(ivec2 v) {
    return v == ivec2(0);
}

// Whether an edge with these apexes can be flipped.
bool is_diagonal(ivec2 left, ivec2 right) {
    return !is_zero(left) && left == -right && abs(left.x) <= longest_edge &&
           abs(left.y) <= longest_edge;
}
bool flippable(Edge e) {
    return is_diagonal(e.left, e.right);
}

// v and left of an edge's record as one number.
uint first_word(ivec2 v, ivec2 left) {
    return pack(v, left);
}

// How the cell of the tile whose slot begins at first_site is divided.
int division(int first_site, ivec2 cell) {
    Edge centre = edge_at(first_site + offset(2 * cell + 1));
    uint first = first_word(centre.v, centre.left);
    bool down = flippable(centre) && (first == first_word(ivec2(1, 1), ivec2(-1, 1)) ||
                                      first == first_word(ivec2(-1, -1), ivec2(1, -1)));
    bool up = flippable(centre) && (first == first_word(ivec2(-1, 1), ivec2(-1, -1)) ||
                                    first == first_word(ivec2(1, -1), ivec2(1, 1)));
    return down ? division_down : up ? division_up : division_crossed;
}

// A side of the quad round a flippable edge, in the order ac, cb, bd, da. C++ twin, with a figure:
// core/lattice/quad-inl.h. Each is made of the one before and not looked up in arrays, and loops
// end when they are once round: compilers would unroll them, and take a multiple of the time for
// programs that are no faster.
struct Side {
    ivec2 vector, next;      // as vectors in pixels: this side, the next one
    ivec2 inner, next_inner; // the apex within the quad, relative to the side's midpoint
};
Side first_side(Edge e) {
    ivec2 v = e.v, w = (e.v + e.left) / 2;
    return Side(w, v - w, v + v - w, -v - w);
}
Side next_side(Side s) {
    return Side(s.next, -s.vector, s.next_inner, -s.inner);
}
// Whether s, made of the last side of the quad round e, is the first again.
bool once_round(Side s, Edge e) {
    return s.vector == (e.v + e.left) / 2;
}
// The side's midpoint relative to the edge's.
ivec2 middle_of(Side s) {
    return -s.next;
}

// The apex beyond a side whose record is e, `inner` its other one; zero on the rim.
ivec2 apex_beyond(Edge e, ivec2 inner) {
    return e.left + e.right - inner;
}

// The two other sides of the triangle between an edge and its apex, in pixels, to the apex from the
// edge's first and last end; in doubled coordinates also the way to the midpoint of the other one.
ivec2 from_first_end(ivec2 apex, ivec2 edge) {
    return (apex + edge) >> 1;
}
ivec2 from_last_end(ivec2 apex, ivec2 edge) {
    return (apex - edge) >> 1;
}

// The two other edges of the triangle beyond the side, whose site is `middle` and whose record is
// e; -1 on the rim. With the sides themselves they are the 2-region.
ivec2 edges_beyond(int middle, Edge e, Side s) {
    ivec2 apex = apex_beyond(e, s.inner);
    return is_zero(apex) ? ivec2(-1)
                         : ivec2(middle + offset(from_last_end(apex, s.vector)),
                                 middle + offset(from_first_end(apex, s.vector)));
}

// In dispatches over sites, z a tile: the edge at this invocation's place, -1 if there is none.
int edge_of_invocation() {
    ivec3 at = ivec3(gl_GlobalInvocationID);
    bool there = at.x < 2 * extent[at.z].x - 1 && at.y < 2 * extent[at.z].y - 1 &&
                 ((at.x | at.y) & 1) != 0;
    return there ? at.z * slot_sites + at.y * stride + at.x : -1;
}
