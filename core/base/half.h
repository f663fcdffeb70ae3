// SPDX-License-Identifier: Apache-2.0
// 16-bit floats (IEEE 754 binary16) as their bits.
#pragma once

#include <cstdint>

#include "core/base/float_bits.h"

namespace ddt {

inline float float_of_half(uint16_t h) {
    const uint32_t sign = uint32_t(h & 0x8000u) << 16, size = h & 0x7fffu;
    if (size >= 0x7c00u) // infinity, NaN
        return float_of(sign | 0x7f800000u | (size & 0x3ffu) << 13);
    // With the exponent too small by 112, mended by a multiplication that is exact, for denormal
    // numbers too.
    return float_of(sign | bits_of(float_of(size << 13) * 0x1p112f));
}

/// The nearest; of two the even one. GLSL twin: shaders/half.glsl.
inline uint16_t half_of_float(float f) {
    const uint32_t bits = bits_of(f);
    const auto sign = uint16_t(bits >> 16 & 0x8000u);
    const uint32_t size = bits & 0x7fffffffu;
    if (size > 0x7f800000u) { // NaN, which must not become infinity
        const uint32_t payload = size >> 13 & 0x3ffu;
        return uint16_t(sign | 0x7c00u | payload | uint32_t(payload == 0));
    }
    if (size >= 0x477ff000u) // rounds to more than 65504
        return uint16_t(sign | 0x7c00u);
    if (size >= 0x38800000u) { // 2^-14 and more: normal
        const uint32_t odd = size >> 13 & 1u;
        return uint16_t(sign | (size - 0x38000000u + 0xfffu + odd) >> 13);
    }
    if (size < 0x33000000u) // below half of the least
        return sign;
    const uint32_t shift = 126u - (size >> 23), mantissa = (size & 0x7fffffu) | 0x800000u;
    const uint32_t whole = mantissa >> shift, rest = mantissa & ((1u << shift) - 1u);
    const uint32_t middle = 1u << (shift - 1u);
    return uint16_t(sign | (whole + uint32_t(rest > middle || (rest == middle && (whole & 1u)))));
}

} // namespace ddt
