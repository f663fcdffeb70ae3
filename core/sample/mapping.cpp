// SPDX-License-Identifier: Apache-2.0
#include "ddt/core.h"

#include <algorithm>
#include <cmath>

#include "core/lattice/locate.h"

namespace ddt {

namespace {

__int128 divide_rounding_down(__int128 n, __int128 d) {
    const __int128 q = n / d;
    return q * d > n ? q - 1 : q;
}

/// from0 + (i + 1/2 - to0) * from_size / to_size - 1/2, rounded to 2^-16 (halves up), is numerator
/// / divisor rounded down, moved by the window.
__int128 numerator(const ResizeMapping::Axis& a, int i) {
    return (__int128(2) * (int64_t(i) - a.to0) + 1) * a.from_size * position_one + a.to_size;
}

int64_t divisor(const ResizeMapping::Axis& a) {
    return int64_t(2) * a.to_size;
}

/// `scaled` is beyond 64 bits where what is far outside is shown much smaller.
int64_t moved(const ResizeMapping::Axis& a, __int128 scaled) {
    const __int128 p = int64_t(a.from0) * position_one + scaled - position_one / 2;
    return int64_t(std::clamp<__int128>(p, int64_t(a.window0) * position_one,
                                        int64_t(a.window1 - 1) * position_one));
}

/// The positions of one pixel after the other: a division for the first, sums for the others.
class AxisWalk {
public:
    AxisWalk(const ResizeMapping::Axis& axis, int first)
        : m_axis(axis), m_divisor(divisor(axis)),
          m_scaled(divide_rounding_down(numerator(axis, first), m_divisor)),
          m_rest(int64_t(numerator(axis, first) - m_scaled * m_divisor)),
          m_step(int64_t(2) * axis.from_size * position_one / m_divisor),
          m_step_rest(int64_t(2) * axis.from_size * position_one % m_divisor) {}

    int64_t next() {
        const int64_t p = moved(m_axis, m_scaled);
        m_scaled += m_step;
        m_rest += m_step_rest;
        const bool carry = m_rest >= m_divisor;
        m_scaled += carry;
        m_rest -= carry ? m_divisor : 0;
        return p;
    }

private:
    const ResizeMapping::Axis& m_axis;
    int64_t m_divisor;
    __int128 m_scaled;
    int64_t m_rest; ///< 0 <= rest < divisor
    int64_t m_step, m_step_rest;
};

} // namespace

int64_t ResizeMapping::Axis::position(int i) const {
    return moved(*this, divide_rounding_down(numerator(*this, i), divisor(*this)));
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
    AxisWalk along(m_x, x0);
    for (int x = x0; x < x1; ++x, ++positions, ++inside) {
        *positions = {along.next(), row};
        *inside = 1;
    }
}

} // namespace ddt
