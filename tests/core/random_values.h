// SPDX-License-Identifier: Apache-2.0
// Pixel values of all sizes.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "tests/core/random.h"

namespace ddt::test {

/// A number of pixel values' size.
inline float random_value(Random& random) {
    return random.unit();
}
/// A number from 1e-3 to 1e4, every decade as often.
inline float random_hdr(Random& random) {
    return float(std::pow(10.0, -3.0 + 7.0 * double(random.unit())));
}
/// A number of any sign and size that a float can be, up to 1e38.
inline float random_wild(Random& random) {
    const double x = std::pow(10.0, -46.0 + 84.0 * double(random.unit()));
    return float(random.below(2) ? x : -x);
}

template <class F>
std::vector<float> fill(size_t n, F&& f) {
    std::vector<float> v(n);
    for (float& x : v)
        x = f();
    return v;
}

} // namespace ddt::test
