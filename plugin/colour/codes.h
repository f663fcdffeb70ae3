// SPDX-License-Identifier: Apache-2.0
// Numbers as the codes of integer pixels.
#pragma once

#include <cstdint>
#include <limits>

namespace ddt {

/// 0 to 1 as 0 to the type's largest value, rounded to the nearest, from the middle upwards;
/// NaN as 0.
template <class Code>
inline Code code_of(float v) {
    constexpr float scale = std::numeric_limits<Code>::max();
    const float low = v > 0.0f ? v : 0.0f; // NaN too
    const float scaled = (low < 1.0f ? low : 1.0f) * scale;
    const int code = int(scaled);
    // Not int(scaled + 0.5f): the sum of the float below 0.5 and 0.5 is rounded to 1.
    return Code(code + int(scaled - float(code) >= 0.5f));
}

} // namespace ddt
