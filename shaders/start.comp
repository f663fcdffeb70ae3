// SPDX-License-Identifier: Apache-2.0
// The starting mesh and the gains of its edges, one invocation a pixel. C++ twin: Lattice::start.
//
// A group makes the part of the mesh that its gains depend on in an array of its own, so that they
// do not wait for the whole mesh to go to memory and come back.
const int group_width = START_GROUP_X, group_height = START_GROUP_Y;
// Gains of a pixel's edges look one pixel back and two ahead.
const int near_width = group_width + 3, near_height = group_height + 3;
const int near_stride = 2 * near_width;
shared uvec2 near_site[near_stride * 2 * near_height];
#define SITE(m) near_site[m]
#define STRIDE near_stride
#include "lists.glsl"
#include "gain.glsl"
#ifdef CONTOURS
#include "contour.glsl"
#endif

layout(local_size_x = START_GROUP_X, local_size_y = START_GROUP_Y) in; // z: a tile

const int own_most = group_width * group_height * 3;
#include "append.glsl"

layout(std430, binding = BIND_GUIDE) readonly buffer Guide { float guide[]; };

layout(location = AT_FLAT_START) uniform bool flat_start;
layout(location = AT_WITH_GAINS) uniform bool with_gains;

shared uint evaluated;

int width, height, first_pixel, first_site;

float z(int x, int y) {
    return guide[first_pixel + y * slot_width + x];
}
// Whether the diagonal of the cell (x, y) goes from upper left to lower right; the cell must exist.
bool down(int x, int y) {
    precise float falling = abs(z(x, y) - z(x + 1, y + 1));
    precise float rising = abs(z(x + 1, y) - z(x, y + 1));
    bool flatter = falling <= rising;
#ifdef CONTOURS
    int xy = contour_xy(contour_words[(first_site + 2 * (y * stride + x)) / 2]);
    flatter = xy == 0 ? flatter : xy < 0;
#endif
    bool is_down = !flat_start || flatter;
    return is_down;
}

// Make the sites of the pixel (x, y), which is at s in near_site.
void make_sites(int x, int y, int s) {
    bool has_left = x > 0, has_above = y > 0, has_right = x + 1 < width, has_below = y + 1 < height;
    near_site[s] =
        uvec2(floatBitsToUint(z(x, y)), edge_key(has_right ? ivec2(1, 0) : ivec2(-1, 0)));
    bool own = has_right && has_below && down(x, y);
    if (has_right) {
        bool above = has_above && down(x, y - 1);
        near_site[s + 1] =
            pack(Edge(ivec2(1, 0), has_below ? ivec2(own ? 1 : -1, 2) : ivec2(0),
                      has_above ? ivec2(above ? -1 : 1, -2) : ivec2(0)));
    }
    if (has_below) {
        bool before = has_left && down(x - 1, y);
        near_site[s + near_stride] =
            pack(Edge(ivec2(0, 1), has_left ? ivec2(-2, before ? -1 : 1) : ivec2(0),
                      has_right ? ivec2(2, own ? 1 : -1) : ivec2(0)));
    }
    if (has_right && has_below)
        near_site[s + near_stride + 1] = pack(own ? Edge(ivec2(1, 1), ivec2(-1, 1), ivec2(1, -1))
                                                  : Edge(ivec2(-1, 1), ivec2(-1, -1), ivec2(1, 1)));
}

// Whether the pixel has the site of this bit pattern: 1 the edge to the right, 2 to below, 3 the
// diagonal.
bool has_site(int x, int y, int k) {
    return ((k & 1) == 0 || x + 1 < width) && ((k & 2) == 0 || y + 1 < height);
}

void main() {
    int tile = int(gl_GlobalInvocationID.z);
    int x = int(gl_GlobalInvocationID.x), y = int(gl_GlobalInvocationID.y);
    width = extent[tile].x;
    height = extent[tile].y;
    first_pixel = tile * slot_pixels;
    first_site = tile * slot_sites;
    if (gl_LocalInvocationIndex == 0)
        evaluated = 0;
    begin_list();

    ivec2 corner = ivec2(gl_WorkGroupID.xy) * ivec2(group_width, group_height) - 1;
    for (int i = int(gl_LocalInvocationIndex); i < near_width * near_height;
         i += group_width * group_height) {
        ivec2 at = ivec2(i % near_width, i / near_width), p = corner + at;
        if (p.x >= 0 && p.y >= 0 && p.x < width && p.y < height)
            make_sites(p.x, p.y, 2 * at.y * near_stride + 2 * at.x);
    }
    barrier();

    if (x < width && y < height) {
        int s = tile * slot_sites + 2 * y * stride + 2 * x;
        int own = 2 * (int(gl_LocalInvocationID.y) + 1) * near_stride +
                  2 * (int(gl_LocalInvocationID.x) + 1);
        for (int k = 0; k < 4; ++k) {
            int m = s + (k >> 1) * stride + (k & 1), near = own + (k >> 1) * near_stride + (k & 1);
            if (!has_site(x, y, k))
                continue;
            site[m] = near_site[near];
            if (k == 0 || !with_gains)
                continue;
            float g = no_gain;
            Edge e = edge_at(near);
            if (flippable(e)) {
                g = gain_at(near, m, e);
                atomicAdd(evaluated, 1);
                if (g > min_gain)
                    collect(m);
            }
            gain[m] = g;
        }
    }
    barrier();
    if (gl_LocalInvocationIndex == 0 && evaluated > 0) {
        int c = counts_of(first_iteration, tile);
        atomicAdd(counts[c].evaluated, evaluated);
        own_base = atomicAdd(counts[c].candidates, own_count);
        atomicMax(arguments[arguments_of(first_iteration, STEP_SELECT)],
                  groups_for(own_base + own_count));
    }
    barrier();
    append_list(tile);
}
