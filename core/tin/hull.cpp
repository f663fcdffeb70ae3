// SPDX-License-Identifier: Apache-2.0
// From a triangulation of points to one of their convex hull.
#include <algorithm>
#include <cstddef>

#include "core/tin/delaunay.h"

namespace ddt {

namespace {

/// For every vertex the next along the rim, the triangles to the left; -1 off the rim.
std::vector<int32_t> rim_of(const std::vector<Steps>& points,
                            const std::vector<std::array<int32_t, 3>>& triangles) {
    std::vector<std::array<int32_t, 2>> sides;
    sides.reserve(3 * triangles.size());
    for (const auto& t : triangles)
        for (size_t k = 0; k < 3; ++k)
            sides.push_back({t[k], t[(k + 1) % 3]});
    std::sort(sides.begin(), sides.end());
    std::vector<int32_t> next(points.size(), -1);
    for (const auto& s : sides)
        if (!std::binary_search(sides.begin(), sides.end(), std::array<int32_t, 2>{s[1], s[0]}))
            next[size_t(s[0])] = s[1];
    return next;
}

/// Andrew's monotone chain: the corners of the convex hull of points sorted by y, then x.
std::vector<Steps> hull_of(const std::vector<Steps>& points) {
    std::vector<Steps> hull;
    const auto chain = [&](auto begin, auto end) {
        const size_t base = hull.size();
        for (auto p = begin; p != end; ++p) {
            while (hull.size() >= base + 2 &&
                   orientation(hull[hull.size() - 2], hull.back(), *p) <= 0)
                hull.pop_back();
            hull.push_back(*p);
        }
        hull.pop_back(); // the other chain begins with it
    };
    chain(points.begin(), points.end());
    chain(points.rbegin(), points.rend());
    return hull;
}

} // namespace

void complete_hull(const std::vector<Steps>& points,
                   std::vector<std::array<int32_t, 3>>& triangles) {
    std::vector<int32_t> next = rim_of(points, triangles);
    const auto at = [&](int32_t v) { return points[size_t(v)]; };
    std::vector<int32_t> rim; // from some vertex on, once round
    const auto first = std::find_if(next.begin(), next.end(), [](int32_t n) { return n >= 0; });
    if (first == next.end())
        return;
    for (int32_t v = int32_t(first - next.begin()); rim.size() <= points.size();) {
        rim.push_back(v);
        v = next[size_t(v)];
        if (v < 0 || v == rim[0])
            break;
    }
    // A vertex where the rim turns inwards is the middle of a triangle to add, unless the rim comes
    // into that triangle; then another of the same pocket goes first.
    const auto free = [&](int32_t u, int32_t v, int32_t w) {
        return std::none_of(rim.begin(), rim.end(), [&](int32_t p) {
            return p != u && p != v && p != w && orientation(at(u), at(w), at(p)) >= 0 &&
                   orientation(at(w), at(v), at(p)) >= 0 && orientation(at(v), at(u), at(p)) >= 0;
        });
    };
    for (size_t i = 0, calm = 0; calm < rim.size() && rim.size() > 3;) {
        const size_t n = rim.size();
        const int32_t u = rim[(i + n - 1) % n], v = rim[i % n], w = rim[(i + 1) % n];
        if (orientation(at(u), at(v), at(w)) < 0 && free(u, v, w)) {
            triangles.push_back({u, w, v});
            rim.erase(rim.begin() + std::ptrdiff_t(i % n));
            i = i % n == 0 ? rim.size() - 1 : i % n - 1;
            calm = 0;
        } else {
            i = (i + 1) % n;
            ++calm;
        }
    }
}

bool covers_hull(const std::vector<Steps>& points,
                 const std::vector<std::array<int32_t, 3>>& triangles) {
    // Whole numbers of up to 61 bits times their number: modulo 2^64 they still compare, as the
    // hull's own area, which is what they make if all is well, is below 2^61.
    uint64_t sum = 0, whole = 0;
    for (const auto& t : triangles)
        sum +=
            uint64_t(orientation(points[size_t(t[0])], points[size_t(t[1])], points[size_t(t[2])]));
    const std::vector<Steps> hull = hull_of(points);
    for (size_t i = 2; i < hull.size(); ++i)
        whole += uint64_t(orientation(hull[0], hull[i - 1], hull[i]));
    return sum == whole;
}

} // namespace ddt
