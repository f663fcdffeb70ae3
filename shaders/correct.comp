// SPDX-License-Identifier: Apache-2.0
// One consistency round, one invocation a vertex. C++ twin: core/surface/consistency.cpp, which goes
// through the cells and adds to their corners; the sum here takes the cells in the same order.
#include "net.glsl"
#include "served.glsl"
#include "locate.glsl"
#include "consistency.glsl"
#ifdef FITTED
#include "fitted.glsl"
#include "fitted_index.glsl"
#include "fitted_vertex.glsl"
#include "fitted_bend.glsl"
#endif

layout(local_size_x = SURFACE_GROUP_X, local_size_y = SURFACE_GROUP_Y) in; // z: a tile

layout(std430, binding = 4) readonly buffer Source { uvec4 source[]; };
layout(std430, binding = 5) writeonly buffer Corrected { uvec4 corrected_value[]; };

// FITTED: vertices go where their features' weights say, and within an edge less edges are bent so
// (C++ twins: core/surface/fitted/fitted.cpp).
#ifdef FITTED
layout(std430, binding = 6) buffer Bends { vec4 bends[]; }; // a site; at vertices their indices
#endif

layout(location = 2) uniform vec4 limit;
layout(location = 3) uniform float lowest;

vec4 source_at(ivec2 p) {
    return uintBitsToFloat(source[pixel_of(p)]);
}

// The cell seen from its corner v; its diagonal goes from v or from one of v's neighbours.
QuadrantCell quadrant_cell(ivec2 cell, ivec2 v, bool v_to_d) {
    ivec2 d = 2 * cell + 1 - v, x = ivec2(d.x, v.y), y = ivec2(v.x, d.y);
    QuadrantCell c;
    c.v = value_at(v);
    c.x = value_at(x);
    c.y = value_at(y);
    c.d = value_at(d);
    // The edges one after the other, each put last in the row: vx, vy, xd, yd, diagonal. Loops that
    // compilers do not unroll (see Side in lattice.glsl), here and below.
    ivec2 from = v_to_d ? v : x, to = v_to_d ? d : y, i, j;
    int k = 0;
    do {
        i = k < 2 ? v : k == 2 ? x : k == 3 ? y : from;
        j = k == 0 ? x : k == 1 ? y : k < 4 ? d : to;
#ifdef QUADRATIC
        c.vx = c.vy;
        c.vy = c.xd;
        c.xd = c.yd;
        c.yd = c.diagonal;
        c.diagonal = bend(i, j);
#endif
#ifdef SOFT
        c.qvx = c.qvy;
        c.qvy = c.qxd;
        c.qxd = c.qyd;
        c.qyd = c.q_diagonal;
        c.q_diagonal = softness(i, j);
#endif
        ++k;
    } while (i != from || j != to);
    return c;
}

// As patch_of, an edge after the other.
Patch patch_by_edges(ivec2 p0, ivec2 p1, ivec2 p2) {
    Patch p;
    p.z0 = value_at(p0);
    p.z1 = value_at(p1);
    p.z2 = value_at(p2);
    ivec2 i = p0, j = p1, k = p2;
    do {
#ifdef QUADRATIC
        p.e01 = p.e12;
        p.e12 = p.e20;
        p.e20 = bend(i, j);
#endif
#ifdef SOFT
        p.q01 = p.q12;
        p.q12 = p.q20;
        p.q20 = softness(i, j);
#endif
        ivec2 last = i;
        i = j;
        j = k;
        k = last;
    } while (i != p0);
    find_range(p, strict);
    return p;
}

// The mean over the quadrant of the cell at its corner v where other edges cross the cell.
vec4 mean_by_position(int tile, ivec2 cell, ivec2 v) {
    ivec2 quadrant = v - cell;
    vec4 z = value_at(v);
    precise vec4 mean = vec4(0.0);
    for (int i = 0; i < 4; ++i) {
        // From left to right, and back in the row below.
        ivec2 at_eighth = 4 * quadrant + ivec2(i == 1 || i == 2 ? 3 : 1, i < 2 ? 1 : 3);
        Triangle t = locate(tile, cell * position_one + at_eighth * (position_one / 8));
        Patch p = patch_by_edges(t.vertex[0], t.vertex[1], t.vertex[2]);
        vec3 b = weights(t);
        vec4 f = uintBitsToFloat(result_bits(at(p, b.x, b.y, b.z)));
        mean = mean + (f - z);
    }
    precise vec4 quarter = mean * 0.25;
    return quarter;
}

vec4 mean_of(int tile, ivec2 cell, ivec2 v) {
    int how = division(first_site, cell);
    if (how == division_other)
        return mean_by_position(tile, cell, v);
    bool v_to_d = (how == division_down) == ((v.x == cell.x) == (v.y == cell.y));
    QuadrantCell c = quadrant_cell(cell, v, v_to_d);
    return v_to_d ? through(c) : across(c);
}

// The sum of the quadrants' means of a vertex that is not on the rim, and the range of its pixels.
void measure(int tile, ivec2 p, out vec4 sum_, out vec4 low, out vec4 high) {
    precise vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; ++i)
        sum = sum + mean_of(tile, p - 1 + ivec2(i & 1, i >> 1), p);
    sum_ = sum;
    low = source_at(p);
    high = low;
    for (int i = 0; i < 9; ++i) {
        vec4 n = source_at(p + ivec2(i % 3 - 1, i / 3 - 1));
        low = if_less(n, low, n, low);
        high = if_less(high, n, n, high);
    }
}

#ifdef FITTED
// Bend the edges to the right of the pixel p, below it and in its cell: sites 1, 2 and 3 of its four.
void bend_edges(ivec2 p, ivec2 size) {
    for (int k = p.x + 1 < size.x ? 1 : 2; k < 4; ++k) {
        ivec2 m = 2 * p + ivec2(k & 1, k >> 1);
        if (m.x > 2 * size.x - 2 || m.y > 2 * size.y - 2)
            continue;
        int s = first_site + offset(m);
        Edge e = edge_at(s);
        precise vec4 both = bends[s - offset(e.v)] + bends[s + offset(e.v)];
        precise vec4 index = both * 0.5;
        bends[s] = fitted_bend(e, m, gain[s], index, size);
    }
}
#endif

void main() {
    int tile = int(gl_GlobalInvocationID.z);
    ivec2 p = ivec2(gl_GlobalInvocationID.xy), size = extent[tile].xy;
    if (p.x >= size.x || p.y >= size.y || !is_needed(tile, p))
        return;
    first_site = tile * slot_sites;
    first_pixel = tile * slot_pixels;
    vec4 z = value_at(p);
    if (p.x > 0 && p.y > 0 && p.x + 1 < size.x && p.y + 1 < size.y) {
        precise vec4 sum;
        vec4 low, high;
        measure(tile, p, sum, low, high);
#ifdef FITTED
        precise vec4 move = vec4(0.0) - sum * 0.25;
        z = fitted_vertex(surroundings(p, size), bends[first_site + offset(2 * p)], move, limit,
                          lowest, low, high);
#else
        widen(limit, lowest, low, high);
        z = corrected(z, source_at(p), sum, low, high);
#endif
    }
#ifdef FITTED
    if (is_within(tile, p, margin - 1))
        bend_edges(p, size);
#endif
    corrected_value[pixel_of(p)] = floatBitsToUint(z);
}
