// SPDX-License-Identifier: Apache-2.0
#include "metrics/ssim.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace metrics {

namespace {

constexpr int largest_window = 11;

std::vector<double> gaussian(int window) {
    std::vector<double> weights(static_cast<size_t>(window));
    double sum = 0;
    for (int i = 0; i < window; ++i) {
        double d = i - (window - 1) / 2.0;
        weights[size_t(i)] = std::exp(-d * d / (2 * 1.5 * 1.5));
        sum += weights[size_t(i)];
    }
    for (double& w : weights)
        w /= sum;
    return weights;
}

/// Weighted means over the window, at the positions where it lies inside. It is no larger than the
/// plane.
template <typename Value>
Plane windowed(int width, int height, Value value) {
    const int window = std::min({largest_window, width, height});
    const std::vector<double> weights = gaussian(window);
    Plane across(width - window + 1, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < across.width; ++x) {
            double sum = 0;
            for (int i = 0; i < window; ++i)
                sum += weights[size_t(i)] * value(x + i, y);
            across.at(x, y) = sum;
        }
    Plane out(across.width, height - window + 1);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            double sum = 0;
            for (int i = 0; i < window; ++i)
                sum += weights[size_t(i)] * across.at(x, y + i);
            out.at(x, y) = sum;
        }
    return out;
}

/// Means over the plane of the whole index, and of its part without the luminance term.
struct Similarity {
    double whole, contrast_structure;
};

bool fits(const Plane& plane) {
    return std::min(plane.width, plane.height) >= largest_window;
}

Similarity similarity(const Plane& a, const Plane& b) {
    constexpr double c1 = 0.01 * 255 * 0.01 * 255, c2 = 0.03 * 255 * 0.03 * 255;
    auto mean_of = [&](auto value) { return windowed(a.width, a.height, value); };
    Plane ma = mean_of([&](int x, int y) { return a.at(x, y); });
    Plane mb = mean_of([&](int x, int y) { return b.at(x, y); });
    Plane maa = mean_of([&](int x, int y) { return a.at(x, y) * a.at(x, y); });
    Plane mbb = mean_of([&](int x, int y) { return b.at(x, y) * b.at(x, y); });
    Plane mab = mean_of([&](int x, int y) { return a.at(x, y) * b.at(x, y); });

    Similarity sum{0, 0};
    for (size_t i = 0; i < ma.values.size(); ++i) {
        double u = ma.values[i], v = mb.values[i];
        double luminance = (2 * u * v + c1) / (u * u + v * v + c1);
        double rest = (2 * (mab.values[i] - u * v) + c2) /
                      (maa.values[i] - u * u + mbb.values[i] - v * v + c2);
        sum.whole += luminance * rest;
        sum.contrast_structure += rest;
    }
    double count = double(ma.values.size());
    return {sum.whole / count, sum.contrast_structure / count};
}

} // namespace

double ssim(const Plane& a, const Plane& b) {
    return a.empty() ? 1 : similarity(a, b).whole;
}

double ms_ssim(const Plane& a, const Plane& b) {
    constexpr double weights[] = {0.0448, 0.2856, 0.3001, 0.2363, 0.1333};
    double log_sum = 0, weight_sum = 0;
    if (!fits(a))
        return std::max(ssim(a, b), 0.0);
    Plane u = a, v = b;
    for (double weight : weights) {
        if (!fits(u))
            break;
        Plane next_u = halved(u), next_v = halved(v);
        bool last = weight == weights[4] || !fits(next_u);
        Similarity s = similarity(u, v);
        // A scale whose structure is inverted counts as nothing in common.
        double term = std::max(last ? s.whole : s.contrast_structure, 0.0);
        log_sum += weight * std::log(term);
        weight_sum += weight;
        u = std::move(next_u);
        v = std::move(next_v);
    }
    return std::exp(log_sum / weight_sum);
}

} // namespace metrics
