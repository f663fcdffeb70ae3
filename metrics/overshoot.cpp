// SPDX-License-Identifier: Apache-2.0
#include "metrics/overshoot.h"

#include <algorithm>

namespace metrics {

namespace {

struct Range {
    double low, high;
};

Range range_nearby(const Plane& p, int x, int y, int reach) {
    Range range{p.at(x, y), p.at(x, y)};
    for (int j = std::max(y - reach, 0); j <= std::min(y + reach, p.height - 1); ++j)
        for (int i = std::max(x - reach, 0); i <= std::min(x + reach, p.width - 1); ++i) {
            range.low = std::min(range.low, p.at(i, j));
            range.high = std::max(range.high, p.at(i, j));
        }
    return range;
}

} // namespace

Overshoot overshoot(const Image& source, const Image& enlarged, int scale, int reach) {
    Overshoot result;
    double sum = 0, negative = 0, count = 0;
    for (int c = 0; c < 3; ++c) {
        const Plane &small = source.channels[c], &large = enlarged.channels[c];
        for (int y = 0; y < small.height; ++y)
            for (int x = 0; x < small.width; ++x) {
                Range range = range_nearby(small, x, y, reach);
                for (int j = 0; j < scale; ++j)
                    for (int i = 0; i < scale; ++i) {
                        double value = large.at(x * scale + i, y * scale + j);
                        double beyond = std::max({value - range.high, range.low - value, 0.0});
                        result.largest = std::max(result.largest, beyond);
                        sum += beyond;
                        negative += value < 0;
                    }
            }
        count += double(large.values.size());
    }
    if (count > 0) {
        result.mean = sum / count;
        result.negative_share = negative / count;
    }
    return result;
}

} // namespace metrics
