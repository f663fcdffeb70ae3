// SPDX-License-Identifier: Apache-2.0
// Included inside a namespace, once for each SIMD target: T is a vector of floats, a lane a
// channel. GLSL twin: shaders/surface.glsl. Only lower(), upper(), if_less() and if_less_equal()
// choose: a library's min or max would leave the sign of zero and NaN to the device.
// Needs: arith.h, lanes-inl.h, rsqrt-inl.h.

// tame: all values are tame (core/surface/tame.h), so the tests for inf and NaN are left out: the
// same bits in fewer steps.

/// Mean gradient at a vertex over the triangles round it (see control_net.h). Taken relative to the
/// first triangle's gradient, so that a plane comes back exactly.
template <class T, bool tame>
struct GradientMean {
    T base_x, base_y, sum_x, sum_y, weight;
    bool begun;

    // Written out: an implicit constructor would not be compiled for the SIMD target.
    DDT_INLINE GradientMean()
        : base_x(0.0f), base_y(0.0f), sum_x(0.0f), sum_y(0.0f), weight(0.0f), begun(false) {}

    /// The weight of a triangle with this gradient; one that is not finite becomes 0 and has none.
    static DDT_INLINE T weigh(T& gx, T& gy) {
        const T zero = T(0.0f);
        const T square = gx * gx + gy * gy;
        if (tame)
            return rsqrt<1>(square + T(gradient_epsilon));
        const T w =
            if_less_equal(square, T(largest_float), rsqrt<1>(square + T(gradient_epsilon)), zero);
        gx = if_less_equal(square, T(largest_float), gx, zero);
        gy = if_less_equal(square, T(largest_float), gy, zero);
        return w;
    }

    /// Add a gradient that was weighed.
    DDT_INLINE void add(T w, T gx, T gy) {
        sum_x = sum_x + w * (gx - base_x);
        sum_y = sum_y + w * (gy - base_y);
        weight = weight + w;
    }

    /// Add the triangle vertex, vertex + j, vertex + k, det(j, k) = 1, with value differences.
    DDT_INLINE void add(T jx, T jy, T kx, T ky, T dzj, T dzk) {
        T gx = dzj * ky - dzk * jy;
        T gy = dzk * jx - dzj * kx;
        const T w = weigh(gx, gy);
        if (begun)
            return add(w, gx, gy);
        begin(w, gx, gy, gx, gy);
        begun = true;
    }

    /// Begin with a gradient that was weighed, and either is the base or has no weight. What is
    /// tame adds nothing but 0 to the sums then.
    DDT_INLINE void begin(T w, T gx, T gy, T base_gx, T base_gy) {
        base_x = base_gx;
        base_y = base_gy;
        if (tame)
            weight = w;
        else
            add(w, gx, gy);
    }

    /// Be what it was before the last was added, where not a < b.
    DDT_INLINE void keep_less(T a, T b, const GradientMean& before) {
        sum_x = if_less(a, b, sum_x, before.sum_x);
        sum_y = if_less(a, b, sum_y, before.sum_y);
        weight = if_less(a, b, weight, before.weight);
    }

    DDT_INLINE void result(T& gx, T& gy) const {
        const T r = rsqrt<3>(if_less(T(0.0f), weight, weight, T(1.0f)));
        const T reciprocal = r * r;
        gx = base_x + sum_x * reciprocal;
        gy = base_y + sum_y * reciprocal;
    }
};

/// Value differences to a vertex' eight neighbours, y downwards.
template <class T>
struct Differences {
    T nw, n, ne, e, se, s, sw, w;
};

/// The mean gradient at a regular vertex, whose four cells are plain; those diagonals run to it
/// whose flag is more than 0. The triangles come in the same order as to a walk round the vertex,
/// and add the same; a place where there is none has no weight.
template <bool tame, class T>
DDT_INLINE GradientMean<T, tame> regular_mean(const Differences<T>& d, T nw, T ne, T se, T sw) {
    using Mean = GradientMean<T, tame>;
    const T zero = T(0.0f);
    const T minus_n = zero - d.n, minus_w = zero - d.w;
    Mean mean;
    T gx = d.n - d.nw, gy = minus_n;
    T first = either(nw, Mean::weigh(gx, gy), zero);
    T gx1 = either(ne, d.ne - d.n, d.e), gy1 = minus_n;
    const T second = Mean::weigh(gx1, gy1);
    mean.begin(first, gx, gy, either(nw, gx, gx1), either(nw, gy, gy1));
    mean.add(second, gx1, gy1);
    const auto add = [&](T x, T y) {
        const T w = Mean::weigh(x, y);
        mean.add(w, x, y);
    };
    const auto add_if = [&](T flag, T x, T y) {
        const T w = Mean::weigh(x, y);
        mean.add(either(flag, w, zero), x, y);
    };
    add_if(ne, d.e, d.e - d.ne);
    add(d.e, either(se, d.se - d.e, d.s));
    add_if(se, d.se - d.s, d.s);
    add(either(sw, d.s - d.sw, minus_w), d.s);
    add_if(sw, minus_w, d.sw - d.w);
    add(minus_w, either(nw, d.w - d.nw, minus_n));
    return mean;
}

/// e of the edge from i to j = i + (vx, vy) (see control_net.h).
template <bool tame, class T>
DDT_INLINE T edge_bend(T gix, T giy, T gjx, T gjy, T zi, T zj, T vx, T vy) {
    const T zero = T(0.0f);
    const T difference = zj - zi;
    const T limit = upper(difference, zero - difference);
    T e = T(bend_strength) * ((gix - gjx) * vx + (giy - gjy) * vy);
    e = lower(upper(e, zero - limit), limit);
    return tame ? e : if_less_equal(limit, T(largest_float), e, zero);
}

/// The weight w of the flipped state of a flippable edge with this gain (see control_net.h).
template <class T>
DDT_INLINE T soft_weight(T gain, T reciprocal_tau) {
    const T zero = T(0.0f);
    return upper(zero, T(soft_share) * (T(1.0f) + lower(zero, gain) * reciprocal_tau));
}

/// q of an edge from i to j with apexes c and d, weight w and bend e (see control_net.h).
template <bool tame, class T>
DDT_INLINE T edge_softness(T w, T zi, T zj, T zc, T zd, T e, Bounds bounds) {
    const T zero = T(0.0f), ends = zi + zj;
    const T blend = w * ((zc + zd) - ends);
    T q = blend;
    if (bounds != Bounds::none) {
        const T low = lower(lower(zi, zj), upper(zc, zd));
        const T half_bend = T(0.5f) * e;
        if (bounds == Bounds::vertices) {
            const T high = upper(upper(zi, zj), lower(zc, zd));
            const T least = lower(zero, ((low + low) - ends) - half_bend);
            const T most = upper(zero, ((high + high) - ends) - half_bend);
            q = lower(upper(blend, least), most);
        } else {
            const T least = lower(zero, (T(2 * dark_share) * low - ends) - half_bend);
            q = if_less_equal(zero, low, upper(blend, least), blend);
        }
    }
    if (tame)
        return q;
    const T size = if_less(blend, zero, zero - blend, blend);
    return if_less_equal(size, T(largest_float), q, zero);
}
