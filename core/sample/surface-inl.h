// Included inside a namespace, once for each SIMD target: T is a vector of floats, a lane a
// channel. GLSL twin: shaders/surface.glsl.

/// A triangle of the control net, loaded.
template <class T>
struct Patch {
    T z0, z1, z2;    ///< values at the vertices
    T e01, e12, e20; ///< bends of the edges
    T low, high;     ///< range of the three values

    DDT_INLINE void find_range() {
        low = if_less(z1, z0, z1, z0);
        low = if_less(z2, low, z2, low);
        high = if_less(z0, z1, z1, z0);
        high = if_less(high, z2, z2, high);
    }

    /// b z, but 0 where b = 0, whatever z is.
    static DDT_INLINE T term(float b, T z) { return b == 0.0f ? T(0.0f) : T(b) * z; }

    template <bool quadratic>
    DDT_INLINE T at(float b0, float b1, float b2) const {
        T f = (term(b0, z0) + term(b1, z1)) + term(b2, z2);
        if (quadratic)
            f = f + ((T(b0 * b1) * e01 + T(b1 * b2) * e12) + T(b2 * b0) * e20);
        f = if_less(f, low, low, f);
        f = if_less(high, f, high, f);
        return if_less_equal(f, T(INFINITY), f, T(quiet_nan));
    }
};
