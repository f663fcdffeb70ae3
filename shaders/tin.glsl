// SPDX-License-Identifier: Apache-2.0
// A triangulation of any vertices. C++ twins: core/tin/tin.h, tin_mesh.h and face.h, which explain
// it.
//
// Every kernel has an invocation an edge (tin_faces.comp: a triangle).
#define ANY_AREAS
#include "cost.glsl"

layout(local_size_x = TIN_GROUP) in;

// x, y, the guide's bits.
layout(std430, binding = BIND_TIN_VERTICES) readonly buffer Vertices { int vertices[]; };
// Three vertices, three edges.
layout(std430, binding = BIND_TIN_TRIANGLES) buffer Triangles { int triangles[]; };
// The triangles on the left and right; -1: none.
layout(std430, binding = BIND_TIN_EDGES) buffer Edges { ivec2 edges[]; };
layout(std430, binding = BIND_TIN_FACES) buffer Faces { vec4 faces[]; }; // of triangles
#ifdef DRAWN // what a program of annealing does with these, which has no use for gains
layout(std430, binding = BIND_TIN_DRAWN) DRAWN buffer Drawn { uint drawn[]; }; // an edge
#else
layout(std430, binding = BIND_TIN_GAINS) buffer Gains { float gain[]; };
#endif
layout(std430, binding = BIND_TIN_MARKS) buffer Marks { uint mark[]; };
layout(std430, binding = BIND_TIN_COUNTS) buffer Counts {
    uint evaluated, candidates, waiting, flipped;
};

layout(location = AT_COUNT) uniform int count; // invocations wanted
layout(location = AT_PIXEL) uniform float pixel;
layout(location = AT_MIN_GAIN) uniform float min_gain;
layout(location = AT_BY_GAIN) uniform bool by_gain;
layout(location = AT_WIDE) uniform bool wide;

// What is known of an edge. A winner is an edge accepted in this round, which others may still take
// for untreated.
const uint idle = 0, dirty = MARK_DIRTY, untreated = 2, winner = 3, accepted = 4, rejected = 5;

int own_index() {
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    return int(group * gl_WorkGroupSize.x + gl_LocalInvocationIndex);
}

ivec2 at(int v) {
    return ivec2(vertices[3 * v], vertices[3 * v + 1]);
}
float guide_at(int v) {
    return intBitsToFloat(vertices[3 * v + 2]);
}

// Twice the signed area of a, b, c: the high and low half of 64 bits.
ivec2 orientation(ivec2 a, ivec2 b, ivec2 c) {
    ivec2 p, q; // high, low
    imulExtended(b.x - a.x, c.y - a.y, p.x, p.y);
    imulExtended(b.y - a.y, c.x - a.x, q.x, q.y);
    int borrow = uint(p.y) < uint(q.y) ? 1 : 0;
    return ivec2(p.x - q.x - borrow, p.y - q.y);
}
bool is_positive(ivec2 w) {
    return w.x > 0 || (w.x == 0 && w.y != 0);
}

// Whole numbers as floats. Of 32 bits: rounded once, by halves, which are exact. Of 64: each half
// is rounded, then their sum.
float to_float(int x) {
    precise float v = float(x >> 16) * 65536.0 + float(x & 0xffff);
    return v;
}
float to_float(uint x) {
    precise float v = float(x >> 16) * 65536.0 + float(x & 0xffffu);
    return v;
}
float to_float(ivec2 w) {
    precise float v = to_float(uint(w.x)) * 4294967296.0 + to_float(uint(w.y));
    return v;
}

float reciprocal(float x) {
    precise float y = intBitsToFloat(reciprocal_magic - floatBitsToInt(x));
    for (int i = 0; i < 4; ++i)
        y = y + y * (1.0 - x * y);
    return y;
}

#if defined(COST_abn)
vec4 pack(Face f, float area) {
    return vec4(f.x, f.y, f.z, area);
}
Face unpack(vec4 f) {
    return Face(f.x, f.y, f.z);
}
#elif defined(COST_scf)
vec4 pack(Face f, float area) {
    return vec4(f.x, f.y, f.norm, area);
}
Face unpack(vec4 f) {
    return Face(f.x, f.y, f.z);
}
#elif defined(COST_jnd) || defined(COST_dlp)
vec4 pack(Face f, float area) {
    return vec4(f.x, f.y, 0.0, area);
}
Face unpack(vec4 f) {
    return Face(f.x, f.y);
}
#elif defined(COST_dp)
vec4 pack(Face f, float area) {
    return vec4(f.x, f.y, f.r, area);
}
Face unpack(vec4 f) {
    return Face(f.x, f.y, f.z);
}
#endif

vec4 face_of(int p, int q, int r) {
    ivec2 a = at(p), b = at(q), c = at(r);
    precise float ex = to_float(b.x - a.x) * pixel, ey = to_float(b.y - a.y) * pixel;
    precise float ox = to_float(c.x - a.x) * pixel, oy = to_float(c.y - a.y) * pixel;
    precise float de = guide_at(q) - guide_at(p), d_o = guide_at(r) - guide_at(p);
    precise float area = (to_float(orientation(a, b, c)) * pixel) * pixel;
    precise float scale = reciprocal(area);
    precise float gx = ((de * oy) - (d_o * ey)) * scale, gy = ((d_o * ex) - (de * ox)) * scale;
    return pack(face(gx, gy), area);
}
float between(vec4 a, vec4 b, int p, int q) {
    ivec2 e = at(q) - at(p);
    precise float ex = to_float(e.x) * pixel, ey = to_float(e.y) * pixel;
    return between(unpack(a), unpack(b), ex, ey, a.w, b.w);
}

// The quad round an edge with triangles on both sides.
struct Quad {
    int a, b, c, d;
    int ac, cb, bd, da;
};
int corner(int triangle, int m) {
    return triangles[6 * triangle + 3] == m ? 0 : triangles[6 * triangle + 4] == m ? 1 : 2;
}
Quad quad_of(int m) {
    ivec2 e = edges[m];
    int l = 6 * e.x, r = 6 * e.y, i = corner(e.x, m), k = corner(e.y, m);
    int i1 = (i + 1) % 3, i2 = (i + 2) % 3, k1 = (k + 1) % 3, k2 = (k + 2) % 3;
    return Quad(triangles[l + i], triangles[l + i1], triangles[l + i2], triangles[r + k2],
                triangles[l + 3 + i2], triangles[l + 3 + i1], triangles[r + 3 + k2],
                triangles[r + 3 + k1]);
}
bool flippable(int m) {
    ivec2 e = edges[m];
    if (e.x < 0 || e.y < 0)
        return false;
    Quad q = quad_of(m);
    return is_positive(orientation(at(q.d), at(q.c), at(q.a))) &&
           is_positive(orientation(at(q.c), at(q.d), at(q.b)));
}
// The triangle beyond a side; -1 on the rim.
int beyond(int side, int inner) {
    ivec2 e = edges[side];
    return e.x == inner ? e.y : e.x;
}

float flip_gain(int m) {
    Quad q = quad_of(m);
    ivec2 e = edges[m];
    vec4 abc = faces[e.x], abd = faces[e.y];
    vec4 adc = face_of(q.d, q.c, q.a), bcd = face_of(q.c, q.d, q.b);
    precise float before = between(abc, abd, q.a, q.b), after = between(adc, bcd, q.d, q.c);
    for (int k = 0; k < 4; ++k) {
        int side = k == 0 ? q.ac : k == 1 ? q.cb : k == 2 ? q.bd : q.da;
        int outer = beyond(side, k < 2 ? e.x : e.y);
        if (outer < 0)
            continue;
        int from = k == 0 ? q.a : k == 1 ? q.c : k == 2 ? q.b : q.d;
        int to = k == 0 ? q.c : k == 1 ? q.b : k == 2 ? q.d : q.a;
        vec4 was = k < 2 ? abc : abd, is = k == 0 || k == 3 ? adc : bcd;
        before = before + between(faces[outer], was, from, to);
        after = after + between(faces[outer], is, from, to);
    }
    precise float g = before - after;
    return g;
}

// The region of an edge, narrow (most_in_region - 1 at most) or wide; the rest is -1. The edge
// itself may be in the wide one.
const int wide_region_size = most_in_wide_region;
void region_of(int m, bool is_wide, out int region[wide_region_size]) {
    for (int k = 0; k < wide_region_size; ++k)
        region[k] = -1;
    Quad q = quad_of(m);
    ivec2 e = edges[m];
    for (int k = 0; k < 4; ++k) {
        int side = k == 0 ? q.ac : k == 1 ? q.cb : k == 2 ? q.bd : q.da;
        region[7 * k] = side;
        int outer = beyond(side, k < 2 ? e.x : e.y), n = 7 * k + 1;
        for (int i = 0; outer >= 0 && i < 3; ++i) {
            int other = triangles[6 * outer + 3 + i];
            if (other == side)
                continue;
            region[n++] = other;
            int far = is_wide ? beyond(other, outer) : -1;
            for (int j = 0; far >= 0 && j < 3; ++j)
                if (triangles[6 * far + 3 + j] != other)
                    region[n++] = triangles[6 * far + 3 + j];
        }
    }
}
