// SPDX-License-Identifier: Apache-2.0
// Flips the accepted edges and marks what must be evaluated again. C++ twins: flip() of
// core/tin/tin.h, AcceptReject::flip() in core/triangulate/accept_reject.h. Two accepted edges are
// outside each other's 2-region, so neither writes what the other reads.
#include "tin.glsl"

void put(int triangle, ivec3 v, ivec3 e) {
    for (int k = 0; k < 3; ++k) {
        triangles[6 * triangle + k] = v[k];
        triangles[6 * triangle + 3 + k] = e[k];
    }
    faces[triangle] = face_of(v.x, v.y, v.z);
}

void main() {
    int m = own_index();
    if (m >= count || mark[m] != accepted)
        return;
    atomicAdd(flipped, 1u);
    Quad q = quad_of(m);
    ivec2 e = edges[m];
    put(e.x, ivec3(q.d, q.c, q.a), ivec3(m, q.ac, q.da));
    put(e.y, ivec3(q.c, q.d, q.b), ivec3(m, q.bd, q.cb));
    ivec2 cb = edges[q.cb], da = edges[q.da];
    edges[q.cb] = cb.x == e.x ? ivec2(e.y, cb.y) : ivec2(cb.x, e.y);
    edges[q.da] = da.x == e.y ? ivec2(e.x, da.y) : ivec2(da.x, e.x);
    int region[wide_region_size];
    region_of(m, false, region);
    for (int k = 0; k < wide_region_size; ++k)
        if (region[k] >= 0)
            mark[region[k]] = dirty;
    mark[m] = dirty;
}
