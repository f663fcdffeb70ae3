// SPDX-License-Identifier: Apache-2.0
// Gains of edges. After lists.glsl.
#include "gain.glsl"

// Compute the gain of the edge at m. True if it can be flipped, that is, was evaluated.
bool evaluate(int m) {
    Edge e = edge_at(m);
    bool can = flippable(e);
    gain[m] = can ? gain_at(m, m, e) : no_gain;
    return can;
}
