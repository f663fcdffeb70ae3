// SPDX-License-Identifier: Apache-2.0
// A slow, obvious triangulation and two flipping schemes on it: a map of edges; apexes found by
// looking for common neighbours; every gain computed again in every iteration.
//
// Only the arithmetic of one gain is the library's own (scalar::flip_gain), since its last bits
// decide ties; it has tests of its own.
#pragma once

#include <map>
#include <set>

#include "core/triangulate/gain.h"
#include "tests/core/helpers.h"

namespace ddt::test {

class SlowMesh {
public:
    /// a, b of an edge in the direction it is stored in.
    struct Ends {
        Pixel a, b;
    };

    /// The same mesh as a lattice's.
    SlowMesh(const Lattice& lattice, Cost cost) : m_width(lattice.width()), m_cost(cost) {
        m_near.resize(size_t(lattice.width() * lattice.height()));
        for (int y = 0; y < lattice.height(); ++y)
            for (int x = 0; x < lattice.width(); ++x)
                m_guide.push_back(lattice.guide(lattice.vertex_site(x, y)));
        lattice.each_edge([&](int m) {
            const EdgeView e = view(lattice, m);
            add({e.a, e.b});
        });
    }

    /// Doubled midpoints; their order is that of the addresses.
    std::vector<Pixel> edges() const {
        std::vector<Pixel> all;
        for (const auto& e : m_edges)
            all.push_back(e.first);
        return all;
    }
    Ends ends(Pixel m) const { return m_edges.at(m); }

    /// The apex of a b on its left (det > 0).
    bool apex(Pixel a, Pixel b, Pixel& c) const {
        for (const Pixel p : near(a))
            if (near(b).count(p) && det(b - a, p - a) == 1) {
                c = p;
                return true;
            }
        return false;
    }

    bool flippable(Pixel m) const {
        const Ends e = ends(m);
        Pixel c, d;
        if (!apex(e.a, e.b, c) || !apex(e.b, e.a, d) || c + d != m)
            return false;
        return std::max(std::abs(c.x - d.x), std::abs(c.y - d.y)) <= longest_edge;
    }

    void flip(Pixel m) {
        const Ends e = ends(m);
        Pixel c, d;
        apex(e.a, e.b, c);
        apex(e.b, e.a, d);
        near(e.a).erase(e.b);
        near(e.b).erase(e.a);
        m_edges.erase(m);
        add({d, c}); // the direction that Lattice::flip says: v becomes L
    }

    float gain(Pixel m) const {
        const Ends e = ends(m);
        Pixel c, d;
        apex(e.a, e.b, c);
        apex(e.b, e.a, d);
        const Pixel v = e.b - e.a, w = c - e.a;
        scalar::Neighbourhood<float> n;
        n.vx = float(v.x);
        n.vy = float(v.y);
        n.wx = float(w.x);
        n.wy = float(w.y);
        n.za = z(e.a);
        n.zb = z(e.b);
        n.zc = z(c);
        n.zd = z(d);
        const Pixel round[5] = {e.a, c, e.b, d, e.a};
        for (size_t k = 0; k < 4; ++k) {
            Pixel o;
            if (apex(round[k], round[k + 1], o))
                n.outer[k] = {float((o - round[k]).x), float((o - round[k]).y), z(o), 1.0f};
            else
                n.outer[k] = {0.0f, 0.0f, 0.0f, 0.0f};
        }
        return dispatch(m_cost, [&](auto c2) { return scalar::flip_gain<decltype(c2)>(n); });
    }

    /// Edges of the triangles that share a side with the two at m, without m.
    std::set<Pixel> region(Pixel m) const {
        std::set<Pixel> all;
        const Ends e = ends(m);
        for (const bool turn : {false, true}) {
            const Pixel a = turn ? e.b : e.a, b = turn ? e.a : e.b;
            Pixel c, o;
            if (!apex(a, b, c))
                continue;
            all.insert({a + c, c + b});
            if (apex(a, c, o))
                all.insert({a + o, o + c});
            if (apex(c, b, o))
                all.insert({c + o, o + b});
        }
        return all;
    }

    /// The cost of the mesh in double, from the formulas in cost-inl.h.
    double total_cost() const {
        double sum = 0;
        for (const auto& [m, e] : m_edges) {
            Pixel c, d;
            if (!apex(e.a, e.b, c) || !apex(e.b, e.a, d))
                continue;
            const auto g = gradient(e.a, e.b, c), h = gradient(e.a, e.b, d);
            const double s = m_cost == Cost::abn ? double(0.2f) * double(0.2f) : 0.0;
            const double gg = g[0] * g[0] + g[1] * g[1] + s, hh = h[0] * h[0] + h[1] * h[1] + s;
            const double gh = g[0] * h[0] + g[1] * h[1] + s;
            sum += m_cost == Cost::abn ? 1.0 - gh / std::sqrt(gg * hh) : std::sqrt(gg * hh) - gh;
        }
        return sum;
    }

    /// As records() of a lattice.
    std::vector<int> records() const {
        std::vector<int> r;
        for (const auto& [m, e] : m_edges) {
            r.insert(r.end(), {e.b.x - e.a.x, e.b.y - e.a.y});
            for (const bool left : {true, false}) {
                Pixel c;
                if (left ? apex(e.a, e.b, c) : apex(e.b, e.a, c))
                    r.insert(r.end(), {2 * c.x - m.x, 2 * c.y - m.y});
                else
                    r.insert(r.end(), {0, 0});
            }
        }
        return r;
    }

private:
    std::set<Pixel>& near(Pixel p) { return m_near[size_t(p.y * m_width + p.x)]; }
    const std::set<Pixel>& near(Pixel p) const { return m_near[size_t(p.y * m_width + p.x)]; }
    float z(Pixel p) const { return m_guide[size_t(p.y * m_width + p.x)]; }
    void add(Ends e) {
        m_edges[e.a + e.b] = e;
        near(e.a).insert(e.b);
        near(e.b).insert(e.a);
    }
    /// By Cramer's rule.
    std::array<double, 2> gradient(Pixel a, Pixel b, Pixel c) const {
        const double area = double(det(b - a, c - a));
        const double db = double(z(b)) - double(z(a)), dc = double(z(c)) - double(z(a));
        return {(db * (c - a).y - dc * (b - a).y) / area, (dc * (b - a).x - db * (c - a).x) / area};
    }

    int m_width;
    Cost m_cost;
    std::vector<float> m_guide;
    std::map<Pixel, Ends> m_edges;
    std::vector<std::set<Pixel>> m_near;
};

struct SlowCounts {
    int64_t evaluations = 0, flips = 0;
    int iterations = 0;
};

/// An iteration flips every edge that gains more than min_gain and is the best of its 2-region.
inline SlowCounts slow_one_round(SlowMesh& mesh, float min_gain, int max_iterations) {
    SlowCounts counts;
    auto touched = mesh.edges();
    while (counts.iterations < max_iterations) {
        std::map<Pixel, float> gain;
        for (const Pixel m : mesh.edges())
            if (mesh.flippable(m))
                gain[m] = mesh.gain(m);
        for (const Pixel m : touched)
            counts.evaluations += int64_t(gain.count(m));
        std::vector<Pixel> selected;
        for (const auto& [m, own] : gain) {
            bool best = own > min_gain;
            for (const Pixel other : mesh.region(m)) {
                const auto g = gain.find(other);
                if (g != gain.end() && (g->second > own || (g->second == own && other < m)))
                    best = false;
            }
            if (best)
                selected.push_back(m);
        }
        if (selected.empty())
            break;
        std::set<Pixel> again(selected.begin(), selected.end());
        for (const Pixel m : selected)
            again.merge(mesh.region(m));
        touched.assign(again.begin(), again.end());
        for (const Pixel m : selected)
            mesh.flip(m);
        counts.flips += int64_t(selected.size());
        ++counts.iterations;
    }
    return counts;
}

/// Sweeps in address order, flipping whatever gains more than min_gain at once.
inline SlowCounts slow_lawson(SlowMesh& mesh, float min_gain, int max_sweeps) {
    SlowCounts counts;
    for (bool again = true; again && counts.iterations < max_sweeps; ++counts.iterations) {
        again = false;
        for (const Pixel m : mesh.edges()) {
            if (!mesh.flippable(m))
                continue;
            ++counts.evaluations;
            if (mesh.gain(m) > min_gain) {
                mesh.flip(m);
                ++counts.flips;
                again = true;
            }
        }
    }
    return counts;
}

} // namespace ddt::test
