// SPDX-License-Identifier: Apache-2.0
// Half floats (IEEE 754 binary16), rounded to nearest even. GLSL twin: shaders/half.glsl.
#pragma once

#include <cstdint>
#include <cstring>

namespace ddt::bench {

/// The float with the value of the half.
inline float widened(uint16_t half) {
    const uint32_t sign = (half & 0x8000u) << 16, a = half & 0x7fffu;
    uint32_t bits;
    if (a >= 0x7c00u) {
        bits = sign | 0x7f800000u | (a & 0x3ffu) << 13;
    } else if (a >= 0x400u) {
        bits = sign | ((a << 13) + (112u << 23));
    } else {
        const float small = float(a) * (1.0f / 16777216.0f);
        std::memcpy(&bits, &small, sizeof bits);
        bits |= sign;
    }
    float value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

inline uint16_t narrowed(float value) {
    uint32_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    const uint32_t sign = bits >> 16 & 0x8000u, a = bits & 0x7fffffffu;
    if (a > 0x7f800000u)
        return uint16_t(sign | 0x7e00u);
    if (a >= 0x477ff000u)
        return uint16_t(sign | 0x7c00u);
    if (a >= 0x38800000u) {
        const uint32_t r = a - (112u << 23);
        return uint16_t(sign | (r + 0xfffu + (r >> 13 & 1u)) >> 13);
    }
    if (a < 0x33000000u)
        return uint16_t(sign);
    const uint32_t m = (a & 0x7fffffu) | 0x800000u, shift = 126u - (a >> 23);
    const uint32_t r = m >> shift, rest = m & ((1u << shift) - 1u), tie = 1u << (shift - 1u);
    return uint16_t(sign | (r + (rest > tie || (rest == tie && (r & 1u)) ? 1u : 0u)));
}

} // namespace ddt::bench
