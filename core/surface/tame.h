// SPDX-License-Identifier: Apache-2.0
// Values so small that every gradient, bend and sum of them is finite: code may skip its tests for
// inf and NaN.
#pragma once

#include <cstddef>

namespace ddt {

/// Values up to this size are tame. Gradients of triangles are less than 2^8 times as large, no
/// edge being longer than longest_edge along an axis, and squares of those are finite, too.
constexpr float tame_value = 0x1p50f;

/// Whether so many values are tame. A NaN is not.
bool all_tame(const float* values, size_t n);

} // namespace ddt
