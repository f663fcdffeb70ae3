// SPDX-License-Identifier: Apache-2.0
// Which pixels matter. A tile's halo is there for its mesh; its surface is read in the middle only,
// and a triangle that is read there goes no further than its edges. After lattice.glsl.
#include "counts.glsl"

// Edges' lengths: how far about what the tile serves results are needed.
layout(location = 9) uniform int margin;

// Whether p is no further off than that many edges go.
bool is_within(int tile, ivec2 p, int edges) {
    int far = edges * int(reach[tile]);
    return all(greaterThanEqual(p, served[tile].xy - far)) &&
           all(lessThanEqual(p, served[tile].zw + far));
}
bool is_needed(int tile, ivec2 p) {
    return is_within(tile, p, margin);
}
