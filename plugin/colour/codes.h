// SPDX-License-Identifier: Apache-2.0
// Numbers as the codes of integer pixels.
#pragma once

#include <cstdint>
#include <limits>

namespace ddt {

/// 0 to 1 as 0 to the type's largest value, rounded to the nearest; NaN as 0.
template <class Code>
inline Code code_of(float v) {
    constexpr float scale = std::numeric_limits<Code>::max();
    const float low = v > 0.0f ? v : 0.0f; // NaN too
    return Code(int((low < 1.0f ? low : 1.0f) * scale + 0.5f));
}

} // namespace ddt
