// SPDX-License-Identifier: Apache-2.0
#include "metrics/uiqi.h"

#include <algorithm>

namespace metrics {

namespace {

constexpr int window = 8;

/// Sums over every window: a running sum along the rows, then along the columns.
template <class Value>
Plane window_sums(int width, int height, int across, int down, Value value) {
    Plane rows(width - across + 1, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < rows.width; ++x) {
            double sum = 0;
            for (int i = 0; i < across; ++i)
                sum += value(x + i, y);
            rows.at(x, y) = sum;
        }
    Plane sums(rows.width, height - down + 1);
    for (int y = 0; y < sums.height; ++y)
        for (int x = 0; x < sums.width; ++x)
            for (int i = 0; i < down; ++i)
                sums.at(x, y) += rows.at(x, y + i);
    return sums;
}

/// The index of one window of n pixels from its sums.
double index(double n, double a, double b, double aa, double bb, double ab) {
    // Everything times n^2. Of flat windows nothing is left but what was rounded off.
    const double all = n * aa - a * a + n * bb - b * b;
    const double variances = all > 1e-12 * n * (aa + bb) ? all : 0;
    const double squares = a * a + b * b;
    const double covariance = n * ab - a * b;
    if (squares == 0)
        return variances == 0 ? 1 : 0;
    if (variances == 0)
        return 2 * a * b / squares;
    return 4 * covariance * a * b / (variances * squares);
}

} // namespace

double uiqi(const Plane& a, const Plane& b) {
    if (a.empty())
        return 1;
    const int across = std::min(window, a.width), down = std::min(window, a.height);
    const auto sums = [&](auto value) {
        return window_sums(a.width, a.height, across, down, value);
    };
    const Plane sa = sums([&](int x, int y) { return a.at(x, y); });
    const Plane sb = sums([&](int x, int y) { return b.at(x, y); });
    const Plane saa = sums([&](int x, int y) { return a.at(x, y) * a.at(x, y); });
    const Plane sbb = sums([&](int x, int y) { return b.at(x, y) * b.at(x, y); });
    const Plane sab = sums([&](int x, int y) { return a.at(x, y) * b.at(x, y); });
    double sum = 0;
    for (size_t i = 0; i < sa.values.size(); ++i)
        sum += index(double(across) * down, sa.values[i], sb.values[i], saa.values[i],
                     sbb.values[i], sab.values[i]);
    return sum / double(sa.values.size());
}

} // namespace metrics
