// SPDX-License-Identifier: Apache-2.0
// A mapping whose positions form no grid.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/base/constants.h"
#include "ddt/mapping.h"

namespace ddt::test {

/// A window's picture, turned and enlarged; pixels that show nothing of it are left out.
class Turned final : public Mapping {
public:
    /// tight: reach() holds little else than is asked for; if not, all there is.
    Turned(const Rect& window, double degrees, double scale, bool tight = true)
        : m_window(window), m_cos(scale * std::cos(degrees * M_PI / 180)),
          m_sin(scale * std::sin(degrees * M_PI / 180)), m_tight(tight) {
        const Rect r = round_it(window.x0, window.y0, window.x1, window.y1);
        m_left = r.x0;
        m_top = r.y0;
        m_out = {0, 0, r.width(), r.height()};
    }

    /// The pixels that may show something; the first is at 0, 0.
    Rect out() const { return m_out; }

    Rect reach(double x0, double y0, double x1, double y1) const override {
        if (!m_tight)
            return m_out;
        const Rect &w = m_window, r = round_it(std::max(x0, w.x0 - 1.0), std::max(y0, w.y0 - 1.0),
                                               std::min(x1, w.x1 + 1.0), std::min(y1, w.y1 + 1.0));
        return {std::max(r.x0 - m_left, 0), std::max(r.y0 - m_top, 0),
                std::min(r.x1 - m_left, m_out.x1), std::min(r.y1 - m_top, m_out.y1)};
    }
    void row(int y, int x0, int x1, Position* positions, uint8_t* inside) const override {
        const double square = m_cos * m_cos + m_sin * m_sin, v = y + m_top;
        for (int x = x0; x < x1; ++x) {
            const double u = x + m_left;
            const Position p{std::llround((m_cos * u + m_sin * v) / square * position_one),
                             std::llround((m_cos * v - m_sin * u) / square * position_one)};
            *inside++ = p.x >= m_window.x0 * position_one && p.y >= m_window.y0 * position_one &&
                        p.x <= (m_window.x1 - 1) * position_one &&
                        p.y <= (m_window.y1 - 1) * position_one;
            *positions++ = p;
        }
    }

private:
    /// Round a turned and enlarged rectangle.
    Rect round_it(double x0, double y0, double x1, double y1) const {
        double left = 1e9, top = 1e9, right = -1e9, bottom = -1e9;
        for (const double x : {x0, x1})
            for (const double y : {y0, y1}) {
                const double to_x = m_cos * x - m_sin * y, to_y = m_sin * x + m_cos * y;
                left = std::min(left, to_x), right = std::max(right, to_x);
                top = std::min(top, to_y), bottom = std::max(bottom, to_y);
            }
        return {int(std::floor(left)), int(std::floor(top)), int(std::ceil(right)) + 1,
                int(std::ceil(bottom)) + 1};
    }

    Rect m_window, m_out;
    double m_cos, m_sin; ///< times the scale
    int m_left, m_top;
    bool m_tight;
};

} // namespace ddt::test
