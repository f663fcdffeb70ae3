// The gain of flipping an edge. C++ twins: core/triangulate/gain-inl.h and gain.h.
#include "lattice.glsl"
#include "cost.glsl"

struct Outer {
    float ox, oy, z, present;
};
struct Neighbourhood {
    float vx, vy, wx, wy;
    float za, zb, zc, zd;
    Outer outer[4];
};

Face face_of(float ex, float ey, float ox, float oy, float de, float d_o) {
    precise float gx = (de * oy) - (d_o * ey);
    precise float gy = (d_o * ex) - (de * ox);
    return face(gx, gy);
}

float flip_gain(Neighbourhood n) {
    precise float b_a = n.zb - n.za, c_a = n.zc - n.za, b_d = n.zb - n.zd, d_a = n.zd - n.za,
                  b_c = n.zb - n.zc;
    precise float ca_da = c_a + d_a, bc_bd = b_c + b_d;
    Face abc = face_of(n.vx, n.vy, n.wx, n.wy, b_a, c_a);
    Face abd = face_of(n.vx, n.vy, n.wx, n.wy, b_a, b_d);
    Face adc = face_of(n.vx, n.vy, n.wx, n.wy, ca_da, c_a);
    Face bcd = face_of(n.vx, n.vy, n.wx, n.wy, bc_bd, b_d);

    precise float ux = n.vx - n.wx, uy = n.vy - n.wy;
    precise float o0 = n.outer[0].z - n.za, o1 = n.outer[1].z - n.zc, o2 = n.outer[2].z - n.zb,
                  o3 = n.outer[3].z - n.zd;
    Face beyond_ac = face_of(n.wx, n.wy, n.outer[0].ox, n.outer[0].oy, c_a, o0);
    Face beyond_cb = face_of(ux, uy, n.outer[1].ox, n.outer[1].oy, b_c, o1);
    Face beyond_bd = face_of(0.0 - n.wx, 0.0 - n.wy, n.outer[2].ox, n.outer[2].oy, 0.0 - b_d, o2);
    Face beyond_da = face_of(0.0 - ux, 0.0 - uy, n.outer[3].ox, n.outer[3].oy, 0.0 - d_a, o3);

    // The edge that the flip makes, d to c.
    precise float fx = n.wx - ux, fy = n.wy - uy;
    precise float before = between(abc, abd, n.vx, n.vy);
    before = before + n.outer[0].present * between(beyond_ac, abc, n.wx, n.wy);
    before = before + n.outer[1].present * between(beyond_cb, abc, ux, uy);
    before = before + n.outer[2].present * between(beyond_bd, abd, n.wx, n.wy);
    before = before + n.outer[3].present * between(beyond_da, abd, ux, uy);
    precise float after = between(adc, bcd, fx, fy);
    after = after + n.outer[0].present * between(beyond_ac, adc, n.wx, n.wy);
    after = after + n.outer[1].present * between(beyond_cb, bcd, ux, uy);
    after = after + n.outer[2].present * between(beyond_bd, bcd, n.wx, n.wy);
    after = after + n.outer[3].present * between(beyond_da, adc, ux, uy);
    precise float gain = before - after;
    return gain;
}

// Gather what the gain of the flippable edge e at m depends on.
Neighbourhood neighbourhood(int m, Edge e) {
    Side s = first_side(e);
    Neighbourhood n;
    n.vx = float(e.v.x);
    n.vy = float(e.v.y);
    n.wx = float(s.vector.x);
    n.wy = float(s.vector.y);
    int dv = offset(e.v), dl = offset(e.left);
    n.za = guide_at(m - dv);
    n.zb = guide_at(m + dv);
    n.zc = guide_at(m + dl);
    n.zd = guide_at(m - dl);
    float first_end[4] = float[4](n.za, n.zc, n.zb, n.zd);
    for (int k = 0; k < 4; ++k) {
        int middle = m + offset(middle_of(s));
        Edge side = edge_at(middle);
        ivec2 apex = side.left + side.right - s.inner;
        bool rim = is_zero(apex);
        n.outer[k].ox = float((apex.x + s.vector.x) >> 1);
        n.outer[k].oy = float((apex.y + s.vector.y) >> 1);
        n.outer[k].present = rim ? 0.0 : 1.0;
        n.outer[k].z = rim ? first_end[k] : guide_at(middle + offset(apex));
        s = next_side(s);
    }
    return n;
}
