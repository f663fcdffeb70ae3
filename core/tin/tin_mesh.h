// SPDX-License-Identifier: Apache-2.0
// A Tin whose edges are flipped: what the schemes of core/triangulate/schemes.h ask a mesh. Twin:
// Lattice.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/tin/face.h"
#include "core/tin/tin.h"
#include "core/triangulate/triangulate.h"

namespace ddt {

class TinMesh {
public:
    /// Keeps a reference to `tin`, whose edges are to be flipped by `cost`.
    TinMesh(Tin& tin, Cost cost);

    const Tin& tin() const { return m_tin; }
    Cost cost() const { return m_cost; }
    const TinFace& face(int triangle) const { return m_faces[size_t(triangle)]; }

    size_t size() const { return m_tin.edges.size(); }
    size_t edges() const { return m_tin.edges.size(); }
    size_t vertices() const { return m_tin.vertices.size(); }

    /// Whether m has a triangle on both sides and they form a strictly convex quad.
    bool flippable(int m) const {
        const Tin::Edge e = m_tin.edges[size_t(m)];
        if (e.left < 0 || e.right < 0)
            return false;
        const TinQuad q(m_tin, m);
        return orientation(at(q.d), at(q.c), at(q.a)) > 0 &&
               orientation(at(q.c), at(q.d), at(q.b)) > 0;
    }
    /// Twins of Lattice's.
    float gain(int m) const { return std::max(m_gains[size_t(m)], no_gain); }
    void set_gain(int m, float gain) { m_gains[size_t(m)] = std::max(gain, least_gain); }
    bool settled(int m) const { return m_gains[size_t(m)] > no_gain; }
    bool touch(int m) {
        constexpr float touched = -std::numeric_limits<float>::infinity();
        float& gain = m_gains[size_t(m)];
        const bool can = flippable(m), is_new = can && gain != touched;
        gain = can ? touched : no_gain;
        return is_new;
    }
    /// The edge's midpoint when this was called first, as places_of() has it.
    uint64_t place(int m, int origin_x, int origin_y) const;
    std::array<int, 4> sides(int m) const {
        const TinQuad q(m_tin, m);
        return {q.ac, q.cb, q.bd, q.da};
    }

    /// Flip the flippable edge m.
    void flip(int m);
    /// Undo the last flip of m, if no side of it was flipped since. (Which of its triangles has
    /// which index may differ.)
    void flip_back(int m);

    /// The gain of flipping the flippable edge m.
    template <class CostOfFloat>
    float gain(int m) const;

    template <class F>
    void each_edge(F&& f) const {
        for (size_t m = 0; m < size(); ++m)
            f(int(m));
    }

    /// Call f(edge) for the 2-region of the flippable edge m without m itself until it returns
    /// true. Returns whether f did.
    template <class F>
    bool any_of_region(int m, F&& f) const {
        return any_within(m, 1, f);
    }
    template <class F>
    void each_of_region(int m, F&& f) const {
        any_of_region(m, [&](int other) {
            f(other);
            return false;
        });
    }
    /// Call f(edge) for the edges of the triangles at most `rings` steps, across edges, from the
    /// two of the flippable edge m, until it returns true.
    template <class F>
    bool any_within(int m, int rings, F&& f) const {
        const TinQuad q(m_tin, m);
        const Tin::Edge e = m_tin.edges[size_t(m)];
        return any_beyond(q.ac, e.left, rings, f) || any_beyond(q.cb, e.left, rings, f) ||
               any_beyond(q.bd, e.right, rings, f) || any_beyond(q.da, e.right, rings, f);
    }

private:
    Steps at(int32_t v) const { return m_tin.vertices[size_t(v)].at; }

    /// Call f for `side` and, up to `rings` steps away, for the edges beyond it, seen from the
    /// triangle `inner`.
    template <class F>
    bool any_beyond(int side, int32_t inner, int rings, F& f) const {
        if (f(side))
            return true;
        const Tin::Edge e = m_tin.edges[size_t(side)];
        const int32_t outer = e.left == inner ? e.right : e.left;
        if (rings == 0 || outer < 0)
            return false;
        const Tin::Triangle& t = m_tin.triangles[size_t(outer)];
        for (const int32_t other : t.edge)
            if (other != side && any_beyond(other, outer, rings - 1, f))
                return true;
        return false;
    }
    void find_face(int32_t triangle);

    Tin& m_tin;
    const Cost m_cost;
    std::vector<TinFace> m_faces; ///< a triangle
    std::vector<float> m_gains;   ///< an edge
    mutable std::vector<uint64_t> m_places;
};

/// The edges' midpoints in doubled steps, as one number each.
std::vector<uint64_t> places_of(const Tin& tin, int origin_x, int origin_y);

template <class CostOfFloat>
float TinMesh::gain(int m) const {
    const Tin::Edge e = m_tin.edges[size_t(m)];
    const TinQuad q(m_tin, m);
    const auto vertex = [&](int32_t v) -> const Tin::Vertex& { return m_tin.vertices[size_t(v)]; };
    const Tin::Vertex &a = vertex(q.a), &b = vertex(q.b), &c = vertex(q.c), &d = vertex(q.d);
    const float pixel = m_tin.pixel;
    const TinFace &abc = face(e.left), &abd = face(e.right);
    const TinFace adc = scalar::face_of<CostOfFloat>(d, c, a, orientation(d.at, c.at, a.at), pixel);
    const TinFace bcd = scalar::face_of<CostOfFloat>(c, d, b, orientation(c.at, d.at, b.at), pixel);
    float before = scalar::between<CostOfFloat>(abc, abd, a.at, b.at, pixel);
    float after = scalar::between<CostOfFloat>(adc, bcd, d.at, c.at, pixel);
    const auto side = [&](int32_t s, int32_t inner, const TinFace& was, const TinFace& is,
                          Steps from, Steps to) {
        const Tin::Edge& edge = m_tin.edges[size_t(s)];
        const int32_t outer = edge.left == inner ? edge.right : edge.left;
        if (outer < 0)
            return;
        before = before + scalar::between<CostOfFloat>(face(outer), was, from, to, pixel);
        after = after + scalar::between<CostOfFloat>(face(outer), is, from, to, pixel);
    };
    side(q.ac, e.left, abc, adc, a.at, c.at);
    side(q.cb, e.left, abc, bcd, c.at, b.at);
    side(q.bd, e.right, abd, bcd, b.at, d.at);
    side(q.da, e.right, abd, adc, d.at, a.at);
    return before - after;
}

/// The region of degree 3, as of a Lattice; m itself may be among them.
template <class F>
bool any_of_wide_region(const TinMesh& mesh, int m, F&& f) {
    return mesh.any_within(m, 2, f);
}

/// Contours are those of pixels: there are none here.
template <class CostOfFloat>
float gain_of(const TinMesh& mesh, int m, float /*contour*/) {
    return mesh.gain<CostOfFloat>(m);
}

/// The cost of the whole mesh: each edge between two triangles, summed in double.
double total_cost(const TinMesh& mesh);

/// Flip edges of a Tin by options.scheme and options.cost; blur, meshes and start are not looked
/// at. Adds to `statistics`.
void triangulate(Tin& tin, const MeshOptions& options, Workspace& workspace,
                 Statistics& statistics);

} // namespace ddt
