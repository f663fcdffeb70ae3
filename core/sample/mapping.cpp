// SPDX-License-Identifier: Apache-2.0
#include "ddt/core.h"

#include <algorithm>
#include <cmath>

#include "core/lattice/locate.h"

namespace ddt {

namespace {

int64_t divide_rounding_down(__int128 n, __int128 d) {
    const __int128 q = n / d;
    return int64_t(q * d > n ? q - 1 : q);
}

} // namespace

int64_t ResizeMapping::Axis::position(int i) const {
    // from0 + (i + 1/2 - to0) * from_size / to_size - 1/2, rounded to 2^-16 (halves up).
    const __int128 numerator = (__int128(2) * (int64_t(i) - to0) + 1) * from_size * position_one;
    const int64_t scaled = divide_rounding_down(numerator + to_size, __int128(2) * to_size);
    const int64_t p = int64_t(from0) * position_one + scaled - position_one / 2;
    return std::clamp(p, int64_t(window0) * position_one, int64_t(window1 - 1) * position_one);
}

int ResizeMapping::Axis::first_at_or_after(int limit) const {
    int low = out0, high = out1;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (position(middle) < int64_t(limit) * position_one)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

Rect ResizeMapping::reach(double x0, double y0, double x1, double y1) const {
    const auto limit = [](double v) {
        return int(std::ceil(std::clamp(v, -2147483648.0, 2147483647.0)));
    };
    return {m_x.first_at_or_after(limit(x0)), m_y.first_at_or_after(limit(y0)),
            m_x.first_at_or_after(limit(x1)), m_y.first_at_or_after(limit(y1))};
}

void ResizeMapping::row(int y, int x0, int x1, Position* positions, uint8_t* inside) const {
    const int64_t row = m_y.position(y);
    for (int x = x0; x < x1; ++x, ++positions, ++inside) {
        *positions = {m_x.position(x), row};
        *inside = 1;
    }
}

} // namespace ddt
