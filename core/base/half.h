// SPDX-License-Identifier: Apache-2.0
// 16-bit floats (IEEE 754 binary16) as their bits.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/float_bits.h"

namespace ddt {

// Compilers make vectors of loops over these (half.cpp). What floating point there is needs no
// denormal floats, which some callers' processors take for zero.

inline float float_of_half(uint16_t h) {
    const uint32_t sign = uint32_t(h & 0x8000u) << 16, size = h & 0x7fffu;
    const uint32_t normal = (size << 13) + 0x38000000u;
    const uint32_t small = bits_of(float(int32_t(size)) * 0x1p-24f); // exact
    const uint32_t special = size << 13 | 0x7f800000u;               // infinity, NaN
    const uint32_t finite = choose(size < 0x400u, small, normal);
    return float_of(sign | choose(size < 0x7c00u, finite, special));
}

/// The nearest; of two the even one. GLSL twin: shaders/half.glsl.
inline uint16_t half_of_float(float f) {
    const uint32_t bits = bits_of(f);
    const uint32_t sign = bits >> 16 & 0x8000u, size = bits & 0x7fffffffu;
    const uint32_t odd = size >> 13 & 1u;
    const uint32_t normal = (size - 0x38000000u + 0xfffu + odd) >> 13;
    // Below 2^-14: a sum of 1/2 or more is rounded to multiples of the least half, 2^-24.
    const uint32_t small = bits_of(float_of(size) + 0.5f) - 0x3f000000u;
    const uint32_t payload = size >> 13 & 0x3ffu;
    const uint32_t nan = 0x7c00u | payload | uint32_t(payload == 0u); // must not become infinity
    const uint32_t finite = choose(size < 0x38800000u, small, normal);
    const uint32_t number = choose(size < 0x477ff000u, finite, 0x7c00u); // else above 65504
    return uint16_t(sign | choose(size > 0x7f800000u, nan, number));
}

/// The same of n numbers.
void floats_of_halfs(const uint16_t* halfs, size_t n, float* floats);
void halfs_of_floats(const float* floats, size_t n, uint16_t* halfs);

/// All of it under the names that other kinds of numbers have, too: twin Codes in codes.h.
struct Halfs {
    using Stored = uint16_t;
    static float to(uint16_t half) { return float_of_half(half); }
    static uint16_t from(float v) { return half_of_float(v); }
    static void row_to(const uint16_t* row, size_t n, float* floats) {
        floats_of_halfs(row, n, floats);
    }
    static void row_from(const float* floats, size_t n, uint16_t* row) {
        halfs_of_floats(floats, n, row);
    }
};

} // namespace ddt
