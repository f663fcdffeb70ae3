// SPDX-License-Identifier: Apache-2.0
// Included inside a namespace, once for scalars and once for each SIMD target: T is float or a
// vector of floats. GLSL twin: shaders/gain.glsl.

/// What the gain of flipping edge ab, with apexes c (left) and d, depends on: eight vertices.
template <class T>
struct Neighbourhood {
    T vx, vy;         ///< b - a in pixels
    T wx, wy;         ///< c - a in pixels
    T za, zb, zc, zd; ///< the guide at the parallelogram's corners
    /// The triangles beyond the sides ac, cb, bd, da: the third vertex relative to the side's first
    /// end in pixels, its guide, and 1; where there is none (rim): any finite numbers and 0.
    struct Outer {
        T ox, oy, z, present;
    } outer[4];
};

/// Gradient of the guide in the triangle p, p + e, p + o with det(e, o) = 1, where the guide
/// differs from its value at p by de and d_o.
template <class T, class Cost>
DDT_INLINE typename Cost::Face face_of(T ex, T ey, T ox, T oy, T de, T d_o) {
    return Cost::face((de * oy) - (d_o * ey), (d_o * ex) - (de * ox));
}

/// Cost of the edge and the four sides before the flip of ab to cd, minus after it.
template <class Cost, class T>
DDT_INLINE T flip_gain(const Neighbourhood<T>& n) {
    // In the frame a + s v + t w the triangles have these (d/ds, d/dt); det(v, w) = 1.
    const T b_a = n.zb - n.za, c_a = n.zc - n.za, b_d = n.zb - n.zd, d_a = n.zd - n.za,
            b_c = n.zb - n.zc;
    const auto abc = face_of<T, Cost>(n.vx, n.vy, n.wx, n.wy, b_a, c_a);
    const auto abd = face_of<T, Cost>(n.vx, n.vy, n.wx, n.wy, b_a, b_d);
    const auto adc = face_of<T, Cost>(n.vx, n.vy, n.wx, n.wy, c_a + d_a, c_a);
    const auto bcd = face_of<T, Cost>(n.vx, n.vy, n.wx, n.wy, b_c + b_d, b_d);

    const T zero = T(0.0f);
    const T ux = n.vx - n.wx, uy = n.vy - n.wy;
    const auto beyond_ac =
        face_of<T, Cost>(n.wx, n.wy, n.outer[0].ox, n.outer[0].oy, c_a, n.outer[0].z - n.za);
    const auto beyond_cb =
        face_of<T, Cost>(ux, uy, n.outer[1].ox, n.outer[1].oy, b_c, n.outer[1].z - n.zc);
    const auto beyond_bd = face_of<T, Cost>(zero - n.wx, zero - n.wy, n.outer[2].ox, n.outer[2].oy,
                                            zero - b_d, n.outer[2].z - n.zb);
    const auto beyond_da = face_of<T, Cost>(zero - ux, zero - uy, n.outer[3].ox, n.outer[3].oy,
                                            zero - d_a, n.outer[3].z - n.zd);

    // The edge that the flip makes, d to c.
    const T fx = n.wx - ux, fy = n.wy - uy;
    T before = Cost::between(abc, abd, n.vx, n.vy);
    before = before + n.outer[0].present * Cost::between(beyond_ac, abc, n.wx, n.wy);
    before = before + n.outer[1].present * Cost::between(beyond_cb, abc, ux, uy);
    before = before + n.outer[2].present * Cost::between(beyond_bd, abd, n.wx, n.wy);
    before = before + n.outer[3].present * Cost::between(beyond_da, abd, ux, uy);
    T after = Cost::between(adc, bcd, fx, fy);
    after = after + n.outer[0].present * Cost::between(beyond_ac, adc, n.wx, n.wy);
    after = after + n.outer[1].present * Cost::between(beyond_cb, bcd, ux, uy);
    after = after + n.outer[2].present * Cost::between(beyond_bd, bcd, n.wx, n.wy);
    after = after + n.outer[3].present * Cost::between(beyond_da, adc, ux, uy);
    return before - after;
}
