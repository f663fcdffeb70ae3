// SPDX-License-Identifier: Apache-2.0
#include "core/tin/tin.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ddt {

namespace {

/// One of a triangle's sides, with its ends in the order of their addresses.
struct Side {
    int32_t first, second;
    int32_t triangle, corner;
    bool forwards; ///< whether the triangle has it from first to second, so lies to its left
};

/// A line that tells where in the file the fault is.
std::string fault(size_t triangle, const std::string& what) {
    return "ddt: triangle " + std::to_string(triangle) + " " + what;
}

bool list_triangles(Tin& tin, const std::vector<std::array<int32_t, 3>>& triangles,
                    std::string& error) {
    tin.triangles.clear();
    tin.triangles.reserve(triangles.size());
    double doubled_area = 0;
    for (std::array<int32_t, 3> t : triangles) {
        const auto at = [&](size_t k) { return tin.vertices[size_t(t[k])].at; };
        int64_t area = orientation(at(0), at(1), at(2));
        if (area < 0) {
            std::swap(t[1], t[2]);
            area = -area;
        }
        // In one way round and from one vertex on, so that arithmetic does not depend on the
        // file's.
        while (before(at(1), at(0)) || before(at(2), at(0)))
            std::rotate(t.begin(), t.begin() + 1, t.end());
        if (area == 0) {
            error = fault(tin.triangles.size(), "has no area, or too little beside what all span");
            return false;
        }
        doubled_area += double(area);
        tin.triangles.push_back({{t[0], t[1], t[2]}, {-1, -1, -1}});
    }
    if (tin.triangles.empty()) {
        error = "ddt: there are no triangles";
        return false;
    }
    tin.pixel = float(1.0 / std::sqrt(doubled_area / double(tin.triangles.size())));
    return true;
}

/// A side by what it is sorted by: its midpoint; then the two sides of an edge are neighbours.
/// (Different edges of a triangulation with the same midpoint would cross.)
struct Sorted {
    uint64_t midpoint;
    uint32_t number; ///< 3 * triangle + corner
};

Side side_of(const Tin& tin, uint32_t number) {
    const int32_t triangle = int32_t(number / 3), k = int32_t(number % 3);
    const Tin::Triangle& t = tin.triangles[size_t(triangle)];
    const int32_t p = t.vertex[k], q = t.vertex[(k + 1) % 3];
    const bool forwards = before(tin.vertices[size_t(p)].at, tin.vertices[size_t(q)].at);
    return {forwards ? p : q, forwards ? q : p, triangle, k, forwards};
}

std::vector<Side> list_sides(const Tin& tin) {
    std::vector<Sorted> sorted;
    sorted.reserve(3 * tin.triangles.size());
    for (uint32_t t = 0; t < tin.triangles.size(); ++t)
        for (uint32_t k = 0; k < 3; ++k) {
            const Tin::Triangle& triangle = tin.triangles[t];
            const Steps a = tin.vertices[size_t(triangle.vertex[k])].at,
                        b = tin.vertices[size_t(triangle.vertex[(k + 1) % 3])].at;
            sorted.push_back(
                {uint64_t(uint32_t(a.y) + uint32_t(b.y)) << 32 | (uint32_t(a.x) + uint32_t(b.x)),
                 3 * t + k});
        }
    std::sort(sorted.begin(), sorted.end(), [](const Sorted& s, const Sorted& t) {
        return s.midpoint != t.midpoint ? s.midpoint < t.midpoint : s.number < t.number;
    });
    std::vector<Side> sides;
    sides.reserve(sorted.size());
    for (size_t begin = 0, end = 0; begin < sorted.size(); begin = end) {
        for (; end < sorted.size() && sorted[end].midpoint == sorted[begin].midpoint; ++end)
            sides.push_back(side_of(tin, sorted[end].number));
        std::sort(sides.begin() + std::ptrdiff_t(begin), sides.end(),
                  [](const Side& s, const Side& t) {
                      return std::array<int32_t, 3>{s.first, s.second, !s.forwards} <
                             std::array<int32_t, 3>{t.first, t.second, !t.forwards};
                  });
    }
    return sides;
}

} // namespace

bool check_vertices(const std::vector<std::array<int32_t, 3>>& triangles, size_t vertices,
                    std::string& error) {
    for (size_t i = 0; i < triangles.size(); ++i)
        for (const int32_t v : triangles[i])
            if (v < 0 || size_t(v) >= vertices) {
                error = fault(i, "has the vertex " + std::to_string(v) + "; there are 0 to " +
                                     std::to_string(int64_t(vertices) - 1));
                return false;
            }
    return true;
}

std::vector<uint8_t> corners_of(const std::vector<std::array<int32_t, 3>>& triangles,
                                size_t vertices) {
    std::vector<uint8_t> is_corner(vertices, 0);
    for (const auto& triangle : triangles)
        for (const int32_t v : triangle)
            is_corner[size_t(v)] = 1;
    return is_corner;
}

bool connect(Tin& tin, const std::vector<std::array<int32_t, 3>>& triangles, std::string& error) {
    if (!check_vertices(triangles, tin.vertices.size(), error) ||
        !list_triangles(tin, triangles, error))
        return false;
    const std::vector<Side> sides = list_sides(tin);
    tin.edges.clear();
    tin.edges.reserve(sides.size() / 2 + 1);
    for (size_t i = 0; i < sides.size(); ++i) {
        const Side& s = sides[i];
        const bool fresh =
            i == 0 || sides[i - 1].first != s.first || sides[i - 1].second != s.second;
        if (fresh)
            tin.edges.emplace_back();
        Tin::Edge& e = tin.edges.back();
        int32_t& own = s.forwards ? e.left : e.right;
        if (own >= 0) {
            error = fault(size_t(s.triangle), "lies over another at one of its edges");
            return false;
        }
        own = s.triangle;
        tin.triangles[size_t(s.triangle)].edge[s.corner] = int32_t(tin.edges.size() - 1);
    }
    return true;
}

void flip(Tin& tin, int m) {
    const TinQuad q(tin, m);
    const Tin::Edge e = tin.edges[size_t(m)];
    tin.triangles[size_t(e.left)] = {{q.d, q.c, q.a}, {m, q.ac, q.da}};
    tin.triangles[size_t(e.right)] = {{q.c, q.d, q.b}, {m, q.bd, q.cb}};
    // cb and da have changed triangles.
    Tin::Edge& cb = tin.edges[size_t(q.cb)];
    (cb.left == e.left ? cb.left : cb.right) = e.right;
    Tin::Edge& da = tin.edges[size_t(q.da)];
    (da.left == e.right ? da.left : da.right) = e.left;
}

} // namespace ddt
