// SPDX-License-Identifier: Apache-2.0
// Included inside a namespace, once for scalars (fitted/scalar.h) and once for each SIMD target: T
// is a float or a vector of floats, a lane a channel. GLSL twin: shaders/consistency.glsl.
// Needs: mapping.h (Rect), arith.h; lower(), upper(), if_less(), if_less_equal() of T.
//
// A source pixel is four quadrants, each a quarter of one of the cells round its vertex V. The mean
// of the surface over a quadrant is taken at 4 positions, (1/8 or 3/8, 1/8 or 3/8) from V, relative
// to V's value. In a cell divided by its own diagonal that is a fixed sum over the cell's corners
// V, X (beside V), Y (above or below V), D (opposite) and its edges, with dyadic weights, so that
// where the values are a plane the sum over the four quadrants is exactly 0.

template <class T>
struct QuadrantCell {
    T v, x, y, d;                     ///< values at the corners
    T vx, vy, xd, yd, diagonal;       ///< bends of the edges
    T qvx, qvy, qxd, qyd, q_diagonal; ///< their softness

    /// The mean where the diagonal goes from V to D.
    template <bool quadratic, bool soft>
    DDT_INLINE T through() const {
        T mean = ((x - v) + (y - v)) * T(through_beside) + (d - v) * T(through_opposite);
        if (quadratic)
            mean =
                mean + ((diagonal * T(through_bend_diagonal) + (vx + vy) * T(through_bend_near)) +
                        (xd + yd) * T(through_bend_far));
        if (soft)
            mean = mean +
                   ((q_diagonal * T(through_soft_diagonal) + (qvx + qvy) * T(through_soft_near)) +
                    (qxd + qyd) * T(through_soft_far));
        return mean;
    }

    /// The mean where it goes from X to Y.
    template <bool quadratic, bool soft>
    DDT_INLINE T across() const {
        T mean = ((x - v) + (y - v)) * T(across_beside);
        if (quadratic)
            mean = mean + ((vx + vy) * T(across_bend_near) + diagonal * T(across_bend_diagonal));
        if (soft)
            mean =
                mean + ((qvx + qvy) * T(across_soft_near) + q_diagonal * T(across_soft_diagonal));
        return mean;
    }
};

/// A vertex moved from z so that the surface's mean over its pixel, z + sum / 4 where `sum` adds
/// its quadrants' means, comes closer to `source`; within [low, high]. Where that is not finite: z.
/// share: what of `sum` counts, a quarter of Correction::strength.
template <class T>
DDT_INLINE T corrected(T z, T source, T sum, T share, T low, T high) {
    const T zero = T(0.0f);
    const T step = (source - z) - sum * share;
    const T size = upper(step, zero - step);
    return if_less_equal(size, T(largest_float), lower(upper(z + step, low), high), z);
}

/// The range a vertex may be moved in, from the range of its 3x3 source pixels and the share of
/// that by which it may be left. Where none of them is negative the share is, downwards, of the
/// smallest too, if that is less: beside a light a thousand times as bright it would be black. And
/// where one of them is a light, twice as bright as white (1) and more, the vertex keeps half its
/// own pixel, `z`, or all of a negative one: one of its channels alone would fall to a dark
/// neighbour's, and a rim of another colour be there. Where what is negative will be cut off
/// (`clipped`) the share is all beside black, so that outlines get steep, and else half of the
/// smallest pixel stays: greys beside white would have specks of black. Where floats end, the range
/// stays what it was.
template <class T>
DDT_INLINE void widen(T limit, bool clipped, T z, T& low, T& high) {
    const T zero = T(0.0f);
    const T margin = limit * (high - low);
    const T wide = low - margin;
    const T light = clipped ? zero : upper(zero, lower(T(1.0f), high - T(1.0f)));
    const T half = z * T(0.5f);
    const T dim = upper(low - limit * low, half * light);
    // Exact where `light` is 0 or 1: `wide` is beyond a light by as much as that is bright.
    const T negative = light * upper(wide, lower(z, half)) + (T(1.0f) - light) * wide;
    const T grey = low * T(0.5f) - upper(zero, T(nearly_black) - low) * T(black_fall);
    const T bound = clipped ? grey : if_less(dim, zero, zero, dim);
    const T raised = high + margin;
    const T sunk = if_less(low, zero, negative, if_less(wide, bound, bound, wide));
    high = if_less_equal(raised, T(largest_float), raised, high);
    low = if_less_equal(zero - T(largest_float), sunk, sunk, low);
}

/// What a vertex may become: the range of the pixels `near` it, counted from it, widened. tap: a
/// function of a pixel's place.
template <class T, class Tap>
DDT_INLINE void find_limits(const Rect& near, T limit, bool clipped, Tap tap, T& low, T& high) {
    low = high = tap(0, 0);
    for (int y = near.y0; y < near.y1; ++y)
        for (int x = near.x0; x < near.x1; ++x) {
            const T n = tap(x, y);
            low = lower(low, n);
            high = upper(high, n);
        }
    widen(limit, clipped, tap(0, 0), low, high);
}
