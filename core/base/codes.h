// SPDX-License-Identifier: Apache-2.0
// Numbers as the codes of integer pixels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "core/base/float_bits.h"

namespace ddt {

/// 0 to 1 as 0 to the type's largest value, rounded to the nearest, from the middle upwards;
/// NaN as 0.
template <class Code>
inline Code code_of(float v) {
    constexpr float scale = std::numeric_limits<Code>::max();
    // As integers, those of negative numbers are larger than infinity's, as of NaN.
    constexpr uint32_t infinity = 0x7f800000u, one = 0x3f800000u;
    const uint32_t bits = bits_of(v), positive = choose(bits <= infinity, bits, 0u);
    const float scaled = float_of(choose(positive < one, positive, one)) * scale;
    const int code = int(scaled);
    // Not int(scaled + 0.5f): the sum of the float below 0.5 and 0.5 is rounded to 1.
    return Code(code + int(scaled - float(code) >= 0.5f));
}

/// The way back.
template <class Code>
inline float float_of_code(Code code) {
    return float(code) * (1.0f / float(std::numeric_limits<Code>::max()));
}

/// The same of n numbers.
void codes_of_floats(const float* floats, size_t n, uint8_t* codes);
void codes_of_floats(const float* floats, size_t n, uint16_t* codes);
void floats_of_codes(const uint8_t* codes, size_t n, float* floats);
void floats_of_codes(const uint16_t* codes, size_t n, float* floats);

/// All of it under the names that other kinds of numbers have, too: twin Halfs in half.h.
template <class Code>
struct Codes {
    using Stored = Code;
    static float to(Code code) { return float_of_code(code); }
    static Code from(float v) { return code_of<Code>(v); }
    static void row_to(const Code* row, size_t n, float* floats) {
        floats_of_codes(row, n, floats);
    }
    static void row_from(const float* floats, size_t n, Code* row) {
        codes_of_floats(floats, n, row);
    }
};

} // namespace ddt
