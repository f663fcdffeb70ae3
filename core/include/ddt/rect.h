// SPDX-License-Identifier: Apache-2.0
// Windows of pixels.
#pragma once

#include <algorithm>
#include <cstddef>

namespace ddt {

/// Coordinates of windows, of sources and results, lie within +- this, so that positions and sites
/// stay far from overflow.
constexpr int largest_coordinate = 1 << 29;

/// Pixels x0 <= x < x1, y0 <= y < y1.
struct Rect {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }
    bool empty() const { return x1 <= x0 || y1 <= y0; }
    size_t area() const { return empty() ? 0 : size_t(width()) * size_t(height()); }
    bool contains(const Rect& o) const {
        return x0 <= o.x0 && y0 <= o.y0 && x1 >= o.x1 && y1 >= o.y1;
    }
    /// Whether a source or a result may have this window.
    bool within_limits() const {
        return x0 >= -largest_coordinate && y0 >= -largest_coordinate && x1 <= largest_coordinate &&
               y1 <= largest_coordinate;
    }
    bool operator==(const Rect& o) const {
        return x0 == o.x0 && y0 == o.y0 && x1 == o.x1 && y1 == o.y1;
    }
};

/// What both have; empty(), of whatever size, if they have nothing.
inline Rect intersection(const Rect& a, const Rect& b) {
    return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

} // namespace ddt
