// SPDX-License-Identifier: Apache-2.0
// Included inside a namespace, once for scalars (lattice.h) and once for each SIMD target
// (lattice/site_lanes-inl.h): V is a vector of the lattice, or a lane's each. GLSL twin: Side in
// shaders/lattice.glsl.
// Needs: arith.h, +, - and half() of V.

/// The parallelogram round a flippable edge ab, whose midpoint m is the middle of its other
/// diagonal cd too, c on the left of ab. Its sides are in the order ac, cb, bd, da, in which the
/// triangle beyond each lies on the left.
///
///        a ---- 3 ---- d        v = b - a, w = c - a, det(v, w) = 1
///         \  .          \       0 to 3: the sides' midpoints
///          0     m       2      side cb, from c to b, is v - w
///           \         .   \     (y downwards, as in images)
///            c ---- 1 ---- b
template <class V>
struct QuadOf {
    V v;         ///< b - a in pixels
    V w;         ///< c - a in pixels
    V side[4];   ///< the side as a vector in pixels
    V middle[4]; ///< the side's midpoint relative to m, in doubled coordinates as what follows
    V inner[4];  ///< the apex within the parallelogram, relative to the side's midpoint

    DDT_INLINE QuadOf(V v_, V left)
        : v(v_), w(half(v_ + left)), side{w, v - w, -w, w - v}, middle{w - v, w, v - w, -w},
          inner{v + (v - w), -v - w, (w - v) - v, v + w} {}
};

/// Where a quad's sites are, by the offsets of w and of u = v - w: offsets are linear.
template <class Sites>
struct QuadSites {
    Sites a, b, c, d;
    Sites middle[4]; ///< the sides' midpoints

    DDT_INLINE QuadSites(Sites m, Sites w, Sites u)
        : a(m - (w + u)), b(m + (w + u)), c(m + (w - u)),
          d(m - (w - u)), middle{m - u, m + w, m + u, m - w} {}
};

/// The apex beyond a side: one of the side's is `inner`, the sum leaves the other; no apex is zero
/// but where there is none.
template <class V, class EdgeOfV>
DDT_INLINE V apex_beyond(const EdgeOfV& side, V inner) {
    return side.apexes() - inner;
}

/// The two other sides of the triangle between an edge and its apex, as vectors in pixels to the
/// apex from the edge's first and last end; `apex` relative to the edge's midpoint in doubled
/// coordinates, `edge` as a vector in pixels. A triangle's midline is half the side that it does
/// not touch: in doubled coordinates the same vectors lead from the edge's midpoint to the other
/// side's.
template <class V>
DDT_INLINE V from_first_end(V apex, V edge) {
    return half(apex + edge);
}
template <class V>
DDT_INLINE V from_last_end(V apex, V edge) {
    return half(apex - edge);
}
