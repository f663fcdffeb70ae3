// SPDX-License-Identifier: Apache-2.0
// Included inside a namespace, once for each SIMD target: T is a vector of floats, a lane a
// channel. GLSL twin: shaders/surface.glsl.
// Needs: <cmath>, arith.h, lanes-inl.h.

/// A triangle of the control net, loaded.
template <class T>
struct Patch {
    T z0, z1, z2;    ///< values at the vertices
    T e01, e12, e20; ///< bends of the edges
    T q01, q12, q20; ///< their softness
    T low, high;     ///< range that the surface is clamped to

    /// Those of a triangle, its vertices and its edges 01, 12, 20 told by their sites; vertex_at,
    /// at, soft_at: what the net has at a site.
    template <bool quadratic, bool soft, class VertexAt, class At, class SoftAt>
    DDT_INLINE void load(const int vertex[3], const int edge[3], VertexAt vertex_at, At at,
                         SoftAt soft_at) {
        z0 = vertex_at(vertex[0]), z1 = vertex_at(vertex[1]), z2 = vertex_at(vertex[2]);
        if (quadratic)
            e01 = at(edge[0]), e12 = at(edge[1]), e20 = at(edge[2]);
        if (soft)
            q01 = soft_at(edge[0]), q12 = soft_at(edge[1]), q20 = soft_at(edge[2]);
    }

    /// The range of the three values, or what of it bounds the surface. all_finite: see
    /// is_surely_finite().
    template <bool all_finite>
    DDT_INLINE void find_range(Bounds bounds) {
        low = smaller<all_finite>(z2, smaller<all_finite>(z1, z0));
        high = larger<all_finite>(z2, larger<all_finite>(z1, z0));
        if (bounds == Bounds::vertices)
            return;
        const T none = T(-INFINITY);
        low =
            bounds == Bounds::dark ? if_less_equal(T(0.0f), low, T(dark_share) * low, none) : none;
        high = T(INFINITY);
    }

    /// Vertices up to this size make a surface whose every number is finite.
    static constexpr float finite_size = 0x1p100f;

    /// Whether every number of the surface is surely finite, which leaves nothing to look out for
    /// but the sign of zero: the same bits in fewer steps.
    DDT_INLINE bool is_surely_finite() const {
        return T::all_within(finite_size, (abs(z0) + abs(z1)) + abs(z2));
    }

    // Unlike lower() and upper(), b stays unless a is strictly beyond it: so f, and NaN as f, stays
    // where bounds are put to it. all_finite: any, since zeros alone may differ, and at() clears
    // their sign.
    template <bool all_finite>
    static DDT_INLINE T smaller(T a, T b) {
        return all_finite ? lane_min(a, b) : if_less(a, b, a, b);
    }
    template <bool all_finite>
    static DDT_INLINE T larger(T a, T b) {
        return all_finite ? lane_max(a, b) : if_less(b, a, a, b);
    }

    /// b z, but 0 where b = 0, whatever z is.
    template <bool all_finite>
    static DDT_INLINE T term(T b, T z) {
        const T zero = T(0.0f);
        return all_finite ? b * z : if_less(zero, b, b * z, zero);
    }

    /// The surface at barycentric weights b, all >= 0. Zero is never negative and NaN one and the
    /// same: their signs would be up to each compiler.
    template <bool quadratic, bool soft, bool all_finite>
    DDT_INLINE T at(T b0, T b1, T b2) const {
        T f = (term<all_finite>(b0, z0) + term<all_finite>(b1, z1)) + term<all_finite>(b2, z2);
        if (quadratic)
            f = f + (((b0 * b1) * e01 + (b1 * b2) * e12) + (b2 * b0) * e20);
        if (soft)
            f = f + ((smaller<all_finite>(b0, b1) * q01 + smaller<all_finite>(b1, b2) * q12) +
                     smaller<all_finite>(b2, b0) * q20);
        f = smaller<all_finite>(high, larger<all_finite>(low, f));
        return all_finite ? f + T(0.0f) : if_less_equal(f, T(INFINITY), f + T(0.0f), T(quiet_nan));
    }
};

/// Where a position lies in a cell that its own diagonal divides (PlainCell): in the first triangle
/// if d is negative, else in the second, with these weights.
template <class T>
struct DividedWeights {
    T d, b0, b1, b2;

    static DDT_INLINE DividedWeights down(T x, T y) {
        const T zero = T(0.0f), one = T(1.0f), d = x - y;
        return {d, if_less(d, zero, one - y, one - x), if_less(d, zero, x, d),
                if_less(d, zero, y - x, y)};
    }
    static DDT_INLINE DividedWeights up(T x, T y) {
        const T zero = T(0.0f), one = T(1.0f), d = (x + y) - one;
        return {d, if_less(d, zero, one - (x + y), one - y), if_less(d, zero, x, d),
                if_less(d, zero, y, one - x)};
    }
};

/// A cell that its own diagonal divides into two triangles, in Triangle's order:
///
///     down: 0 > 1    first  0 3 2    up:  0 > 1    first  0 1 2
///           | \ |    second 0 1 3         | / |    second 1 3 2
///           2 > 3                         2 > 3
///
/// x, y: position relative to corner 0. By the tie rule the diagonal belongs to the second.
template <class T>
struct PlainCell {
    T z0, z1, z2, z3;
    T e01, e02, e13, e23, diagonal;      // bends
    T q01, q02, q13, q23, soft_diagonal; // softness
    Patch<T> first, second;

    /// What a net has of a cell `at` floats after the first one's (CellNumbers); load: a T from
    /// where its numbers are.
    template <bool quadratic, bool soft, class Numbers, class From>
    DDT_INLINE void load(const Numbers& values, const Numbers& softness, ptrdiff_t at, From from) {
        z0 = from(values.corner(at, 0, 0));
        z1 = from(values.corner(at, 1, 0));
        z2 = from(values.corner(at, 0, 1));
        z3 = from(values.corner(at, 1, 1));
        if (quadratic) {
            e01 = from(values.top(at));
            e02 = from(values.left(at));
            diagonal = from(values.centre(at));
            e13 = from(values.right(at));
            e23 = from(values.bottom(at));
        }
        if (soft) {
            q01 = from(softness.top(at));
            q02 = from(softness.left(at));
            soft_diagonal = from(softness.centre(at));
            q13 = from(softness.right(at));
            q23 = from(softness.bottom(at));
        }
    }

    template <bool soft>
    DDT_INLINE void divide_down(Patch<T>& one, Patch<T>& two) const {
        one.z0 = z0, one.z1 = z3, one.z2 = z2;
        one.e01 = diagonal, one.e12 = e23, one.e20 = e02;
        two.z0 = z0, two.z1 = z1, two.z2 = z3;
        two.e01 = e01, two.e12 = e13, two.e20 = diagonal;
        if (soft) {
            one.q01 = soft_diagonal, one.q12 = q23, one.q20 = q02;
            two.q01 = q01, two.q12 = q13, two.q20 = soft_diagonal;
        }
    }
    template <bool soft>
    DDT_INLINE void divide_up(Patch<T>& one, Patch<T>& two) const {
        one.z0 = z0, one.z1 = z1, one.z2 = z2;
        one.e01 = e01, one.e12 = diagonal, one.e20 = e02;
        two.z0 = z1, two.z1 = z3, two.z2 = z2;
        two.e01 = e13, two.e12 = e23, two.e20 = diagonal;
        if (soft) {
            one.q01 = q01, one.q12 = soft_diagonal, one.q20 = q02;
            two.q01 = q13, two.q12 = q23, two.q20 = soft_diagonal;
        }
    }

    /// The triangles' ranges, once they are divided.
    template <bool all_finite>
    DDT_INLINE void find_ranges(Bounds bounds) {
        first.template find_range<all_finite>(bounds);
        second.template find_range<all_finite>(bounds);
    }

    /// Both triangles' parameters, lane by lane that of the one that d, negative in the first,
    /// tells.
    template <bool quadratic, bool soft>
    DDT_INLINE Patch<T> choose(T d) const {
        const T zero = T(0.0f);
        Patch<T> p;
        p.z0 = if_less(d, zero, first.z0, second.z0);
        p.z1 = if_less(d, zero, first.z1, second.z1);
        p.z2 = if_less(d, zero, first.z2, second.z2);
        if (quadratic) {
            p.e01 = if_less(d, zero, first.e01, second.e01);
            p.e12 = if_less(d, zero, first.e12, second.e12);
            p.e20 = if_less(d, zero, first.e20, second.e20);
        }
        if (soft) {
            p.q01 = if_less(d, zero, first.q01, second.q01);
            p.q12 = if_less(d, zero, first.q12, second.q12);
            p.q20 = if_less(d, zero, first.q20, second.q20);
        }
        p.low = if_less(d, zero, first.low, second.low);
        p.high = if_less(d, zero, first.high, second.high);
        return p;
    }

    /// As Patch::is_surely_finite(), of both triangles.
    DDT_INLINE bool is_surely_finite() const {
        return T::all_within(Patch<T>::finite_size, (abs(z0) + abs(z1)) + (abs(z2) + abs(z3)));
    }

    template <bool quadratic, bool soft, bool all_finite>
    DDT_INLINE T at_down(T x, T y) const {
        const auto b = DividedWeights<T>::down(x, y);
        return choose<quadratic, soft>(b.d).template at<quadratic, soft, all_finite>(b.b0, b.b1,
                                                                                     b.b2);
    }
    template <bool quadratic, bool soft, bool all_finite>
    DDT_INLINE T at_up(T x, T y) const {
        const auto b = DividedWeights<T>::up(x, y);
        return choose<quadratic, soft>(b.d).template at<quadratic, soft, all_finite>(b.b0, b.b1,
                                                                                     b.b2);
    }
};

/// Running mean over surfaces: `mean` of all before, with `last` included with the weight share =
/// 1 / (number of surfaces). It lies between the two, so what is the same in all of them stays as
/// it is.
template <class T>
DDT_INLINE T running_mean(T mean, T last, T share) {
    T f = mean * (T(1.0f) - share) + last * share;
    const T low = if_less(last, mean, last, mean), high = if_less(last, mean, mean, last);
    f = if_less(f, low, low, f);
    f = if_less(high, f, high, f);
    return if_less_equal(f, T(INFINITY), f + T(0.0f), T(quiet_nan));
}
