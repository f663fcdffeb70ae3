// SPDX-License-Identifier: Apache-2.0
// Included inside a namespace, once for scalars and once for each SIMD target: T is float or a
// vector of floats. GLSL twin: shaders/gain.glsl.
// Needs: contour.h, arith.h, cost-inl.h, quad-inl.h.

/// What the gain of flipping edge ab, with apexes c (left) and d, depends on: eight vertices. The
/// sides are in the order of QuadOf (core/lattice/quad-inl.h).
template <class T>
struct Neighbourhood {
    T vx, vy;         ///< b - a in pixels
    T wx, wy;         ///< c - a in pixels
    T za, zb, zc, zd; ///< the guide at the parallelogram's corners
    /// The triangles beyond the sides: the third vertex relative to the side's first
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

/// Present, and known to be: costs no multiplication.
struct Always {};
template <class T>
DDT_INLINE T operator*(Always, T x) {
    return x;
}

/// The flip of an edge ab to cd, as far as costs depend on it; sides in the order of QuadOf.
template <class Cost, class T, class Presence = T>
struct Flip {
    using Face = typename Cost::Face;
    T edge, side[4];     ///< costs as they stand; of a side on the rim: 0
    Face adc, bcd;       ///< the triangles that the flip makes
    Face beyond[4];      ///< those beyond the sides
    Presence present[4]; ///< 1, or 0 of a side on the rim
    T wx, wy;            ///< c - a in pixels
    T ux, uy;            ///< b - c in pixels

    /// Cost of the edge and the four sides before the flip, minus after it.
    DDT_INLINE T gain() const {
        const T before = (((edge + side[0]) + side[1]) + side[2]) + side[3];
        T after = Cost::between(adc, bcd, wx - ux, wy - uy);
        after = after + present[0] * Cost::between(beyond[0], adc, wx, wy);
        after = after + present[1] * Cost::between(beyond[1], bcd, ux, uy);
        after = after + present[2] * Cost::between(beyond[2], bcd, wx, wy);
        after = after + present[3] * Cost::between(beyond[3], adc, ux, uy);
        return before - after;
    }
};

/// The gain of the flip in the neighbourhood.
template <class Cost, class T>
DDT_INLINE T flip_gain(const Neighbourhood<T>& n) {
    // In the frame a + s v + t w the triangles have these (d/ds, d/dt); det(v, w) = 1.
    const T b_a = n.zb - n.za, c_a = n.zc - n.za, b_d = n.zb - n.zd, d_a = n.zd - n.za,
            b_c = n.zb - n.zc;
    const auto abc = face_of<T, Cost>(n.vx, n.vy, n.wx, n.wy, b_a, c_a);
    const auto abd = face_of<T, Cost>(n.vx, n.vy, n.wx, n.wy, b_a, b_d);
    Flip<Cost, T> f;
    f.adc = face_of<T, Cost>(n.vx, n.vy, n.wx, n.wy, c_a + d_a, c_a);
    f.bcd = face_of<T, Cost>(n.vx, n.vy, n.wx, n.wy, b_c + b_d, b_d);

    const T zero = T(0.0f);
    const T ux = n.vx - n.wx, uy = n.vy - n.wy;
    const auto* o = n.outer;
    f.beyond[0] = face_of<T, Cost>(n.wx, n.wy, o[0].ox, o[0].oy, c_a, o[0].z - n.za);
    f.beyond[1] = face_of<T, Cost>(ux, uy, o[1].ox, o[1].oy, b_c, o[1].z - n.zc);
    f.beyond[2] =
        face_of<T, Cost>(zero - n.wx, zero - n.wy, o[2].ox, o[2].oy, zero - b_d, o[2].z - n.zb);
    f.beyond[3] =
        face_of<T, Cost>(zero - ux, zero - uy, o[3].ox, o[3].oy, zero - d_a, o[3].z - n.zd);

    f.wx = n.wx;
    f.wy = n.wy;
    f.ux = ux;
    f.uy = uy;
    f.present[0] = o[0].present;
    f.present[1] = o[1].present;
    f.present[2] = o[2].present;
    f.present[3] = o[3].present;
    f.edge = Cost::between(abc, abd, n.vx, n.vy);
    f.side[0] = o[0].present * Cost::between(f.beyond[0], abc, n.wx, n.wy);
    f.side[1] = o[1].present * Cost::between(f.beyond[1], abc, ux, uy);
    f.side[2] = o[2].present * Cost::between(f.beyond[2], abd, n.wx, n.wy);
    f.side[3] = o[3].present * Cost::between(f.beyond[3], abd, ux, uy);
    return f.gain();
}

/// What lies beyond side k, with this midpoint, of a quad; `first_end`: the guide at the side's.
template <class T, class Mesh, class Quad_>
DDT_INLINE typename Neighbourhood<T>::Outer look_beyond(const Mesh& mesh, const Quad_& q, int k,
                                                        typename Mesh::Sites middle, T first_end) {
    const auto apex = apex_beyond(mesh.side(k, middle), q.inner[k]);
    const auto outer = from_first_end(apex, q.side[k]);
    return {mesh.x(outer), mesh.y(outer), mesh.guide_beyond(middle, apex, first_end),
            mesh.present(apex)};
}

/// Gather what the gain of the flippable edges at m depends on: a site and T = float, or as many as
/// T has lanes. Mesh: a lattice seen so, OneSite in gain.h or SiteLanes in
/// core/lattice/site_lanes-inl.h.
template <class T, class Mesh>
DDT_INLINE Neighbourhood<T> neighbourhood(const Mesh& mesh, typename Mesh::Sites m) {
    const auto e = mesh.flippable_edge(m);
    const QuadOf<typename Mesh::V> q(e.v, e.left);
    const QuadSites<typename Mesh::Sites> at(m, mesh.offset(q.w), mesh.offset(q.side[1]));
    Neighbourhood<T> n;
    n.vx = mesh.x(q.v);
    n.vy = mesh.y(q.v);
    n.wx = mesh.x(q.w);
    n.wy = mesh.y(q.w);
    n.za = mesh.guide(at.a);
    n.zb = mesh.guide(at.b);
    n.zc = mesh.guide(at.c);
    n.zd = mesh.guide(at.d);
    const T first_ends[4] = {n.za, n.zc, n.zb, n.zd};
    for (int k = 0; k < 4; ++k)
        n.outer[k] = look_beyond<T>(mesh, q, k, at.middle[k], first_ends[k]);
    return n;
}

/// The contours at an edge's midpoint: the integers of two cells' words together
/// (core/guide/contour.h).
template <class T>
struct Contours {
    T xx, yy, xy;
};

/// Of the cells that meet at the midpoint m of a flippable edge along v; a diagonal's is in the
/// middle of one, which counts twice.
template <class T, class Mesh, class V>
DDT_INLINE Contours<T> contours_at(const Mesh& mesh, typename Mesh::Sites m, V v) {
    // m is odd where v is; a cell's word is at its upper left corner.
    const auto cell = m - mesh.offset(odd(v));
    const auto other = cell - mesh.offset(even(v) + even(v));
    const auto words = mesh.contour(cell) + mesh.contour(other);
    return {mesh.template steps<0>(words), mesh.template steps<1>(words),
            mesh.template steps<2>(words) - T(float(contour_steps))};
}

/// What a flip lowers v' N v by, in units of contour_unit: with v = w + u and the other diagonal
/// w - u it is 4 w' N u. All numbers are whole and, no edge being longer than longest_edge, below
/// 2^24: exact.
template <class T>
DDT_INLINE T contour_gain(const Contours<T>& n, T wx, T wy, T ux, T uy) {
    return ((n.xx * (wx * ux)) + (n.yy * (wy * uy))) + (n.xy * ((wx * uy) + (wy * ux)));
}

/// The gain of flipping the flippable edges at m; `contour` times contour_unit of the contours', if
/// any.
template <class Cost, class T, class Mesh>
DDT_INLINE T gain_at(const Mesh& mesh, typename Mesh::Sites m, float contour) {
    const Neighbourhood<T> n = neighbourhood<T>(mesh, m);
    const T gain = flip_gain<Cost>(n);
    if (contour == 0)
        return gain;
    const T along = contour_gain(contours_at<T>(mesh, m, mesh.flippable_edge(m).v), n.wx, n.wy,
                                 n.vx - n.wx, n.vy - n.wy);
    return gain + T(contour) * along;
}
