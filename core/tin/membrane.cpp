// SPDX-License-Identifier: Apache-2.0
#include "core/tin/membrane.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ddt {

namespace {

/// A step of the guide, about 0 to 1, across which neighbours count half.
constexpr float edge_step = 0.1f;

/// Sweeps: enough for holes of some hundred pixels across, whose middle the mesh has set before.
constexpr int sweeps = 200;

/// By how much a sweep goes farther than to the mean (successive over-relaxation; Young 1954).
constexpr float over = 0.7f;

/// A pixel that is smoothed: the four about it and what they count; 0 for none.
struct Knot {
    size_t pixel;
    std::array<size_t, 4> beside;
    std::array<float, 4> weight;
};

float weight_of(float step) {
    const float e = step * (1.0f / edge_step), square = e * e;
    const float w = 1.0f / (1.0f + square * square);
    return std::isfinite(w) ? w : 0.0f;
}

std::vector<Knot> list_knots(const HoledImage& image, const std::vector<uint8_t>& filled,
                             const std::vector<uint8_t>& known, const std::vector<float>& guide) {
    const auto width = size_t(image.width), size = filled.size();
    std::vector<Knot> knots;
    for (size_t i = 0; i < size; ++i) {
        if (!filled[i])
            continue;
        const size_t x = i % width;
        const bool there[] = {x > 0, x + 1 < width, i >= width, i + width < size};
        Knot knot{i, {i - 1, i + 1, i - width, i + width}, {}};
        bool inner = true;
        for (size_t k = 0; k < 4; ++k) {
            const size_t j = knot.beside[k];
            if (!there[k] || !known[j]) {
                knot.beside[k] = i;
                continue;
            }
            inner &= filled[j] != 0;
            knot.weight[k] = weight_of(guide[j] - guide[i]);
        }
        if (inner)
            knots.push_back(knot);
    }
    return knots;
}

/// A sweep over numbers of which `stride` make a pixel.
void sweep(const std::vector<Knot>& knots, float* numbers, size_t stride) {
    for (const Knot& knot : knots) {
        float& own = numbers[knot.pixel * stride];
        if (!std::isfinite(own))
            continue;
        float sum = 0, weights = 0, low = own, high = own;
        for (size_t k = 0; k < 4; ++k) {
            const float w = knot.weight[k], v = numbers[knot.beside[k] * stride];
            if (w == 0.0f || !std::isfinite(v))
                continue;
            sum = sum + w * v;
            weights = weights + w;
            low = std::min(low, v);
            high = std::max(high, v);
        }
        if (!(weights > 0.0f))
            continue;
        const float mean = sum / weights;
        own = std::min(std::max(mean + over * (mean - own), low), high);
    }
}

} // namespace

void smooth_holes(const HoledImage& image, const std::vector<uint8_t>& filled,
                  const std::vector<uint8_t>& known, const std::vector<float>& guide) {
    const std::vector<Knot> knots = list_knots(image, filled, known, guide);
    if (knots.empty())
        return;
    for (size_t c = 0; c < size_t(image.channels); ++c)
        if (!image.kinds || image.kinds[c] != Channel::nearest)
            for (int i = 0; i < sweeps; ++i)
                sweep(knots, image.values + c, size_t(image.channels));
    for (int i = 0; image.guide_too && i < sweeps; ++i)
        sweep(knots, image.guide, 1);
}

} // namespace ddt
