// SPDX-License-Identifier: Apache-2.0
// 16-bit floats. C++ twin: core/base/half.h.

// The nearest to the float of these bits; of two the even one.
uint half_of_float(uint bits) {
    uint sign = bits >> 16 & 0x8000u, size = bits & 0x7fffffffu;
    uint odd = size >> 13 & 1u;
    uint normal = (size - 0x38000000u + 0xfffu + odd) >> 13;
    // Below 2^-14: a sum of 1/2 or more is rounded to multiples of the least half, 2^-24.
    precise float sum = uintBitsToFloat(size) + 0.5;
    uint small = floatBitsToUint(sum) - 0x3f000000u;
    uint payload = size >> 13 & 0x3ffu;
    uint nan = 0x7c00u | payload | uint(payload == 0u); // must not become infinity
    uint finite = size < 0x38800000u ? small : normal;
    uint number = size < 0x477ff000u ? finite : 0x7c00u; // else above 65504
    return sign | (size > 0x7f800000u ? nan : number);
}
