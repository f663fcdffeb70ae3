// SPDX-License-Identifier: Apache-2.0
// A triangulation of any vertices (a triangulated irregular network), as the paper holds it: an
// edge knows its two triangles; a triangle its three vertices and three edges.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace ddt {

/// A position in whole steps, 0 to most_steps: orientation is then exact in 64 bits.
struct Steps {
    int32_t x = 0, y = 0;
};
constexpr int32_t most_steps = int32_t(1) << 30;

/// The order of points, row by row: what is sorted by it is searched by it elsewhere.
inline bool before(Steps a, Steps b) {
    return a.y != b.y ? a.y < b.y : a.x < b.x;
}

/// Twice the signed area of a, b, c in steps: positive if c is to the left of a towards b. ("Left"
/// as for the Lattice.)
inline int64_t orientation(Steps a, Steps b, Steps c) {
    return int64_t(b.x - a.x) * int64_t(c.y - a.y) - int64_t(b.y - a.y) * int64_t(c.x - a.x);
}

/// Vertices, triangles and edges in flat arrays. Not for several threads at once.
struct Tin {
    struct Vertex {
        Steps at;
        float guide = 0; ///< what edges are sought in, about 0 to 1
    };
    /// Vertices with positive orientation; edge[k] is from vertex[k] to the next.
    struct Triangle {
        int32_t vertex[3];
        int32_t edge[3];
    };
    /// Its triangles, -1 on the hull's rim. The edge runs so that `left` is to its left.
    struct Edge {
        int32_t left = -1, right = -1;
    };

    std::vector<Vertex> vertices;
    std::vector<Triangle> triangles;
    /// In the order of their midpoints at the start, row by row, as in a Lattice; each keeps its
    /// index for life.
    std::vector<Edge> edges;
    /// Pixels a step, so that the triangles' mean area is half a pixel, as in a Lattice: the unit
    /// that costs, which mix lengths with the guide's values, are in.
    float pixel = 1;

    /// Which of the triangle's edges m is.
    static int corner(const Triangle& t, int m) {
        return t.edge[0] == m ? 0 : t.edge[1] == m ? 1 : 2;
    }
    /// The ends of the edge m, a first.
    std::array<int32_t, 2> ends(int m) const {
        const Edge& e = edges[size_t(m)];
        const Triangle& t = triangles[size_t(e.left >= 0 ? e.left : e.right)];
        const int k = corner(t, m), next = (k + 1) % 3;
        return e.left >= 0 ? std::array<int32_t, 2>{t.vertex[k], t.vertex[next]}
                           : std::array<int32_t, 2>{t.vertex[next], t.vertex[k]};
    }
};

/// The quad round the edge ab with triangles on both sides.
struct TinQuad {
    int32_t a, b, c, d;     ///< vertices: c left of ab, d right
    int32_t ac, cb, bd, da; ///< edges
    TinQuad(const Tin& tin, int m) {
        const Tin::Edge e = tin.edges[size_t(m)];
        const Tin::Triangle &l = tin.triangles[size_t(e.left)], &r = tin.triangles[size_t(e.right)];
        constexpr int next[] = {1, 2, 0}, last[] = {2, 0, 1};
        const int i = Tin::corner(l, m), k = Tin::corner(r, m);
        a = l.vertex[i];
        b = l.vertex[next[i]];
        c = l.vertex[last[i]];
        d = r.vertex[last[k]];
        cb = l.edge[next[i]];
        ac = l.edge[last[i]];
        da = r.edge[next[k]];
        bd = r.edge[last[k]];
    }
};

/// Whether all triangles are of vertices below `vertices`; false with one line in `error`.
bool check_vertices(const std::vector<std::array<int32_t, 3>>& triangles, size_t vertices,
                    std::string& error);

/// A 1 for each of so many vertices that is a corner of a triangle, else a 0.
std::vector<uint8_t> corners_of(const std::vector<std::array<int32_t, 3>>& triangles,
                                size_t vertices);

/// Make triangles' edges and `pixel`. `triangles` are of vertices of tin.vertices, which are in
/// 0 to most_steps; either way round. Each edge runs from its end with the smaller address (row by
/// row) to the other. False with one line in `error` if a vertex index is out of range, a triangle
/// has no area, an edge more than two triangles, or two triangles lie on the same side of an edge.
/// (Triangles that overlap without sharing an edge are not found out.)
bool connect(Tin& tin, const std::vector<std::array<int32_t, 3>>& triangles, std::string& error);

/// Flip the edge m, whose quad must be strictly convex: it then runs from d to c.
void flip(Tin& tin, int m);

} // namespace ddt
