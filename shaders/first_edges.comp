// Offer each edge to its ends, which keep the one with the smallest address. C++ twin:
// Lattice::find_first_edges.
#include "lattice.glsl"
#include "first.glsl"

layout(local_size_x = 64, local_size_y = 2) in; // a site; z: a tile

void main() {
    int tile = int(gl_GlobalInvocationID.z);
    int x = int(gl_GlobalInvocationID.x), y = int(gl_GlobalInvocationID.y);
    if (x >= 2 * extent[tile].x - 1 || y >= 2 * extent[tile].y - 1 || ((x | y) & 1) == 0)
        return;
    int m = tile * slot_sites + y * stride + x;
    ivec2 v = edge_at(m).v;
    atomicMin(site[m - offset(v)].y, first_key(v));
    atomicMin(site[m + offset(v)].y, first_key(-v));
}
