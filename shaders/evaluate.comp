// Gains of the edges a flip touched; DENSE: of all edges, in the first iteration.
#include "work.glsl"

#ifdef DENSE
layout(local_size_x = 64, local_size_y = 2) in; // a site; z: a tile
#else
layout(local_size_x = 64) in; // an entry of the list; y: a tile
#endif

shared uint evaluated;

void main() {
    if (gl_LocalInvocationIndex == 0)
        evaluated = 0;
    barrier();
#ifdef DENSE
    int tile = int(gl_GlobalInvocationID.z);
    int m = edge_of_invocation(tile);
#else
    int tile = int(gl_GlobalInvocationID.y);
    uint i = gl_GlobalInvocationID.x;
    int m = i < counts[counts_of(first_iteration, tile)].dirty ? dirty[tile * list_size + int(i)]
                                                               : -1;
#endif
    if (m >= 0 && evaluate(m))
        atomicAdd(evaluated, 1);
    barrier();
    if (gl_LocalInvocationIndex == 0 && evaluated > 0)
        atomicAdd(counts[counts_of(first_iteration, tile)].evaluated, evaluated);
}
