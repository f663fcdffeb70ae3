// Included inside a namespace, once for each SIMD target: T is a float or a vector of floats, a
// lane a channel. GLSL twin: shaders/surface.glsl. Comparisons are written out, a min or max would
// leave the sign of zero and NaN to the device.

/// Mean gradient at a vertex over the triangles round it (see net.h). Taken relative to the first
/// triangle's gradient, so that a plane comes back exactly.
template <class T>
struct GradientMean {
    T base_x, base_y, sum_x, sum_y, weight;
    bool begun;

    // Written out: an implicit constructor would not be compiled for the SIMD target.
    DDT_INLINE GradientMean()
        : base_x(0.0f), base_y(0.0f), sum_x(0.0f), sum_y(0.0f), weight(0.0f), begun(false) {}

    /// Add the triangle vertex, vertex + j, vertex + k, det(j, k) = 1, with value differences.
    DDT_INLINE void add(T jx, T jy, T kx, T ky, T dzj, T dzk) {
        const T zero = T(0.0f);
        T gx = dzj * ky - dzk * jy;
        T gy = dzk * jx - dzj * kx;
        const T square = gx * gx + gy * gy;
        const T largest = T(FLT_MAX);
        // Not finite: no weight.
        const T w = if_less_equal(square, largest, rsqrt<1>(square + T(gradient_epsilon)), zero);
        gx = if_less_equal(square, largest, gx, zero);
        gy = if_less_equal(square, largest, gy, zero);
        if (!begun) {
            base_x = gx;
            base_y = gy;
            begun = true;
        }
        sum_x = sum_x + w * (gx - base_x);
        sum_y = sum_y + w * (gy - base_y);
        weight = weight + w;
    }

    DDT_INLINE void result(T& gx, T& gy) const {
        const T r = rsqrt<3>(if_less(T(0.0f), weight, weight, T(1.0f)));
        const T reciprocal = r * r;
        gx = base_x + sum_x * reciprocal;
        gy = base_y + sum_y * reciprocal;
    }
};

/// e of the edge from i to j = i + (vx, vy) (see net.h).
template <class T>
DDT_INLINE T edge_bend(T gix, T giy, T gjx, T gjy, T zi, T zj, T vx, T vy) {
    const T zero = T(0.0f);
    const T difference = zj - zi;
    const T limit = if_less(difference, zero, zero - difference, difference);
    T e = T(bend_strength) * ((gix - gjx) * vx + (giy - gjy) * vy);
    e = if_less(e, zero - limit, zero - limit, e);
    e = if_less(limit, e, limit, e);
    return if_less_equal(limit, T(FLT_MAX), e, zero);
}

/// q of an edge from i to j with apexes c and d, weight w (see net.h).
template <class T>
DDT_INLINE T edge_softness(T w, T zi, T zj, T zc, T zd) {
    const T zero = T(0.0f);
    const T q = w * ((zc + zd) - (zi + zj));
    const T size = if_less(q, zero, zero - q, q);
    return if_less_equal(size, T(FLT_MAX), q, zero);
}
