// SPDX-License-Identifier: Apache-2.0
// Which pixels matter. A tile's halo is there for its mesh; its surface is read in the middle only,
// and a triangle that is read there goes no further than its edges. After lattice.glsl.
#include "counts.glsl"

// How far about what the tile serves, in edges' lengths, results are needed.
layout(location = AT_MARGIN) uniform int margin;

// Whether p is no further off than that many edges go.
bool is_within(int tile, ivec2 p, int edges) {
    int side = 4 * tile;
    ivec2 before = edges * ivec2(reach[side], reach[side + 1]),
          after = edges * ivec2(reach[side + 2], reach[side + 3]);
    return all(greaterThanEqual(p, served[tile].xy - before)) &&
           all(lessThanEqual(p, served[tile].zw + after));
}
bool is_needed(int tile, ivec2 p) {
    return is_within(tile, p, margin);
}
