// SPDX-License-Identifier: Apache-2.0
// How far edges go about what a tile serves, gathered a group: of those with an end beyond its
// left, upper, right or lower side. A triangle read within these sides goes no further, nor does
// one beside it, and so on. After lists.glsl.

shared uint own_reach[4];

// Before a barrier.
void begin_reach() {
    if (gl_LocalInvocationIndex < 4)
        own_reach[gl_LocalInvocationIndex] = 0;
}

// Of the edge that the flip of e at m makes.
void add_reach(int tile, int m, Edge e) {
    int place = m - tile * slot_sites;
    ivec2 at = ivec2(place % stride, place / stride), far = abs(e.left);
    ivec4 sides = 2 * served[tile];
    if (at.x - far.x < sides.x)
        atomicMax(own_reach[0], uint(far.x));
    if (at.y - far.y < sides.y)
        atomicMax(own_reach[1], uint(far.y));
    if (at.x + far.x > sides.z)
        atomicMax(own_reach[2], uint(far.x));
    if (at.y + far.y > sides.w)
        atomicMax(own_reach[3], uint(far.y));
}

// After a barrier.
void keep_reach(int tile) {
    uint side = gl_LocalInvocationIndex;
    if (side < 4 && own_reach[side] > 0)
        atomicMax(reach[4 * tile + int(side)], own_reach[side]);
}
