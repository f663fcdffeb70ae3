// SPDX-License-Identifier: Apache-2.0
#include "metrics/gmsd.h"

#include <cmath>

namespace metrics {

namespace {

double prewitt(const Plane& p, int x, int y) {
    double across = 0, down = 0;
    for (int i = -1; i <= 1; ++i) {
        across += p.at(x + 1, y + i) - p.at(x - 1, y + i);
        down += p.at(x + i, y + 1) - p.at(x + i, y - 1);
    }
    return std::hypot(across / 3, down / 3);
}

} // namespace

double gmsd(const Plane& a, const Plane& b) {
    constexpr double c = 170;
    Plane u = halved(a), v = halved(b);
    double sum = 0, squares = 0, count = 0;
    for (int y = 1; y + 1 < u.height; ++y)
        for (int x = 1; x + 1 < u.width; ++x) {
            double gu = prewitt(u, x, y), gv = prewitt(v, x, y);
            double similarity = (2 * gu * gv + c) / (gu * gu + gv * gv + c);
            sum += similarity;
            squares += similarity * similarity;
            ++count;
        }
    if (count == 0)
        return 0;
    double mean = sum / count;
    return std::sqrt(std::fmax(squares / count - mean * mean, 0));
}

} // namespace metrics
