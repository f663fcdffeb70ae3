// SPDX-License-Identifier: Apache-2.0
#include "growth.h"

#include <cmath>
#include <cstdio>

namespace bench {

double growth_exponent(const std::vector<std::pair<double, double>>& points) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (const auto& [size, time] : points) {
        const double u = std::log(size), v = std::log(time);
        n += 1;
        x += u;
        y += v;
        xx += u * u;
        xy += u * v;
    }
    return (n * xy - x * y) / (n * xx - x * x);
}

std::string exponent_text(const std::vector<std::pair<double, double>>& points) {
    if (points.size() < 2)
        return "-";
    char text[32];
    std::snprintf(text, sizeof text, "%.3f", growth_exponent(points));
    return text;
}

} // namespace bench
