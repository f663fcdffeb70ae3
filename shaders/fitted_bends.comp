// SPDX-License-Identifier: Apache-2.0
// Fitted bends, an invocation a site. C++ twin: bend_fitted() in core/surface/fitted/bends.cpp.
#include "net.glsl"
#include "served.glsl"
#include "fitted.glsl"
#include "fitted_bend.glsl"

layout(local_size_x = GAINS_GROUP_X, local_size_y = GAINS_GROUP_Y) in; // z: a tile

layout(std430, binding = BIND_GAINS) readonly buffer Gains { float gain[]; }; // a site
// A site; at vertices indices.
layout(std430, binding = BIND_BENDS) buffer Bends { vec4 bends[]; };

void main() {
    int s = edge_of_invocation();
    if (s < 0)
        return;
    int tile = int(gl_GlobalInvocationID.z);
    ivec2 m = ivec2(gl_GlobalInvocationID.xy);
    if (!is_needed(tile, m >> 1))
        return;
    first_site = tile * slot_sites;
    first_pixel = tile * slot_pixels;
    Edge e = edge_at(s);
    precise vec4 both = bends[s - offset(e.v)] + bends[s + offset(e.v)];
    precise vec4 index = both * 0.5;
    bends[s] = fitted_bend(e, find_features(e, m, extent[tile].xy), gain[s], index);
}
