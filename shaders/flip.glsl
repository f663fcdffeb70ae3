// SPDX-License-Identifier: Apache-2.0
// Flipping an edge. C++ twins: Lattice::flip, flip_selected in core/triangulate/one_round.h. After
// lattice.glsl.

// Let the side at m + middle_of(s), whose record is e, have the apex that came with the flip.
Edge with_apex(Edge e, Side s, ivec2 came) {
    ivec2 apex = came - middle_of(s);
    if (e.left == s.inner)
        e.left = apex;
    else
        e.right = apex;
    return e;
}

// The edge e itself afterwards.
Edge turned(Edge e) {
    return Edge(e.left, -e.v, e.v);
}

// Tell the old and new ends of the edge e at m of an edge they have when it is flipped.
void tell_ends(int m, Edge e) {
    ivec2 w = (e.v + e.left) / 2;
    site[m - offset(e.v)].y = edge_key(w);
    site[m + offset(e.v)].y = edge_key(w - e.v);
    site[m + offset(e.left)].y = edge_key(-e.left);
    site[m - offset(e.left)].y = edge_key(e.left);
}

// Flip the edge e at m, in records without the stamps of touch.glsl.
void flip(int m, Edge e) {
    Side s = first_side(e);
    for (int k = 0; k < 4; ++k) {
        int middle = m + offset(middle_of(s));
        site[middle] = pack(with_apex(edge_at(middle), s, k < 2 ? e.right : e.left));
        s = next_side(s);
    }
    site[m] = pack(turned(e));
    tell_ends(m, e);
}
