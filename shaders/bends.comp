// SPDX-License-Identifier: Apache-2.0
// Fitted bends, one invocation a site; the indices of the edges' ends are in their place already.
// C++ twin: bend_edges in core/surface/fitted/fitted.cpp.
#include "net.glsl"
#include "served.glsl"
#include "fitted.glsl"
#include "fitted_bend.glsl"

layout(local_size_x = 64, local_size_y = 2) in; // z: a tile

layout(std430, binding = 5) buffer Bends { vec4 bends[]; }; // a site

void main() {
    int tile = int(gl_GlobalInvocationID.z);
    ivec2 m = ivec2(gl_GlobalInvocationID.xy), size = extent[tile].xy;
    if (m.x >= 2 * size.x - 1 || m.y >= 2 * size.y - 1 || ((m.x | m.y) & 1) == 0 ||
        !is_needed(tile, m / 2))
        return;
    first_site = tile * slot_sites;
    first_pixel = tile * slot_pixels;
    int s = first_site + offset(m);
    Edge e = edge_at(s);
    precise vec4 both = bends[s - offset(e.v)] + bends[s + offset(e.v)];
    precise vec4 index = both * 0.5;
    bends[s] = fitted_bend(e, m, gain[s], index, size);
}
