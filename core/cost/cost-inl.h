// SPDX-License-Identifier: Apache-2.0
// Included inside a namespace, once for scalars and once for each SIMD target: T is float or a
// vector of floats. GLSL twin: shaders/cost.glsl.
// Needs: arith.h, rsqrt-inl.h.
//
// A cost is a class with a Face, what it needs to know of a triangle, made once from the gradient
// (gx, gy) of the guide in that triangle, and between(), the cost of the edge (ex, ey), in pixels,
// that two triangles share. An edge on the hull's rim costs nothing. Every cost is finite and the
// same with the triangles exchanged or the edge reversed.
//
// "DLR" is Dyn, Levin & Rippa 1990, "Data dependent triangulations for piecewise linear
// interpolation", IMA Journal of Numerical Analysis 10. The third vertex of a triangle of area D /
// 2 is D / |e| away from its edge e, and since the two gradients differ across the edge only, the
// other triangle's plane misses that vertex by D |g1 - g2| / |e|.

/// D of the two triangles beside an edge, where all areas are 1/2, as in a lattice.
struct Unimodular {};
/// The same of any triangles.
template <class T>
struct Doubled {
    T a, b;
};

/// (D1 x + D2 y) for the Ds of the triangles.
template <class T>
DDT_INLINE T weighted(T x, T y, Unimodular) {
    return x + y;
}
template <class T>
DDT_INLINE T weighted(T x, T y, Doubled<T> d) {
    return (d.a * x) + (d.b * y);
}
/// x (D1 + D2) / 2
template <class T>
DDT_INLINE T times_mean(T x, Unimodular) {
    return x;
}
template <class T>
DDT_INLINE T times_mean(T x, Doubled<T> d) {
    return x * (T(0.5f) * (d.a + d.b));
}
/// |g1 - g2|
template <class T>
DDT_INLINE T jump(T ax, T ay, T bx, T by) {
    const T dx = ax - bx, dy = ay - by;
    const T square = (dx * dx) + (dy * dy);
    return square * rsqrt<3>(square);
}
/// x / |e|
template <class T>
DDT_INLINE T over_length(T x, T ex, T ey) {
    return x * rsqrt<3>((ex * ex) + (ey * ey));
}

/// Angle between normals (DLR): 1 - cos of the angle between (g1, s) and (g2, s); 0 to 2.
/// s = cost_slope, 0.2, is the slope, in guide units a pixel, that counts as 45 degrees.
template <class T>
struct Abn {
    struct Face {
        T x, y, z; ///< the unit normal
    };
    static DDT_INLINE Face face(T gx, T gy) {
        const T r = rsqrt<3>(((gx * gx) + (gy * gy)) + T(cost_slope_square));
        return {gx * r, gy * r, T(cost_slope) * r};
    }
    template <class Areas = Unimodular>
    static DDT_INLINE T between(const Face& a, const Face& b, T, T, Areas = {}) {
        return T(1.0f) - (((a.x * b.x) + (a.y * b.y)) + (a.z * b.z));
    }
};

/// Sederberg's cost function (Yu, Morse & Sederberg 2001, "Image reconstruction using
/// data-dependent triangulation"), the paper's: |g1| |g2| - g1.g2.
template <class T>
struct Scf {
    struct Face {
        T x, y, length;
    };
    static DDT_INLINE Face face(T gx, T gy) {
        const T square = (gx * gx) + (gy * gy);
        return {gx, gy, square * rsqrt<3>(square)};
    }
    template <class Areas = Unimodular>
    static DDT_INLINE T between(const Face& a, const Face& b, T, T, Areas = {}) {
        return (a.length * b.length) - ((a.x * b.x) + (a.y * b.y));
    }
};

/// Jump in normal derivatives (DLR): how much the derivative across the edge jumps, |g1 - g2|.
template <class T>
struct Jnd {
    struct Face {
        T x, y;
    };
    static DDT_INLINE Face face(T gx, T gy) { return {gx, gy}; }
    template <class Areas = Unimodular>
    static DDT_INLINE T between(const Face& a, const Face& b, T, T, Areas = {}) {
        return jump(a.x, a.y, b.x, b.y);
    }
};

/// Deviation from linear polynomials (DLR): the mean, so the 1-norm, of the two vertical distances
/// of a plane from the other's third vertex. Where all areas are 1/2, both are |g1 - g2| / |e|.
template <class T>
struct Dlp {
    using Face = typename Jnd<T>::Face;
    static DDT_INLINE Face face(T gx, T gy) { return {gx, gy}; }
    template <class Areas = Unimodular>
    static DDT_INLINE T between(const Face& a, const Face& b, T ex, T ey, Areas areas = {}) {
        return times_mean(over_length(jump(a.x, a.y, b.x, b.y), ex, ey), areas);
    }
};

/// Distance from planes (DLR): the same with distances at right angles to the planes, the guide
/// in units of s as for Abn: |g1 - g2| / |e| * (D2 / |(g1, s)| + D1 / |(g2, s)|), the 1-norm.
template <class T>
struct Dp {
    struct Face {
        T x, y, r;
    };
    static DDT_INLINE Face face(T gx, T gy) {
        return {gx, gy, rsqrt<3>(((gx * gx) + (gy * gy)) + T(cost_slope_square))};
    }
    template <class Areas = Unimodular>
    static DDT_INLINE T between(const Face& a, const Face& b, T ex, T ey, Areas areas = {}) {
        return over_length(jump(a.x, a.y, b.x, b.y), ex, ey) * weighted(b.r, a.r, areas);
    }
};
