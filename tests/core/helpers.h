// SPDX-License-Identifier: Apache-2.0
// What several tests share: random numbers and pictures, a slow enumeration of a lattice's
// triangles, positions worth trying, and running code on every instruction set.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/float_bits.h"
#include "core/base/vectors/gathers.h"
#include "core/lattice/lattice.h"
#include "core/lattice/locate.h"
#include "core/surface/edge_maker.h"
#include "ddt/core.h"
#include "tests/core/plain.h"
#include "tests/core/random.h"
#include "tests/use_simd.h"

namespace ddt::test {

using ddt::bits_of;
using ddt::float_of;

constexpr Cost all_costs[] = {
#define DDT_COST(name, ...) Cost::name,
    DDT_COSTS(DDT_COST)
#undef DDT_COST
};

constexpr Scheme all_schemes[] = {
#define DDT_SCHEME(name, ...) Scheme::name,
    DDT_SCHEMES(DDT_SCHEME)
#undef DDT_SCHEME
};

inline constexpr Surface both_surfaces[] = {Surface::linear, Surface::patch};

/// Both surfaces with so many rounds of correction each, with and without soft edges; where one
/// round is among them, fitted vertices and bends too.
inline std::vector<SurfaceOptions> surfaces_with(std::initializer_list<int> rounds) {
    std::vector<SurfaceOptions> all;
    for (const Surface kind : both_surfaces)
        for (const int consistency : rounds)
            for (const float soft : {0.0f, 0.3f}) {
                SurfaceOptions s = plain_surface(kind);
                s.consistency = consistency;
                s.soft = soft;
                all.push_back(s);
                s.fitted = kind == Surface::patch && consistency == 1;
                if (s.fitted)
                    all.push_back(s);
            }
    return all;
}

/// All edges of a part at once: see EdgeMaker.
inline void make_edges(const Lattice& lattice, const Rect& part, bool bend, bool soft, float tau,
                       EdgeMaker& edges, ControlNet& net) {
    edges.begin(lattice, part, bend, soft, tau, net);
    edges.finish();
}

/// How many floats differ in any bit; all of them if the sizes do.
inline size_t differing(const std::vector<float>& a, const std::vector<float>& b) {
    if (a.size() != b.size())
        return std::max(a.size(), b.size());
    size_t n = 0;
    for (size_t i = 0; i < a.size(); ++i)
        n += bits_of(a[i]) != bits_of(b[i]);
    return n;
}

/// Kinds of guide. `few` has three levels only, so gains tie all over.
enum class Kind { noise, few, flat, shapes };
constexpr Kind all_kinds[] = {Kind::noise, Kind::few, Kind::flat, Kind::shapes};

/// A guide, multiples of 2^-12 about in [0, 1]. `shapes` are half planes, discs and slopes with a
/// little noise, something like a photograph. Integer arithmetic only: the same everywhere.
inline std::vector<float> make_guide(Kind kind, int width, int height, uint64_t seed) {
    Random random(seed);
    struct Shape {
        int x, y, nx, ny, radius, level;
    };
    std::vector<Shape> shapes(size_t(3 + width * height / 400));
    for (Shape& s : shapes)
        s = {random.below(width),   random.below(height),  random.between(-9, 9),
             random.between(-9, 9), random.between(1, 12), random.below(4000)};
    std::vector<float> guide;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            int level = 0;
            switch (kind) {
            case Kind::noise:
                level = random.below(4097);
                break;
            case Kind::few:
                level = 2048 * random.below(3);
                break;
            case Kind::flat:
                level = 1234;
                break;
            case Kind::shapes:
                level = (7 * x + 3 * y) % 3000;
                for (const Shape& s : shapes) {
                    const int dx = x - s.x, dy = y - s.y;
                    if (dx * dx + dy * dy < s.radius * s.radius && dx * s.nx + dy * s.ny > -20)
                        level = s.level + 5 * dx;
                }
                level += random.below(40);
                break;
            }
            guide.push_back(float(level) * (1.0f / 4096.0f));
        }
    return guide;
}

/// A number of pixel values' size.
inline float random_value(Random& random) {
    return random.unit();
}
/// A number from 1e-3 to 1e4, every decade as often.
inline float random_hdr(Random& random) {
    return float(std::pow(10.0, -3.0 + 7.0 * double(random.unit())));
}
/// A number of any sign and size that a float can be, up to 1e38.
inline float random_wild(Random& random) {
    const double x = std::pow(10.0, -46.0 + 84.0 * double(random.unit()));
    return float(random.below(2) ? x : -x);
}

template <class F>
std::vector<float> fill(size_t n, F&& f) {
    std::vector<float> v(n);
    for (float& x : v)
        x = f();
    return v;
}

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

/// The whole of a mesh's edges as numbers, to compare meshes record by record. The direction an
/// edge is stored in counts too: the last bit of a gain may depend on it.
inline std::vector<int> records(const Lattice& lattice) {
    std::vector<int> r;
    lattice.each_edge([&](int m) {
        const Edge& e = lattice.edge(m);
        for (const Vec v : {e.v, e.left, e.right()})
            r.insert(r.end(), {v.x, v.y});
    });
    return r;
}

inline std::vector<int> flippable_edges(const Lattice& lattice) {
    std::vector<int> sites;
    lattice.each_edge([&](int m) {
        if (lattice.edge(m).flippable())
            sites.push_back(m);
    });
    return sites;
}

inline void flip_at_random(Lattice& lattice, int times, Random& random) {
    for (int i = 0; i < times; ++i) {
        const auto sites = flippable_edges(lattice);
        if (sites.empty())
            return;
        lattice.flip(sites[size_t(random.below(int(sites.size())))]);
    }
}

/// Flip until the mesh's edges are as long as they may be: a fan across the whole width (height).
inline void flip_to_longest(Lattice& lattice) {
    for (bool again = true; again;) {
        again = false;
        for (const int m : flippable_edges(lattice)) {
            const Edge& e = lattice.edge(m);
            // Only lengthen those that lean to one side, so that they do not hold each other up.
            const Vec l = e.left.x + e.left.y < 0 ? -e.left : e.left;
            const Vec v = e.v.x + e.v.y < 0 ? -e.v : e.v;
            if (e.flippable() && l.x + l.y > v.x + v.y) {
                lattice.flip(m);
                again = true;
            }
        }
    }
}

/// Whether the records make a triangulation: every triangle unimodular, each neighbour's record
/// telling of the same triangle, the whole hull covered.
inline ::testing::AssertionResult is_triangulation(const Lattice& lattice) {
    const int right = 2 * lattice.width() - 2, bottom = 2 * lattice.height() - 2;
    const auto is_vertex = [&](Pixel p) {
        return p.x >= 0 && p.y >= 0 && p.x <= right && p.y <= bottom && p.x % 2 == 0 &&
               p.y % 2 == 0;
    };
    int64_t sides = 0;
    for (int y = 0; y <= bottom; ++y)
        for (int x = 0; x <= right; ++x) {
            if (x % 2 == 0 && y % 2 == 0)
                continue;
            const auto fail = [&](const char* why) {
                return ::testing::AssertionFailure()
                       << why << " at the edge with midpoint (" << x << ", " << y << ")/2";
            };
            const Edge& e = lattice.edge(lattice.site(x, y));
            const Pixel a{x - e.v.x, y - e.v.y}, b{x + e.v.x, y + e.v.y};
            if (!is_vertex(a) || !is_vertex(b) || a == b)
                return fail("ends are no pixels");
            if (std::abs(e.v.x) > longest_edge || std::abs(e.v.y) > longest_edge)
                return fail("too long");
            for (const int sign : {1, -1}) {
                const Vec apex = sign > 0 ? e.left : e.right();
                // Nothing of the hull lies on this side of an edge along the rim.
                const int nx = -e.v.y * sign, ny = e.v.x * sign;
                const bool rim =
                    (a.x == b.x && a.x == 0 && nx < 0) || (a.x == b.x && a.x == right && nx > 0) ||
                    (a.y == b.y && a.y == 0 && ny < 0) || (a.y == b.y && a.y == bottom && ny > 0);
                if (rim != apex.zero())
                    return fail(rim ? "an apex outside the hull" : "no apex within the hull");
                if (rim)
                    continue;
                const Pixel c{x + apex.x, y + apex.y};
                if (!is_vertex(c))
                    return fail("the apex is no pixel");
                if (det(b - a, c - a) != 4 * sign)
                    return fail("triangle not unimodular, or the apex on the wrong side");
                for (const bool which : {false, true}) {
                    const Pixel end = which ? b : a, other = which ? a : b;
                    const int mx = (end.x + c.x) / 2, my = (end.y + c.y) / 2;
                    const Edge& f = lattice.edge(lattice.site(mx, my));
                    const Pixel half{end.x - mx, end.y - my}, v{f.v.x, f.v.y};
                    if (half != v && half != Pixel{-v.x, -v.y})
                        return fail("a triangle's other edge does not exist");
                    const Pixel back{other.x - mx, other.y - my};
                    if (back != Pixel{f.left.x, f.left.y} &&
                        back != Pixel{f.right().x, f.right().y})
                        return fail("a triangle's other edge does not point back");
                }
                ++sides;
            }
        }
    // Three sides a triangle, each of area 1/2.
    if (sides != 3 * int64_t(right / 2) * bottom)
        return ::testing::AssertionFailure() << "the triangles do not cover the hull once";
    return ::testing::AssertionSuccess();
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

/// Positions where something may go wrong, and random ones: vertices, points on edges, the rim,
/// next to all of these, anywhere.
inline std::vector<Point> make_points(const Lattice& lattice, int n, Random& random) {
    const int right = (lattice.width() - 1) * position_one;
    const int bottom = (lattice.height() - 1) * position_one;
    std::vector<int> edges;
    lattice.each_edge([&](int m) { edges.push_back(m); });
    std::vector<Point> points;
    for (int i = 0; i < n; ++i) {
        Point p{int32_t(random.bits() % uint64_t(right + 1)),
                int32_t(random.bits() % uint64_t(bottom + 1))};
        switch (i % 6) {
        case 0:
            p = {p.x & -position_one, p.y & -position_one};
            break;
        case 1:
        case 2: {
            // A point on an edge whose coordinates are multiples of 2^-16: k/2^j of the way.
            const EdgeView e = view(lattice, edges[size_t(random.below(int(edges.size())))]);
            const int j = random.between(1, 10), k = random.between(0, 1 << j);
            p = {e.a.x * position_one + ((e.b.x - e.a.x) * (position_one >> j)) * k,
                 e.a.y * position_one + ((e.b.y - e.a.y) * (position_one >> j)) * k};
            break;
        }
        case 3:
            (i % 4 < 2 ? p.x : p.y) = i % 8 < 4 ? 0 : (i % 4 < 2 ? right : bottom);
            break;
        default:
            break;
        }
        if (i % 6 == 2) {
            p.x = std::clamp(p.x + random.between(-1, 1), 0, right);
            p.y = std::clamp(p.y + random.between(-1, 1), 0, bottom);
        }
        points.push_back(p);
    }
    return points;
}

/// Call f for every instruction set that was compiled and this machine has, and for what is there
/// for machines with none of them, with gathers and without.
template <class F>
void on_each_target(F&& f) {
    const bool quick = gathers_are_quick();
    auto targets = hwy::SupportedAndGeneratedTargets();
    if (std::find(targets.begin(), targets.end(), HWY_STATIC_TARGET) == targets.end())
        targets.push_back(HWY_STATIC_TARGET);
    for (const int64_t target : targets) {
        use_simd(target);
        SCOPED_TRACE(hwy::TargetName(target));
        for (const bool gathers : {quick, !quick}) {
            SCOPED_TRACE(gathers ? "gathers" : "loads");
            set_gathers_are_quick(gathers);
            f();
        }
    }
    set_gathers_are_quick(quick);
    use_simd(0);
}

} // namespace ddt::test
