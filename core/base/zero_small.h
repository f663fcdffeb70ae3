// SPDX-License-Identifier: Apache-2.0
// Numbers that are next to nothing, or none.
#pragma once

#include <cstddef>

namespace ddt {

/// Make those of n numbers nearer to zero than `least` zero.
void zero_small(float* values, size_t n, float least);

/// Also those that are not finite.
void zero_unusual(float* values, size_t n, float least);

} // namespace ddt
