// SPDX-License-Identifier: Apache-2.0
// Draws a number for every edge. C++ twin: Annealing::shuffle() in core/triangulate/annealing.h.
#include "tin.glsl"
#include "annealing.glsl"

layout(std430, binding = 7) readonly buffer Places { uvec2 places[]; }; // of edges: x, y
layout(std430, binding = 8) writeonly buffer Drawn { uint drawn[]; };   // an edge

void main() {
    int m = own_index();
    if (m < count)
        drawn[m] = draw(places[m]);
}
