// SPDX-License-Identifier: Apache-2.0
// One consistency round, one invocation a vertex. C++ twin:
// core/surface/consistency/consistency.cpp, which goes through the cells and adds to their corners;
// the sum here takes the cells in the same order.
#include "net.glsl"
#include "served.glsl"
#include "locate.glsl"
#include "source.glsl"
#include "consistency.glsl"
#ifdef FITTED
#include "fitted.glsl"
#include "fitted_index.glsl"
#include "fitted_vertex.glsl"
#endif

layout(local_size_x = SURFACE_GROUP_X, local_size_y = SURFACE_GROUP_Y) in; // z: a tile

layout(std430, binding = BIND_CORRECTED) writeonly buffer Corrected { uvec4 corrected_value[]; };

// FITTED: vertices go where their features' weights say (C++ twin: move_fitted() in
// core/surface/fitted/fitted.cpp).
#ifdef FITTED
// A site; at vertices indices.
layout(std430, binding = BIND_BENDS) readonly buffer Bends { vec4 bends[]; };
#endif

layout(location = AT_LIMIT) uniform float limit;
layout(location = AT_CLIPPED) uniform bool clipped;
layout(location = AT_STRENGTH) uniform float strength;

// The cell seen from its corner v.
QuadrantCell quadrant_cell(ivec2 cell, ivec2 v) {
    ivec2 d = 2 * cell + 1 - v, x = ivec2(d.x, v.y), y = ivec2(v.x, d.y);
    QuadrantCell c;
    c.v = value_at(v);
    c.x = value_at(x);
    c.y = value_at(y);
    c.d = value_at(d);
#ifdef QUADRATIC
    c.vx = bend(v, x);
    c.vy = bend(v, y);
    c.xd = bend(x, d);
    c.yd = bend(y, d);
    c.diagonal = bend(v, d); // or x to y: its site is the same
#endif
#ifdef SOFT
    c.qvx = softness(v, x);
    c.qvy = softness(v, y);
    c.qxd = softness(x, d);
    c.qyd = softness(y, d);
    c.q_diagonal = softness(v, d);
#endif
    return c;
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
        Patch p = patch_of(t.vertex[0], t.vertex[1], t.vertex[2]);
        vec3 b = weights(t);
        vec4 f = uintBitsToFloat(result_bits(at(p, b.x, b.y, b.z)));
        mean = mean + (f - z);
    }
    precise vec4 quarter = mean * 0.25;
    return quarter;
}

// Quadrants of the group's vertices in cells that other edges cross. They take many times as long
// as others and are few: the group shares them, or most of it would wait for some at every vertex.
const int group_vertices = SURFACE_GROUP_X * SURFACE_GROUP_Y;
shared uint crossed_count;
shared uint crossed[4 * group_vertices];      // 4 times the vertex' invocation, and its quadrant
shared vec4 crossed_mean[4 * group_vertices]; // in that place

// The cell of a vertex' quadrant, in the order of rows.
ivec2 cell_of(ivec2 p, int quadrant) {
    return p - 1 + ivec2(quadrant & 1, quadrant >> 1);
}

void list_crossed(ivec2 p) {
    for (int i = 0; i < 4; ++i)
        if (division(first_site, cell_of(p, i)) == division_crossed)
            crossed[atomicAdd(crossed_count, 1)] = 4 * gl_LocalInvocationIndex + uint(i);
}

void share_crossed(int tile) {
    ivec2 corner = ivec2(gl_WorkGroupID.xy) * ivec2(SURFACE_GROUP_X, SURFACE_GROUP_Y);
    for (uint i = gl_LocalInvocationIndex; i < crossed_count; i += group_vertices) {
        int which = int(crossed[i]), vertex = which >> 2;
        ivec2 p = corner + ivec2(vertex % SURFACE_GROUP_X, vertex / SURFACE_GROUP_X);
        crossed_mean[which] = mean_by_position(tile, cell_of(p, which & 3), p);
    }
}

// After share_crossed().
vec4 mean_of(ivec2 v, int quadrant) {
    ivec2 cell = cell_of(v, quadrant);
    int how = division(first_site, cell);
    if (how == division_crossed)
        return crossed_mean[4 * int(gl_LocalInvocationIndex) + quadrant];
    bool v_to_d = (how == division_down) == ((v.x == cell.x) == (v.y == cell.y));
    QuadrantCell c = quadrant_cell(cell, v);
    return v_to_d ? through(c) : across(c);
}

// The sum of the quadrants' means of a vertex that is not on the rim. C++ twin: add_means().
vec4 add_means(ivec2 p) {
    precise vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; ++i)
        sum = sum + mean_of(p, i);
    return sum;
}

// What the vertex at p, not on the rim, may become: the range of its 3x3 pixels, widened.
void find_limits(ivec2 p, vec4 margin, out vec4 low, out vec4 high) {
    low = source_at(p);
    high = low;
    for (int i = 0; i < 9; ++i) {
        vec4 n = source_at(p + ivec2(i % 3 - 1, i / 3 - 1));
        low = lower(low, n);
        high = upper(high, n);
    }
    widen(margin, clipped, source_at(p), low, high);
}

void main() {
    int tile = int(gl_GlobalInvocationID.z);
    ivec2 p = ivec2(gl_GlobalInvocationID.xy), size = extent[tile].xy;
    first_site = tile * slot_sites;
    first_pixel = tile * slot_pixels;
    bool needed = p.x < size.x && p.y < size.y && is_needed(tile, p);
    bool within = needed && p.x > 0 && p.y > 0 && p.x + 1 < size.x && p.y + 1 < size.y;
    if (gl_LocalInvocationIndex == 0)
        crossed_count = 0;
#ifdef FITTED
    read_near(size);
#endif
    barrier();
    if (within)
        list_crossed(p);
    barrier();
    share_crossed(tile);
    barrier();
    if (!needed)
        return;
    vec4 z = value_at(p);
    if (within) {
        precise vec4 sum = add_means(p);
        vec4 low, high;
#ifdef FITTED
        bool cut = clipped && all_pixels(p, size);
        precise vec4 step_ = vec4(0.0) - sum * 0.25;
        VertexFeatures v = find_features(step_, cut);
        v.index = bends[first_site + offset(2 * p)];
        find_limits(p, fitted_limit(vec4(limit), v.bound), low, high);
        z = fitted_vertex(z, strength, low, high, v);
#else
        find_limits(p, vec4(limit), low, high);
        precise float share = 0.25 * strength;
        z = corrected(z, source_at(p), sum, share, low, high);
#endif
    }
    corrected_value[pixel_of(p)] = floatBitsToUint(z);
}
