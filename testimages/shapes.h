// SPDX-License-Identifier: Apache-2.0
// Shapes to paint with: does a position lie inside?
#pragma once

#include <cmath>
#include <vector>

namespace testimages {

constexpr double pi = 3.14159265358979323846;

struct Point {
    double x, y;
};

inline double distance(Point p, Point q) {
    return std::hypot(p.x - q.x, p.y - q.y);
}

inline bool in_disc(Point p, Point centre, double radius) {
    return distance(p, centre) < radius;
}

inline bool on_circle(Point p, Point centre, double radius, double width) {
    return std::abs(distance(p, centre) - radius) < width / 2;
}

/// A stroke with round ends.
inline bool on_line(Point p, Point from, Point to, double width) {
    double dx = to.x - from.x, dy = to.y - from.y;
    double along = ((p.x - from.x) * dx + (p.y - from.y) * dy) / (dx * dx + dy * dy);
    along = std::fmin(std::fmax(along, 0.0), 1.0);
    return distance(p, {from.x + along * dx, from.y + along * dy}) < width / 2;
}

inline bool on_lines(Point p, const std::vector<Point>& corners, double width) {
    for (size_t i = 0; i + 1 < corners.size(); ++i)
        if (on_line(p, corners[i], corners[i + 1], width))
            return true;
    return false;
}

inline bool in_box(Point p, Point low, Point high) {
    return p.x >= low.x && p.x < high.x && p.y >= low.y && p.y < high.y;
}

/// By the even-odd rule.
inline bool in_polygon(Point p, const std::vector<Point>& corners) {
    bool inside = false;
    for (size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
        const Point &a = corners[i], &b = corners[j];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y))
            inside = !inside;
    }
    return inside;
}

} // namespace testimages
