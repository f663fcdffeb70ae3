// SPDX-License-Identifier: Apache-2.0
// Where a fitted vertex goes. C++ twin: core/surface/fitted/features-inl.h, whose sums are in
// the same order. After consistency.glsl and fitted_index.glsl.

vec4 at_bound(vec4 distance) {
    precise vec4 t = vec4(1.0) - distance;
    return upper(vec4(0.0), lower(vec4(1.0), t));
}

// Whether all taps of VertexFeatures at p are pixels: others may be black or white where no pixel
// is, and who looked at those would take the vertex to stand at a bound.
bool all_pixels(ivec2 p, ivec2 size) {
    return p.x >= vertex_taps && p.y >= vertex_taps && p.x + vertex_taps < size.x &&
           p.y + vertex_taps < size.y;
}

// What a vertex is moved by, and what its weights depend on. `index` is not found here:
// gradients.comp has left it.
struct VertexFeatures {
    vec4 f0, f1, f2, f3, f4, f5;
    vec4 index, bound;
};

// VertexFeatures::find() of the vertex of this invocation. step_: what a round of consistency would
// move it by; cut: whether values will be cut off to 0 .. 1, and all taps are pixels
// (all_pixels()).
VertexFeatures find_features(vec4 step_, bool cut) {
    vec4 z = near(12);
    precise vec4 sum0 = (near(11) + near(13)) + (near(7) + near(17));
    precise vec4 sum1 = (near(6) + near(18)) + (near(8) + near(16));
    precise vec4 sum2 = (near(10) + near(14)) + (near(2) + near(22));
    precise vec4 sum3 = ((near(5) + near(19)) + (near(9) + near(15))) +
                        ((near(1) + near(23)) + (near(3) + near(21)));
    precise vec4 sum4 = (near(0) + near(24)) + (near(4) + near(20));
    precise vec4 f0 = sum0 * 0.25 - z;
    precise vec4 f1 = sum1 * 0.25 - z;
    precise vec4 f2 = sum2 * 0.25 - z;
    precise vec4 f3 = sum3 * 0.125 - z;
    precise vec4 f4 = sum4 * 0.25 - z;

    Surroundings s = surroundings();
    precise vec4 above_black = s.low * black_scale;
    precise vec4 below_white = (vec4(1.0) - s.high) * white_scale;
    vec4 dark = at_bound(above_black), bright = at_bound(below_white);
    precise vec4 both = (s.high - z) * dark + (z - s.low) * bright;
    precise vec4 share = both * (25.0 * s.reciprocal);
    vec4 bound = cut ? share : vec4(0.0);
    return VertexFeatures(f0, f1, f2, f3, f4, step_, vec4(0.0), bound);
}

// What these weights make of a vertex' features.
vec4 weighted(vec4 first, vec4 last, VertexFeatures v) {
    precise vec4 sum = ((first.x * v.f0 + first.y * v.f1) + (first.z * v.f2 + first.w * v.f3)) +
                       (last.x * v.f4 + last.y * v.f5);
    return sum;
}

// The share of its range that a vertex may leave it by, where others may by `limit`.
vec4 fitted_limit(vec4 limit, vec4 bound) {
    precise vec4 widened = limit + limit * (bound * bound_limit);
    return widened;
}

// Where a vertex goes from z. strength: Correction's.
vec4 fitted_vertex(vec4 z, float strength, vec4 low, vec4 high, VertexFeatures v) {
    precise vec4 step_ = vec4(0.0);
    for (int k = 0; k < 4; ++k) {
        precise vec4 sum = weighted(vertex_weights[2 * k], vertex_weights[2 * k + 1], v) +
                           v.bound * weighted(bound_weights[2 * k], bound_weights[2 * k + 1], v);
        if (k == 0)
            step_ = sum;
        else
            step_ = step_ + share_of(v.index, k) * sum;
    }
    precise vec4 moved = z + strength * finite_or(step_, vec4(0.0));
    return finite_or(clamped(moved, low, high), z);
}
