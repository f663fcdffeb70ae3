// SPDX-License-Identifier: Apache-2.0
// Draws a number for every edge. C++ twin: Annealing::shuffle() in core/triangulate/annealing.h.
#define DRAWN writeonly
#include "tin.glsl"
#include "annealing.glsl"

// Of edges: x, y.
layout(std430, binding = BIND_TIN_PLACES) readonly buffer Places { uvec2 places[]; };

void main() {
    int m = own_index();
    if (m < count)
        drawn[m] = draw(places[m]);
}
