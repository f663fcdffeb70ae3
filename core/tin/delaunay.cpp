// SPDX-License-Identifier: Apache-2.0
// By exact arithmetic, whatever shape the points have together. (Lawson, "Software for C1 surface
// interpolation", 1977: a sweep, and flips wherever a circle is not empty; from the middle outwards
// and with the rim in a table of angles, Sinclair, "S-hull", 2016.)
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/tin/delaunay.h"

namespace ddt {

namespace {

using Wide = __int128;

/// Positive if d lies within the circle through a, b and c, which have positive orientation.
/// Positions are within 2^30: 124 bits.
Wide within_circle(Steps a, Steps b, Steps c, Steps d) {
    struct Way {
        int64_t x, y;
        int64_t square() const { return x * x + y * y; }
    };
    const auto from_d = [&](Steps p) { return Way{int64_t(p.x) - d.x, int64_t(p.y) - d.y}; };
    const auto det = [](Way p, Way q) { return p.x * q.y - p.y * q.x; };
    const Way p = from_d(a), q = from_d(b), r = from_d(c);
    return Wide(det(p, q)) * r.square() + Wide(det(q, r)) * p.square() +
           Wide(det(r, p)) * q.square();
}

/// Bits that depend on all of x's. (Mueller's integer hash, 2012.)
uint32_t hashed(uint32_t x) {
    x = (x ^ x >> 16) * 0x45d9f3bu;
    x = (x ^ x >> 16) * 0x45d9f3bu;
    return x ^ x >> 16;
}

/// An angle by its way, from 0 to less than 1 once round.
double turn_of(double x, double y) {
    const double share = x / (std::abs(x) + std::abs(y)); // 1 to -1 over half a turn
    return (y < 0 ? 3 + share : 1 - share) / 4;
}

/// Half-edge h belongs to triangle h / 3 and goes from corner[h] to corner[next(h)], the triangle
/// to its left.
class Sweep {
public:
    Sweep(const std::vector<Steps>& points, Ties ties)
        : m_points(points), m_ties(ties), m_next(points.size(), -1), m_previous(points.size(), -1),
          m_rim(points.size(), -1), m_at_angle(size_t(std::sqrt(double(points.size()))) + 1, -1) {}

    bool triangulate(const ProgressCallback& progress) {
        constexpr size_t told_each = 1024;
        const std::vector<int32_t> order = outwards();
        for (size_t i = begin(order); i < order.size(); ++i) {
            if (progress && i % told_each == 0 && !progress(float(i) / float(order.size())))
                return false;
            insert(order[i]);
        }
        return true;
    }

    std::vector<std::array<int32_t, 3>> triangles() const {
        std::vector<std::array<int32_t, 3>> all;
        all.reserve(m_corner.size() / 3);
        for (size_t h = 0; h < m_corner.size(); h += 3)
            all.push_back({m_corner[h], m_corner[h + 1], m_corner[h + 2]});
        return all;
    }

private:
    static int32_t next(int32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
    static int32_t previous(int32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
    Steps at(int32_t v) const { return m_points[size_t(v)]; }
    int32_t& corner(int32_t h) { return m_corner[size_t(h)]; }
    int64_t turn(int32_t u, int32_t v, int32_t w) const { return orientation(at(u), at(v), at(w)); }

    /// The order of insertion: none lies within the hull of those before it, which are no farther
    /// from the middle. In a hull so round each sees few of the rim's edges.
    std::vector<int32_t> outwards() {
        Steps least = at(0), most = at(0);
        for (const Steps p : m_points) {
            least = {std::min(least.x, p.x), std::min(least.y, p.y)};
            most = {std::max(most.x, p.x), std::max(most.y, p.y)};
        }
        const auto middle = [](int32_t a, int32_t b) {
            return int32_t((int64_t(a) + int64_t(b)) / 2);
        };
        m_middle = {middle(least.x, most.x), middle(least.y, most.y)};
        std::vector<std::pair<int64_t, int32_t>> far;
        for (int32_t v = 0; v < int32_t(m_points.size()); ++v) {
            const int64_t x = int64_t(at(v).x) - m_middle.x, y = int64_t(at(v).y) - m_middle.y;
            far.push_back({x * x + y * y, v});
        }
        std::sort(far.begin(), far.end());
        std::vector<int32_t> order;
        for (const auto& [square, v] : far)
            order.push_back(v);
        return order;
    }

    /// A triangle without neighbours; returns its first half-edge.
    int32_t add(int32_t u, int32_t v, int32_t w) {
        const auto h = int32_t(m_corner.size());
        m_corner.insert(m_corner.end(), {u, v, w});
        m_twin.insert(m_twin.end(), {-1, -1, -1});
        return h;
    }

    /// Say what lies beyond h: half-edge `twin`, or nothing where it is -1.
    void join(int32_t h, int32_t twin) {
        m_twin[size_t(h)] = twin;
        if (twin >= 0)
            m_twin[size_t(twin)] = h;
        else
            m_rim[size_t(corner(h))] = h;
    }

    /// Have v come after u on the rim, along h.
    void follow(int32_t u, int32_t v, int32_t h) {
        m_next[size_t(u)] = v;
        m_previous[size_t(v)] = u;
        join(h, -1);
    }

    /// The first points that are on one line, and triangles from there to the first beside it.
    /// Returns how many points those are.
    size_t begin(const std::vector<int32_t>& order) {
        size_t n = 2;
        while (turn(order[0], order[1], order[n]) == 0)
            ++n;
        const int32_t p = order[n];
        std::vector<int32_t> line(order.begin(), order.begin() + ptrdiff_t(n));
        std::sort(line.begin(), line.end()); // points are sorted
        if (turn(line[0], line[1], p) < 0)
            std::reverse(line.begin(), line.end());
        int32_t beside = -1; // from p to line[i]
        for (size_t i = 0; i + 1 < n; ++i) {
            const int32_t h = add(line[i], line[i + 1], p);
            follow(line[i], line[i + 1], h);
            if (i == 0)
                follow(p, line[0], h + 2);
            else
                join(h + 2, beside);
            beside = h + 1;
        }
        follow(line[n - 1], p, beside);
        m_last = p;
        return n + 1;
    }

    /// The table's entry for points at p's angle.
    size_t angle_of(int32_t p) const {
        const double turns = turn_of(double(at(p).x) - m_middle.x, double(at(p).y) - m_middle.y);
        const auto entries = double(m_at_angle.size());
        // The middle itself, which has no angle, is on the rim at the beginning at most.
        return turns >= 0 ? size_t(std::min(turns * entries, entries - 1)) : 0;
    }

    /// A vertex of the rim near p's angle.
    int32_t rim_near(int32_t p) const {
        const size_t own = angle_of(p), entries = m_at_angle.size();
        for (size_t k = 0; k <= entries / 2; ++k)
            for (const size_t at : {(own + k) % entries, (own + entries - k) % entries})
                if (const int32_t v = m_at_angle[at]; v >= 0 && m_next[size_t(v)] >= 0)
                    return v;
        return m_last;
    }

    bool is_seen(int32_t u, int32_t p) const { return turn(u, m_next[size_t(u)], p) < 0; }

    /// The beginning of a rim edge that p sees, looked for to both sides.
    int32_t seen_by(int32_t p) const {
        int32_t u = rim_near(p), v = u;
        for (;;) {
            if (is_seen(u, p))
                return u;
            v = m_previous[size_t(v)];
            if (is_seen(v, p))
                return v;
            u = m_next[size_t(u)];
        }
    }

    /// p lies outside the rim, of which it sees some edges that follow one another.
    void insert(int32_t p) {
        int32_t first = seen_by(p);
        int32_t last = m_next[size_t(first)];
        while (is_seen(m_previous[size_t(first)], p))
            first = m_previous[size_t(first)];
        while (is_seen(last, p))
            last = m_next[size_t(last)];
        std::vector<int32_t> doubtful;
        int32_t to_p = -1, from_p = -1; // of first; of the vertex that was come to
        for (int32_t u = first; u != last; u = m_next[size_t(u)]) {
            const int32_t h = add(m_next[size_t(u)], u, p);
            join(h, m_rim[size_t(u)]);
            if (u == first)
                to_p = h + 1;
            else
                join(h + 1, from_p);
            from_p = h + 2;
            doubtful.push_back(h);
        }
        for (int32_t u = m_next[size_t(first)]; u != last;)
            u = std::exchange(m_next[size_t(u)], -1);
        follow(first, p, to_p);
        follow(p, last, from_p);
        m_last = m_at_angle[angle_of(p)] = p;
        while (!doubtful.empty()) {
            const int32_t h = doubtful.back();
            doubtful.pop_back();
            flip_if_wrong(h, doubtful);
        }
    }

    /// Whether a diagonal from p to q is made rather than one from a to b. Each such flip lowers
    /// the sum of all edges' numbers and changes no circle: so flips end.
    bool is_preferred(int32_t p, int32_t q, int32_t a, int32_t b) const {
        if (m_ties.seed != 0)
            return chance(p, q) < chance(a, b);
        return m_ties.guide && change(p, q) < change(a, b);
    }
    float change(int32_t u, int32_t v) const {
        return std::abs(m_ties.guide[size_t(u)] - m_ties.guide[size_t(v)]);
    }
    /// An edge's number by chance.
    uint32_t chance(int32_t u, int32_t v) const {
        const auto edge = std::minmax(u, v);
        return hashed(hashed(hashed(m_ties.seed) ^ uint32_t(edge.first)) ^ uint32_t(edge.second));
    }

    /// h is the side of its triangle opposite to the point that was inserted.
    void flip_if_wrong(int32_t h, std::vector<int32_t>& doubtful) {
        const int32_t t = m_twin[size_t(h)];
        if (t < 0)
            return;
        const int32_t a = corner(h), b = corner(t), p = corner(previous(h)),
                      q = corner(previous(t));
        const Wide within = within_circle(at(a), at(b), at(p), at(q));
        if (within < 0 || (within == 0 && !is_preferred(p, q, a, b)))
            return;
        const int32_t bp = m_twin[size_t(next(h))], pa = m_twin[size_t(previous(h))],
                      aq = m_twin[size_t(next(t))], qb = m_twin[size_t(previous(t))];
        const int32_t one = h / 3 * 3, other = t / 3 * 3;
        corner(one) = p, corner(one + 1) = a, corner(one + 2) = q;
        corner(other) = q, corner(other + 1) = b, corner(other + 2) = p;
        join(one, pa);
        join(one + 1, aq);
        join(one + 2, other + 2);
        join(other, qb);
        join(other + 1, bp);
        doubtful.push_back(one + 1);
        doubtful.push_back(other);
    }

    const std::vector<Steps>& m_points;
    const Ties m_ties;
    std::vector<int32_t> m_corner, m_twin; ///< a half-edge
    /// Of a vertex on the rim the vertices after and before it, and the half-edge to the next; what
    /// is not on the rim any more has -1 after it.
    std::vector<int32_t> m_next, m_previous, m_rim;
    Steps m_middle{};                ///< of the points' box
    std::vector<int32_t> m_at_angle; ///< the last vertex at each angle seen from there, or -1
    int32_t m_last = -1;             ///< the last vertex, which is on the rim
};

} // namespace

bool find_delaunay(const std::vector<Steps>& points, std::vector<std::array<int32_t, 3>>& triangles,
                   Ties ties, const ProgressCallback& progress) {
    Sweep sweep(points, ties);
    if (!sweep.triangulate(progress))
        return false;
    triangles = sweep.triangles();
    return true;
}

} // namespace ddt
