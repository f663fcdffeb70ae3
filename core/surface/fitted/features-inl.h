// SPDX-License-Identifier: Apache-2.0
// What fitted bends and vertices are made of (see fitted.h). Included inside a namespace, once for
// scalars and once for each SIMD target: T is a float or a vector of floats, a lane a channel. GLSL
// twins: shaders/fitted*.glsl. Pixels come through `tap`, a function of a vertex of the lattice or
// beyond its rim. Sums are written so that an edge seen from its other end has the same bits.
// Needs: <cstddef>, arith.h, weights.h, rsqrt-inl.h; lower(), upper(), if_less(), if_less_equal()
// of T.

/// The pixel at (x, y), where the picture goes on past its rim as its odd mirror image: so does
/// what varies along one axis only, and so do planes. `inside` reads it within.
template <class T, class Inside>
DDT_INLINE T odd_mirror_tap(int x, int y, int width, int height, Inside inside) {
    const auto within = [](int v, int n) { return v < 0 ? 0 : v < n ? v : n - 1; };
    const int cx = within(x, width), cy = within(y, height);
    const int mx = within(2 * cx - x, width), my = within(2 * cy - y, height);
    const auto column = [&](int at) {
        const T centre = inside(at, cy);
        return cy == y ? centre : (centre + centre) - inside(at, my);
    };
    const T centre = column(cx);
    return cx == x ? centre : (centre + centre) - column(mx);
}

/// A pixel, or a vector in pixels.
struct Place {
    int x, y;
    friend DDT_INLINE Place operator+(Place a, Place b) { return {a.x + b.x, a.y + b.y}; }
    friend DDT_INLINE Place operator*(int i, Place v) { return {i * v.x, i * v.y}; }
};
DDT_INLINE Place half_of(Place v) {
    return {v.x / 2, v.y / 2};
}
/// The same as an address.
DDT_INLINE ptrdiff_t half_of(ptrdiff_t v) {
    return v / 2;
}

/// 1 at a distance of 0 from where values are cut off, and less with it.
template <class T>
DDT_INLINE T at_bound(T distance) {
    return upper(T(0.0f), lower(T(1.0f), T(1.0f) - distance));
}

/// How far the taps of VertexFeatures are from their vertex along an axis, in pixels.
constexpr int vertex_taps = 2;

/// Whether all taps of VertexFeatures at (x, y) are pixels: others may be black or white where no
/// pixel is, and who looked at those would take the vertex to stand at a bound.
DDT_INLINE bool all_pixels(int x, int y, int width, int height) {
    return x >= vertex_taps && y >= vertex_taps && x + vertex_taps < width &&
           y + vertex_taps < height;
}

/// The range of the 5x5 pixels about a vertex, and 1 / (25 times that).
template <class T>
struct Surroundings {
    T low, high, reciprocal;
};

template <class T, class Tap>
DDT_INLINE Surroundings<T> surroundings(const FittedTable& table, Tap tap) {
    const T z = tap(0, 0);
    T low = z, high = z;
    for (int y = -vertex_taps; y <= vertex_taps; ++y)
        for (int x = -vertex_taps; x <= vertex_taps; ++x) {
            low = lower(low, tap(x, y));
            high = upper(high, tap(x, y));
        }
    const T r = rsqrt<3>((high - low) * T(25.0f) + T(table.index_epsilon));
    return {low, high, r * r};
}

/// What the weights at a vertex and along its edges depend on.
template <class T, class Tap>
DDT_INLINE T index_of(const Surroundings<T>& s, Tap tap) {
    T sum = T(0.0f);
    for (int y = -vertex_taps; y <= vertex_taps; ++y) {
        T row = T(0.0f);
        for (int x = -vertex_taps; x <= vertex_taps; ++x)
            row = row + lower(tap(x, y) - s.low, s.high - tap(x, y));
        sum = sum + row;
    }
    return sum * s.reciprocal;
}

/// What a vertex is moved by, and what its weights depend on: the index, and how far it stands at
/// black or white, 0 to 1.
template <class T>
struct VertexFeatures {
    T f[fitted_vertex_features];
    T index, bound;

    /// `step`: what a round of consistency would move it by (consistency-inl.h). cut: whether
    /// values will be cut off to 0 .. 1, and all taps are pixels (all_pixels()).
    template <class Tap>
    DDT_INLINE void find(T step, bool cut, const FittedTable& table, Tap tap) {
        const T z = tap(0, 0), quarter = T(0.25f);
        T sum[5];
        sum[0] = (tap(-1, 0) + tap(1, 0)) + (tap(0, -1) + tap(0, 1));
        sum[1] = (tap(-1, -1) + tap(1, 1)) + (tap(1, -1) + tap(-1, 1));
        sum[2] = (tap(-2, 0) + tap(2, 0)) + (tap(0, -2) + tap(0, 2));
        sum[3] = ((tap(-2, -1) + tap(2, 1)) + (tap(2, -1) + tap(-2, 1))) +
                 ((tap(-1, -2) + tap(1, 2)) + (tap(1, -2) + tap(-1, 2)));
        sum[4] = (tap(-2, -2) + tap(2, 2)) + (tap(2, -2) + tap(-2, 2));
        f[0] = sum[0] * quarter - z;
        f[1] = sum[1] * quarter - z;
        f[2] = sum[2] * quarter - z;
        f[3] = sum[3] * T(0.125f) - z;
        f[4] = sum[4] * quarter - z;
        f[5] = step;
        const Surroundings<T> s = surroundings<T>(table, tap);
        index = index_of(s, tap);
        // Of the darkest and the brightest pixel about that one counts which z is nearer to.
        const T dark = at_bound(s.low * T(table.black_scale));
        const T bright = at_bound((T(1.0f) - s.high) * T(table.white_scale));
        const T both = (s.high - z) * dark + (z - s.low) * bright;
        bound = cut ? both * (T(25.0f) * s.reciprocal) : T(0.0f);
    }
};

/// What an edge is bent by. a, b: its ends; c, d: its apexes; v = b - a.
template <class T>
struct EdgeFeatures {
    T null[fitted_edge_null], shared[fitted_edge_shared];
    T range; ///< of a, b, c and d

    /// v in pixels; l, r: the apexes relative to the midpoint in doubled coordinates. P: Place or
    /// ptrdiff_t. e: the plain bend.
    template <class P, class Tap>
    DDT_INLINE void find(P a, P v, P l, P r, T e, Tap tap) {
        find_any(a, v, l, r, e, tap);
    }
    /// The same of addresses of several kinds.
    template <class A, class V, class L, class R, class Tap>
    DDT_INLINE void find_any(A a, V v, L l, R r, T e, Tap tap) {
        const auto first = a + half_of(v + l);
        const auto second = a + half_of(v + r);
        const auto on = [&](int i) DDT_INLINED { return tap(a + i * v); };
        const auto c = [&](int i) DDT_INLINED { return tap(first + i * v); };
        const auto d = [&](int i) DDT_INLINED { return tap(second + i * v); };
        const auto ac = [&](int i) DDT_INLINED { return tap(a + l + i * v); };
        const auto ad = [&](int i) DDT_INLINED { return tap(a + r + i * v); };
        const auto cc = [&](int i) DDT_INLINED { return tap(first + l + i * v); };
        const auto dd = [&](int i) DDT_INLINED { return tap(second + r + i * v); };
        const T half = T(0.5f), quarter = T(0.25f), zero = T(0.0f);
        const T za = on(0), zb = on(1), zc = c(0), zd = d(0);
        const T middle = (za + zb) * half;
        // Means over taps that mirror one another, less the midpoint's: along the edge at 3/2 and
        // 5/2 of its length, beside it through its apexes, and twice and three times as far.
        const T o0 = (on(-1) + on(2)) * half - middle;
        const T o1 = (on(-2) + on(3)) * half - middle;
        const T o2 = (zc + zd) * half - middle;
        const T o3 = ((c(-1) + c(1)) + (d(-1) + d(1))) * quarter - middle;
        const T o4 = ((c(-2) + c(2)) + (d(-2) + d(2))) * quarter - middle;
        const T o5 = ((ac(0) + ac(1)) + (ad(0) + ad(1))) * quarter - middle;
        const T o6 = ((ac(-1) + ac(2)) + (ad(-1) + ad(2))) * quarter - middle;
        const T o7 = (cc(0) + dd(0)) * half - middle;
        const T o8 = ((cc(-1) + cc(1)) + (dd(-1) + dd(1))) * quarter - middle;
        null[0] = (o3 - o2) - half * o0;
        null[1] = (o4 - o2) - half * (o0 + o1);
        null[2] = (o5 - o6) - half * (o0 - o1);
        null[3] = (o7 - o8) - (o0 - half * o1);
        const T difference = zb - za;
        const T rise = if_less(difference, zero, zero - difference, difference);
        const T four = T(4.0f) * o0;
        shared[0] = o0;
        shared[1] = o1;
        shared[2] = e;
        shared[3] = upper(zero - rise, lower(rise, four));
        range = upper(upper(za, zb), upper(zc, zd)) - lower(lower(za, zb), lower(zc, zd));
    }
};

/// v, or where it is not finite, `otherwise`.
template <class T>
DDT_INLINE T finite_or(T v, T otherwise) {
    const T size = if_less(v, T(0.0f), T(0.0f) - v, v);
    return if_less_equal(size, T(largest_float), v, otherwise);
}

/// v within a range; NaN stays.
template <class T>
DDT_INLINE T clamped(T v, T low, T high) {
    return lower(upper(v, low), high);
}

/// Where an index lies between the nodes: what the weights of node k > 0 count.
template <class T>
DDT_INLINE T share_of(T index, const FittedTable& table, int k) {
    const T t = (index - T(table.node[k - 1])) * T(table.node_scale);
    return upper(T(0.0f), lower(T(1.0f), t));
}

/// What those of each node do.
template <class T>
DDT_INLINE void find_shares(T index, const FittedTable& table, T share[fitted_nodes]) {
    share[0] = T(1.0f);
    for (int k = 1; k < fitted_nodes; ++k)
        share[k] = share_of(index, table, k);
}

/// What these weights make of a vertex' features.
template <class T>
DDT_INLINE T weighted(const float* w, const VertexFeatures<T>& v) {
    return ((T(w[0]) * v.f[0] + T(w[1]) * v.f[1]) + (T(w[2]) * v.f[2] + T(w[3]) * v.f[3])) +
           (T(w[4]) * v.f[4] + T(w[5]) * v.f[5]);
}

/// The share of its range that a vertex may leave it by, where others may by `limit`.
template <class T>
DDT_INLINE T fitted_limit(T limit, T bound, const FittedTable& table) {
    return limit + limit * (bound * T(table.bound_limit));
}

/// Where a vertex goes from z. strength: Correction's.
template <class T>
DDT_INLINE T fitted_vertex(T z, T strength, T low, T high, const VertexFeatures<T>& v,
                           const FittedTable& table) {
    const T zero = T(0.0f);
    T share[fitted_nodes];
    find_shares(v.index, table, share);
    T step = zero;
    for (int k = 0; k < fitted_nodes; ++k) {
        const T sum = weighted(table.vertex[k], v) + v.bound * weighted(table.bound[k], v);
        step = k == 0 ? sum : step + share[k] * sum;
    }
    return finite_or(clamped(z + strength * finite_or(step, zero), low, high), z);
}

/// The bend of an edge; null(k, i): what node k's weight of its null feature i is.
template <class T, class Null>
DDT_INLINE T fitted_bend(const EdgeFeatures<T>& edge, T index, Null&& null,
                         const FittedTable& table) {
    T share[fitted_nodes];
    find_shares(index, table, share);
    T e = T(0.0f);
    for (int k = 0; k < fitted_nodes; ++k) {
        const float* const s = table.shared[k];
        const T sum = ((null(k, 0) * edge.null[0] + null(k, 1) * edge.null[1]) +
                       (null(k, 2) * edge.null[2] + null(k, 3) * edge.null[3])) +
                      ((T(s[0]) * edge.shared[0] + T(s[1]) * edge.shared[1]) +
                       (T(s[2]) * edge.shared[2] + T(s[3]) * edge.shared[3]));
        e = k == 0 ? sum : e + share[k] * sum;
    }
    const T plain = edge.shared[2];
    const T limit = T(table.bend_limit) * edge.range;
    return finite_or(clamped(finite_or(e, plain), T(0.0f) - limit, limit), plain);
}
