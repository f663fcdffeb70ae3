// SPDX-License-Identifier: Apache-2.0
// Chance: numbers that depend on the seed, the iteration and an edge's place alone. C++ twins:
// mixed(), exponential() and Annealing in core/triangulate/annealing.h.
//
// Numbers of 64 bits: x the low half, y the high one.
layout(location = AT_SALT) uniform uvec2 salt; // annealing_salt() of the iteration
layout(location = AT_SEED) uniform uvec2 seed; // mixed
layout(location = AT_PART) uniform uint part;
layout(location = AT_TEMPERATURE) uniform float temperature;

uvec2 product(uvec2 a, uvec2 b) {
    uint high, low;
    umulExtended(a.x, b.x, high, low);
    return uvec2(low, high + a.x * b.y + a.y * b.x);
}
// x ^ (x >> n), 0 < n < 32.
uvec2 folded(uvec2 x, int n) {
    return x ^ uvec2(x.x >> n | x.y << (32 - n), x.y >> n);
}
uvec2 mixed(uvec2 x) {
    x = product(folded(x, 30), uvec2(0x1ce4e5b9u, 0xbf58476du));
    x = product(folded(x, 27), uvec2(0x133111ebu, 0x94d049bbu));
    return folded(x, 31);
}

float exponential(uint bits) {
    precise float uniform_ = float(int(bits >> 8) + 1) * draw_unit;
    uint word = floatBitsToUint(uniform_);
    float exponent = float(int(word >> 23) - 127);
    precise float f = float(int(word & 0x7fffffu)) * fraction_unit;
    precise float e = natural_log_2 * ((0.0 - exponent) - (f + ((log_bow * f) * (1.0 - f))));
    return e;
}

// The number drawn for an edge in this iteration, by its place.
uint draw(uvec2 place) {
    return mixed(salt ^ place).x;
}
bool is_of_part(uint drawn) {
    return drawn % uint(annealing_parts) == part;
}
// Of two edges of a part: whether the other one, where it can be flipped, is selected rather than
// m.
bool draws_before(int other, uint other_drawn, int m, uint m_drawn) {
    return other_drawn > m_drawn || (other_drawn == m_drawn && other < m);
}
// Metropolis' u < exp(gain / t), with u = exp(-e).
bool is_taken(float gain, uint drawn) {
    precise float least = 0.0 - temperature * exponential(mixed(seed ^ uvec2(drawn, 0u)).x);
    return gain > least;
}
