// SPDX-License-Identifier: Apache-2.0
// A lattice's triangles, enumerated slowly.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <vector>

#include "core/lattice/lattice.h"
#include "core/lattice/locate.h"

namespace ddt::test {

struct Pixel {
    int x = 0, y = 0;
    bool operator==(Pixel o) const { return x == o.x && y == o.y; }
    bool operator!=(Pixel o) const { return !(*this == o); }
    /// Address order.
    bool operator<(Pixel o) const { return y != o.y ? y < o.y : x < o.x; }
    Pixel operator-(Pixel o) const { return {x - o.x, y - o.y}; }
    Pixel operator+(Pixel o) const { return {x + o.x, y + o.y}; }
};

inline int64_t det(Pixel v, Pixel w) {
    return int64_t(v.x) * w.y - int64_t(v.y) * w.x;
}

/// Vertices in pixels; det(p1 - p0, p2 - p0) = 1, the smallest address first.
using Face = std::array<Pixel, 3>;

inline Face make_face(Pixel a, Pixel b, Pixel c) {
    Face f{a, b, c};
    if (det(b - a, c - a) < 0)
        std::swap(f[1], f[2]);
    std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
    return f;
}

/// Ends and apexes of the edge at a site, in pixels.
struct EdgeView {
    Pixel a, b, left, right;
    bool has_left, has_right;
};
inline EdgeView view(const Lattice& lattice, int site) {
    const Edge& e = lattice.edge(site);
    const int x = site % lattice.stride(), y = site / lattice.stride();
    const auto at = [&](int dx, int dy) { return Pixel{(x + dx) / 2, (y + dy) / 2}; };
    return {at(-e.v.x, -e.v.y),           at(e.v.x, e.v.y), at(e.left.x, e.left.y),
            at(e.right().x, e.right().y), !e.left.zero(),   !e.right().zero()};
}

/// All triangles of a lattice, each once.
inline std::vector<Face> faces_of(const Lattice& lattice) {
    std::vector<Face> faces;
    lattice.each_edge([&](int m) {
        const EdgeView e = view(lattice, m);
        if (e.has_left)
            faces.push_back(make_face(e.a, e.b, e.left));
        if (e.has_right)
            faces.push_back(make_face(e.a, e.b, e.right));
    });
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
}

/// Sites of a triangle's edges.
inline std::set<int> sides_of(const Lattice& lattice, const Face& face) {
    std::set<int> sides;
    for (size_t k = 0; k < 3; ++k) {
        const Pixel sum = face[k] + face[(k + 1) % 3];
        sides.insert(lattice.site(sum.x, sum.y));
    }
    return sides;
}

/// The triangles at most `steps` away from the two at the edge m, a step over a side each; by
/// breadth first.
inline std::vector<Face> slow_surroundings(const Lattice& lattice, const std::vector<Face>& faces,
                                           int m, int steps) {
    std::set<int> edges{m};
    std::vector<Face> near;
    for (int i = 0; i <= steps; ++i) {
        near.clear();
        std::set<int> more;
        for (const Face& f : faces) {
            std::set<int> sides = sides_of(lattice, f);
            if (std::none_of(sides.begin(), sides.end(), [&](int s) { return edges.count(s); }))
                continue;
            near.push_back(f);
            more.merge(sides);
        }
        edges.merge(more);
    }
    return near;
}

/// Sites of the edges of such triangles, without m.
inline std::set<int> slow_region(const Lattice& lattice, const std::vector<Face>& faces, int m,
                                 int steps) {
    std::set<int> edges;
    for (const Face& f : slow_surroundings(lattice, faces, m, steps))
        edges.merge(sides_of(lattice, f));
    edges.erase(m);
    return edges;
}

/// The triangle that holds p + (t, t^2) for a tiny t > 0, found by looking at all; -1 if that point
/// is outside the hull. p in 2^-16 pixel. With t = 2^-10 of 2^-16 pixel in exact integers; no edge
/// is as long as 2^10, so no smaller t decides otherwise.
inline int find_face(const std::vector<Face>& faces, Point p) {
    constexpr int64_t scale = int64_t(1) << 20, t = int64_t(1) << 10;
    const int64_t x = p.x * scale + t, y = p.y * scale + 1;
    for (size_t i = 0; i < faces.size(); ++i) {
        bool inside = true;
        for (size_t k = 0; k < 3 && inside; ++k) {
            const Pixel a = faces[i][k], d = faces[i][(k + 1) % 3] - a;
            inside =
                d.x * (y - a.y * position_one * scale) > d.y * (x - a.x * position_one * scale);
        }
        if (inside)
            return int(i);
    }
    return -1;
}

/// The face that a Triangle describes.
inline Face face_of_triangle(const Lattice& lattice, const Triangle& t) {
    Face f;
    for (size_t i = 0; i < 3; ++i)
        f[i] = {t.vertex[i] % lattice.stride() / 2, t.vertex[i] / lattice.stride() / 2};
    return f;
}

} // namespace ddt::test
