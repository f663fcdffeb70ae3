// SPDX-License-Identifier: Apache-2.0
// How a time grows with the size of what is worked on.
#pragma once

#include <utility>
#include <vector>

namespace bench {

/// Slope of the line that fits (log x, log y) best; the exponent e of y = c x^e.
double growth_exponent(const std::vector<std::pair<double, double>>& points);

} // namespace bench
