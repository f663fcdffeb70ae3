// SPDX-License-Identifier: Apache-2.0
// C++ twin: core/sample/bound_alpha.h. After locate.glsl and source.glsl.

// What a surface over alpha has at p, bounded to 0 .. 1, or to the range of the four pixels of p's
// cell where these leave that.
vec4 bound_alpha(vec4 f, int tile, ivec2 p) {
    ivec2 cell = cell_of(tile, p);
    vec4 low = vec4(0.0), high = vec4(1.0);
    for (int corner = 0; corner < 4; ++corner) {
        vec4 s = source_at(cell + ivec2(corner % 2, corner / 2));
        low = lower(low, s);
        high = upper(high, s);
    }
    return lower(upper(f, low), high);
}
