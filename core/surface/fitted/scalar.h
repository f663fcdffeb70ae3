// SPDX-License-Identifier: Apache-2.0
// The formulas of fitted vertices and bends for one channel: to fit their weights, and the
// reference of the SIMD twins.
#pragma once

#include <cstddef>

#include "core/base/arith.h"
#include "core/base/constants.h"
#include "core/surface/consistency/consistency.h"
#include "core/surface/fitted/weights.h"

namespace ddt::scalar {

inline float if_less(float a, float b, float yes, float no) {
    return a < b ? yes : no;
}
inline float if_less_equal(float a, float b, float yes, float no) {
    return a <= b ? yes : no;
}
inline float lower(float a, float b) {
    return b < a ? b : a;
}
inline float upper(float a, float b) {
    return a < b ? b : a;
}

#include "core/surface/consistency/consistency-inl.h"
#include "core/surface/fitted/features-inl.h"

} // namespace ddt::scalar
