// SPDX-License-Identifier: Apache-2.0
// 16-bit floats. C++ twin: core/base/half.h.

// The nearest to the float of these bits; of two the even one.
uint half_of_float(uint bits) {
    uint sign = bits >> 16 & 0x8000u, size = bits & 0x7fffffffu;
    if (size > 0x7f800000u) { // NaN, which must not become infinity
        uint payload = size >> 13 & 0x3ffu;
        return sign | 0x7c00u | payload | uint(payload == 0u);
    }
    if (size >= 0x477ff000u) // rounds to more than 65504
        return sign | 0x7c00u;
    if (size >= 0x38800000u) { // 2^-14 and more: normal
        uint odd = size >> 13 & 1u;
        return sign | (size - 0x38000000u + 0xfffu + odd) >> 13;
    }
    if (size < 0x33000000u) // below half of the least
        return sign;
    uint shift = 126u - (size >> 23), mantissa = (size & 0x7fffffu) | 0x800000u;
    uint whole = mantissa >> shift, rest = mantissa & ((1u << shift) - 1u);
    uint middle = 1u << (shift - 1u);
    return sign | (whole + uint(rest > middle || (rest == middle && (whole & 1u) != 0u)));
}
