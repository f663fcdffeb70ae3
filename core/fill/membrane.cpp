// SPDX-License-Identifier: Apache-2.0
#include "core/fill/membrane.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <mutex>
#include <thread>

#include "core/base/float_mode.h"
#include "core/base/parallel.h"

namespace ddt {

namespace {

/// A step of the guide, about 0 to 1, across which neighbours count half.
constexpr float edge_step = 0.1f;

/// Sweeps: enough for holes of some hundred pixels across, whose middle the mesh has set before.
constexpr int sweeps = 200;

/// By how much a sweep goes farther than to the mean (successive over-relaxation; Young 1954).
constexpr float over = 0.7f;

/// A pixel that is smoothed, and what the four about it count: left, right, above, below; 0 for
/// none.
struct Knot {
    size_t pixel;
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
        const size_t beside[] = {i - 1, i + 1, i - width, i + width};
        Knot knot{i, {}};
        bool inner = true;
        for (size_t k = 0; k < 4; ++k) {
            if (!there[k] || !known[beside[k]])
                continue;
            inner &= filled[beside[k]] != 0;
            knot.weight[k] = weight_of(guide[beside[k]] - guide[i]);
        }
        if (inner)
            knots.push_back(knot);
    }
    return knots;
}

/// Numbers of which `stride` make a pixel, `pitch` a row.
struct Plane {
    float* numbers;
    ptrdiff_t stride, pitch;
};

void smooth(const Knot& knot, const Plane& plane) {
    float* own = plane.numbers + ptrdiff_t(knot.pixel) * plane.stride;
    if (!std::isfinite(*own))
        return;
    const ptrdiff_t beside[] = {-plane.stride, plane.stride, -plane.pitch, plane.pitch};
    float sum = 0, weights = 0, low = *own, high = *own;
    for (size_t k = 0; k < 4; ++k) {
        const float w = knot.weight[k];
        if (w == 0.0f)
            continue;
        const float v = own[beside[k]];
        if (!std::isfinite(v))
            continue;
        sum = sum + w * v;
        weights = weights + w;
        low = std::min(low, v);
        high = std::max(high, v);
    }
    if (!(weights > 0.0f))
        return;
    const float mean = sum / weights;
    *own = std::min(std::max(mean + over * (mean - *own), low), high);
}

/// All sweeps, each through the rows from the first to the last. One may run while those before it
/// do, two rows behind: a row needs of the sweep before it that it is past the next row, and no
/// more. All planes at once: the knots are what takes long to fetch. False: cancelled.
bool sweep(const std::vector<Knot>& knots, const std::vector<Plane>& planes,
           const HoledImage& image, const ProgressCallback& progress) {
    const int height = image.height;
    std::vector<size_t> first(size_t(height) + 1, knots.size()); // knot of each row
    for (size_t k = knots.size(); k-- > 0;)
        first[knots[k].pixel / size_t(image.width)] = k;
    for (size_t y = size_t(height); y-- > 0;)
        first[y] = std::min(first[y], first[y + 1]);
    std::array<std::atomic<int>, sweeps> rows_done{};
    std::mutex mutex; // of what follows
    size_t begun = 0;
    std::atomic<bool> going{true};
    // In the order that they are begun, so that who waits waits for one that runs; only then, since
    // `progress` may throw.
    const auto begin = [&] {
        const std::lock_guard<std::mutex> lock(mutex);
        if (going && progress && !progress(float(begun) / float(sweeps)))
            going = false;
        return begun++;
    };
    for_each_index(threads_for(image.threads), sweeps, [&](int, int) {
        const size_t own = begin();
        const DenormalsAreZero mode; // whichever thread this is
        for (int y = 0; y < height && going; ++y) {
            const int needed = std::min(y + 2, height);
            while (own > 0 && rows_done[own - 1].load(std::memory_order_acquire) < needed)
                std::this_thread::yield();
            for (size_t k = first[size_t(y)]; k < first[size_t(y) + 1]; ++k)
                for (const Plane& plane : planes)
                    smooth(knots[k], plane);
            rows_done[own].store(y + 1, std::memory_order_release);
        }
        rows_done[own].store(height, std::memory_order_release);
    });
    return going;
}

} // namespace

bool smooth_holes(const HoledImage& image, const std::vector<uint8_t>& filled,
                  const std::vector<uint8_t>& known, const std::vector<float>& guide,
                  const ProgressCallback& progress) {
    const std::vector<Knot> knots = list_knots(image, filled, known, guide);
    if (knots.empty())
        return true;
    std::vector<Plane> planes;
    for (int c = 0; c < image.channels; ++c)
        if (!image.kinds || image.kinds[c] != Channel::nearest)
            planes.push_back(
                {image.values + c, image.channels, ptrdiff_t(image.channels) * image.width});
    if (image.filled_guide)
        planes.push_back({image.filled_guide, 1, image.width});
    return sweep(knots, planes, image, progress);
}

} // namespace ddt
