// SPDX-License-Identifier: Apache-2.0
// Which edges of a part are outside each other's 2-region and flip. C++ twin: Annealing::select()
// and iterate() in core/triangulate/annealing.h.
#include "lists.glsl"
#include "annealing.glsl"
#include "gain.glsl"
#include "region.glsl"

layout(local_size_x = GAINS_GROUP_X, local_size_y = GAINS_GROUP_Y) in; // a site; z: a tile

layout(std430, binding = BIND_DRAWN) readonly buffer Drawn { uint drawn[]; }; // a site
// A site: 1 flips.
layout(std430, binding = BIND_DECIDED) writeonly buffer Decided { uint decided[]; };

shared uint evaluated;

bool is_selected(int m, Edge e) {
    int region[region_size];
    region_of(m, e, region);
    for (int k = 0; k < region_size; ++k) {
        int other = region[k];
        if (other >= 0 && is_of_part(drawn[other]) &&
            draws_before(other, drawn[other], m, drawn[m]) && flippable(edge_at(other)))
            return false;
    }
    return true;
}

void main() {
    if (gl_LocalInvocationIndex == 0)
        evaluated = 0;
    barrier();
    int m = edge_of_invocation();
    if (m >= 0) {
        uint flips = 0;
        Edge e = edge_at(m);
        if (is_of_part(drawn[m]) && flippable(e) && is_selected(m, e)) {
            atomicAdd(evaluated, 1);
            flips = is_taken(gain_at(m, m, e), drawn[m]) ? 1 : 0;
        }
        decided[m] = flips;
    }
    barrier();
    if (gl_LocalInvocationIndex == 0 && evaluated > 0)
        atomicAdd(counts[counts_of(0, int(gl_WorkGroupID.z))].evaluated, evaluated);
}
