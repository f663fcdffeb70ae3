// SPDX-License-Identifier: Apache-2.0
// What fitted vertices and bends share. C++ twins: core/surface/fitted/features-inl.h, and
// weights.h, which says what the numbers mean. After net.glsl.

layout(std140, binding = BIND_FITTED) uniform Fitted {
    vec4 fitted_node;
    float node_scale, index_epsilon, gain_scale, bend_limit;
    float black_scale, white_scale, bound_limit, unused;
    vec4 vertex_weights[8]; // two a node
    vec4 bound_weights[8];
    vec4 shared_weights[4];
    vec4 null_weights[36]; // at 12 * length + 4 * kind + node
};

// The pixel at p; past the rim the picture goes on as its odd mirror image.
vec4 odd_mirror_tap(ivec2 p, ivec2 size) {
    ivec2 c = clamp(p, ivec2(0), size - 1), m = clamp(2 * c - p, ivec2(0), size - 1);
    precise vec4 z = value_at(c);
    if (c.y != p.y) {
        precise vec4 twice = z + z;
        z = twice - value_at(ivec2(c.x, m.y));
    }
    if (c.x != p.x) {
        precise vec4 other = value_at(ivec2(m.x, c.y));
        if (c.y != p.y) {
            precise vec4 twice = other + other;
            other = twice - value_at(m);
        }
        precise vec4 twice = z + z;
        z = twice - other;
    }
    return z;
}

// v, or where it is not finite, `otherwise`.
vec4 finite_or(vec4 v, vec4 otherwise) {
    precise vec4 negated = vec4(0.0) - v;
    vec4 size = if_less(v, vec4(0.0), negated, v);
    return if_less_equal(size, vec4(largest_float), v, otherwise);
}

// v within a range; NaN stays.
vec4 clamped(vec4 v, vec4 low, vec4 high) {
    return lower(upper(v, low), high);
}

// Where an index lies between the nodes: what the weights of node k > 0 count.
vec4 share_of(vec4 index, int k) {
    precise vec4 t = (index - fitted_node[k - 1]) * node_scale;
    return upper(vec4(0.0), lower(vec4(1.0), t));
}
