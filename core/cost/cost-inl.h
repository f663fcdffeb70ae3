// SPDX-License-Identifier: Apache-2.0
// Included inside a namespace, once for scalars and once for each SIMD target: T is float or a
// vector of floats. GLSL twin: shaders/cost.glsl.
//
// A cost is a class with a Face, what it needs to know of a triangle, made once from the gradient
// (gx, gy) of the guide in that triangle, and between(), the cost of the edge (ex, ey), in pixels,
// that two triangles share. An edge on the hull's rim costs nothing. Every cost is finite and the
// same with the triangles exchanged or the edge reversed.
//
// "DLR" is Dyn, Levin & Rippa 1990, "Data dependent triangulations for piecewise linear
// interpolation", IMA Journal of Numerical Analysis 10. Theirs hold for any triangles; here, with
// all areas 1/2, the third vertex of a triangle is 1/|e| away from its edge e, and since the two
// gradients differ across the edge only, each plane misses the other's third vertex by
// |g1 - g2| / |e|.

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
    static DDT_INLINE T between(const Face& a, const Face& b, T, T) {
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
    static DDT_INLINE T between(const Face& a, const Face& b, T, T) {
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
    static DDT_INLINE T between(const Face& a, const Face& b, T, T) {
        const T dx = a.x - b.x, dy = a.y - b.y;
        const T square = (dx * dx) + (dy * dy);
        return square * rsqrt<3>(square);
    }
};

/// Deviation from linear polynomials (DLR): the norm of the two vertical distances of a plane from
/// the other's third vertex. Both are |g1 - g2| / |e|, so every norm is that up to a factor.
template <class T>
struct Dlp {
    using Face = typename Jnd<T>::Face;
    static DDT_INLINE Face face(T gx, T gy) { return {gx, gy}; }
    static DDT_INLINE T between(const Face& a, const Face& b, T ex, T ey) {
        return Jnd<T>::between(a, b, ex, ey) * rsqrt<3>((ex * ex) + (ey * ey));
    }
};

/// Distance from planes (DLR): the same with distances at right angles to the planes, the guide
/// in units of s as for Abn: |g1 - g2| / |e| * (1 / |(g1, s)| + 1 / |(g2, s)|), the 1-norm.
template <class T>
struct Dp {
    struct Face {
        T x, y, r;
    };
    static DDT_INLINE Face face(T gx, T gy) {
        return {gx, gy, rsqrt<3>(((gx * gx) + (gy * gy)) + T(cost_slope_square))};
    }
    static DDT_INLINE T between(const Face& a, const Face& b, T ex, T ey) {
        const T dx = a.x - b.x, dy = a.y - b.y;
        const T square = (dx * dx) + (dy * dy);
        const T vertical = (square * rsqrt<3>(square)) * rsqrt<3>((ex * ex) + (ey * ey));
        return vertical * (a.r + b.r);
    }
};
