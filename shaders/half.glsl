// SPDX-License-Identifier: Apache-2.0
// Half floats (IEEE 754 binary16) by integer arithmetic: the same bits everywhere, rounded to
// nearest even. C++ twin: tests/bench/gpu/half.h.

// The bits of the float with the value of the half; exact.
uint widened(uint h) {
    uint sign = (h & 0x8000u) << 16, a = h & 0x7fffu;
    if (a >= 0x7c00u)
        return sign | 0x7f800000u | (a & 0x3ffu) << 13;
    if (a >= 0x400u)
        return sign | ((a << 13) + (112u << 23));
    precise float small = float(a) * (1.0 / 16777216.0);
    return sign | floatBitsToUint(small);
}

uint narrowed(uint f) {
    uint sign = f >> 16 & 0x8000u, a = f & 0x7fffffffu;
    if (a > 0x7f800000u)
        return sign | 0x7e00u;
    if (a >= 0x477ff000u)
        return sign | 0x7c00u;
    if (a >= 0x38800000u) {
        uint r = a - (112u << 23);
        return sign | (r + 0xfffu + (r >> 13 & 1u)) >> 13;
    }
    if (a < 0x33000000u)
        return sign;
    uint m = (a & 0x7fffffu) | 0x800000u, shift = 126u - (a >> 23);
    uint r = m >> shift, rest = m & ((1u << shift) - 1u), tie = 1u << (shift - 1u);
    return sign | (r + (rest > tie || (rest == tie && (r & 1u) != 0u) ? 1u : 0u));
}
