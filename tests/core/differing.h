// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/base/float_bits.h"

namespace ddt::test {

/// How many floats differ in any bit; all of them if the sizes do.
inline size_t differing(const std::vector<float>& a, const std::vector<float>& b) {
    if (a.size() != b.size())
        return std::max(a.size(), b.size());
    size_t n = 0;
    for (size_t i = 0; i < a.size(); ++i)
        n += bits_of(a[i]) != bits_of(b[i]);
    return n;
}

} // namespace ddt::test
