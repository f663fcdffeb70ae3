// SPDX-License-Identifier: Apache-2.0
// How a time grows with the size of what is worked on.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace bench {

/// Slope of the line that fits (log x, log y) best; the exponent e of y = c x^e. Two points at
/// least, of different x.
double growth_exponent(const std::vector<std::pair<double, double>>& points);

/// That with three digits; "-" of fewer than two points.
std::string exponent_text(const std::vector<std::pair<double, double>>& points);

} // namespace bench
