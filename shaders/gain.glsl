// SPDX-License-Identifier: Apache-2.0
// The gain of flipping an edge. C++ twin: core/triangulate/gain-inl.h.
#include "lattice.glsl"
#include "cost.glsl"
#ifdef CONTOURS
#include "contour_gain.glsl"
#endif

Face face_of(float ex, float ey, float ox, float oy, float de, float d_o) {
    precise float gx = (de * oy) - (d_o * ey);
    precise float gy = (d_o * ex) - (de * ox);
    return face(gx, gy);
}

// The gain of flipping the flippable edge e at m by costs. What lies beyond the sides is gathered
// where it is used, a side after the other.
float flip_gain(int m, Edge e) {
    Side s = first_side(e);
    float vx = float(e.v.x), vy = float(e.v.y), wx = float(s.vector.x), wy = float(s.vector.y);
    int dv = offset(e.v), dl = offset(e.left);
    float za = guide_at(m - dv), zb = guide_at(m + dv), zc = guide_at(m + dl),
          zd = guide_at(m - dl);
    precise float b_a = zb - za, c_a = zc - za, b_d = zb - zd, d_a = zd - za, b_c = zb - zc;
    precise float ca_da = c_a + d_a, bc_bd = b_c + b_d;
    Face abc = face_of(vx, vy, wx, wy, b_a, c_a);
    Face abd = face_of(vx, vy, wx, wy, b_a, b_d);
    Face adc = face_of(vx, vy, wx, wy, ca_da, c_a);
    Face bcd = face_of(vx, vy, wx, wy, bc_bd, b_d);

    // The edge that the flip makes, d to c.
    precise float ux = vx - wx, uy = vy - wy;
    precise float fx = wx - ux, fy = wy - uy;
    precise float before = between(abc, abd, vx, vy), after = between(adc, bcd, fx, fy);
    vec4 z = vec4(za, zc, zb, zd); // of the sides' first ends, this side's first
    int k = 0;
    do {
        int middle = m + offset(middle_of(s));
        Edge side = edge_at(middle);
        ivec2 apex = apex_beyond(side, s.inner);
        bool rim = is_zero(apex);
        float present = rim ? 0.0 : 1.0;
        ivec2 outer = from_first_end(apex, s.vector);
        float z_outer = rim ? z.x : guide_at(middle + offset(apex));
        precise float along = z.y - z.x, across = z_outer - z.x;
        float sx = float(s.vector.x), sy = float(s.vector.y);
        Face beyond = face_of(sx, sy, float(outer.x), float(outer.y), along, across);
        Face was, is;
        was = k < 2 ? abc : abd;
        is = k == 0 || k == 3 ? adc : bcd;
        before = before + present * between(beyond, was, sx, sy);
        after = after + present * between(beyond, is, sx, sy);
        z = z.yzwx;
        s = next_side(s);
        ++k;
    } while (!once_round(s, e));
    precise float gain = before - after;
    return gain;
}

// The same with the contours' share, if they count; m is the edge's number in the array that SITE
// looks at, `site_` among all.
float gain_at(int m, int site_, Edge e) {
    precise float gain = flip_gain(m, e);
#ifdef CONTOURS
    ivec2 w = (e.v + e.left) / 2;
    float along = contour_gain(contours_at(site_, e.v), w, e.v - w);
    gain = gain + contour_weight * along;
#endif
    return gain;
}
