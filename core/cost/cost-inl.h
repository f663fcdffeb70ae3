// Included inside a namespace, once for scalars and once for each SIMD target: T is float or a
// vector of floats. GLSL twin: shaders/cost.glsl.
//
// A cost is a class with a Face, what it needs to know of a triangle, made once from the gradient
// (gx, gy) of the guide in that triangle, and between(), the cost of the edge two triangles share.
// An edge on the hull's rim costs nothing. Every cost is symmetric and finite.

/// Angle between normals (Dyn, Levin & Rippa 1990, "Data dependent triangulations for piecewise
/// linear interpolation"): 1 - cos of the angle between (g1, s) and (g2, s); 0 to 2.
/// s = 0.2 is the slope, in guide units a pixel, that counts as 45 degrees.
template <class T>
struct Abn {
    struct Face {
        T x, y, z; ///< the unit normal
    };
    static DDT_INLINE Face face(T gx, T gy) {
        const T r = rsqrt<3>(((gx * gx) + (gy * gy)) + T(0.04f));
        return {gx * r, gy * r, T(0.2f) * r};
    }
    static DDT_INLINE T between(const Face& a, const Face& b) {
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
    static DDT_INLINE T between(const Face& a, const Face& b) {
        return (a.length * b.length) - ((a.x * b.x) + (a.y * b.y));
    }
};
