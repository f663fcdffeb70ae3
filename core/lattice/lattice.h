// SPDX-License-Identifier: Apache-2.0
// The mesh: a triangulation whose vertices are all pixels of a rectangle.
//
// Every triangle is an empty lattice triangle, so by Pick's theorem its area is 1/2 (it is
// unimodular), and from that follow:
//  - barycentric weights and gradients need no division;
//  - edge ab with apexes c, d can be flipped if and only if a + b = c + d (a parallelogram);
//  - a flip keeps the edge's midpoint, and each half-integer point of the hull is the midpoint of
//    exactly one edge in every triangulation. The midpoint is the edge's address.
// (Kaibel & Ziegler, "Counting lattice triangulations", 2003.)
//
// All is kept in one array over the *doubled lattice*: pixel (x, y) is at (2x, 2y), an edge is at
// its midpoint, where not both coordinates are even. A Site index is y * stride + x in doubled
// coordinates, so a difference of sites is a fixed offset for a fixed vector.
//
// "Left" of a direction v is where det(v, .) > 0. (With y downwards, as in images, that is the
// right-hand side on screen; only consistency matters.)
//
// The rest of this folder, in the order in which it is used:
//   start_rows       the starting mesh, for start()
//   flips, region    flips of many edges at once; the edges near one
//   divisions        how each cell is divided once no edge flips any more. Most are "plain": their
//                    own diagonal divides them. Others are "crossed": crossed_columns.h lists them
//   first_edges      for walks round a vertex; fans: such walks for many vertices at once
//   neighbours, row_reach    how far edges go from a part of the lattice, or from a row
//   locate           the triangle of a position; crossed_cell: those of all positions in a crossed
//                    cell; crossed_search: in many crossed cells at once; crossed_rows: in those
//                    of some rows, kept
// site_lanes-inl.h, known_lanes-inl.h, every_second-inl.h: sites and edges as lanes of vectors;
// quad-inl.h: the parallelogram round an edge, for scalars and lanes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/arith.h"
#include "core/base/float_bits.h"
#include "core/base/memory/large_pages.h"
#include "ddt/rect.h"

namespace ddt {

/// A vector in doubled coordinates, or in pixels where that is said.
struct Vec {
    int8_t x = 0, y = 0;
    Vec() = default;
    Vec(int x_, int y_) : x(int8_t(x_)), y(int8_t(y_)) {}
    bool operator==(Vec o) const { return x == o.x && y == o.y; }
    bool operator!=(Vec o) const { return !(*this == o); }
    Vec operator-() const { return {-x, -y}; }
    Vec operator+(Vec o) const { return {x + o.x, y + o.y}; }
    Vec operator-(Vec o) const { return {x - o.x, y - o.y}; }
    bool zero() const { return x == 0 && y == 0; }
};

/// A vector's two bytes, x in the low one, and back.
constexpr uint32_t bytes_of(int x, int y) {
    return uint32_t((x & 255) | (y & 255) << 8);
}
inline Vec vec_of(uint32_t bytes) {
    return {int8_t(bytes & 255), int8_t(bytes >> 8 & 255)};
}

/// Of a vector with even coordinates.
inline Vec half(Vec v) {
    return {v.x / 2, v.y / 2};
}
/// 1 in the coordinates that are odd, or even, else 0.
inline Vec odd(Vec v) {
    return {v.x & 1, v.y & 1};
}
inline Vec even(Vec v) {
    return {1 - (v.x & 1), 1 - (v.y & 1)};
}

/// v.x * w.y - v.y * w.x
inline int det(Vec v, Vec w) {
    return v.x * w.y - v.y * w.x;
}

/// What tells an edge that cannot be flipped, in the upper half of Edge::word. As a float such a
/// word is less than no_gain.
constexpr uint32_t rigid_mark = 0xff7f;
/// Edge::word of an edge that can be flipped while its gain is about to be found: minus infinity.
constexpr uint32_t touched_word = 0xff800000u;
/// Both are at least this, and the words of gains are less.
constexpr uint32_t least_unsettled = rigid_mark << 16;
/// Stored gains are at least this, and NaN is stored with its sign clear: smaller floats and NaN
/// with a sign have words that encode rigid_mark and touched_word, or that settled() takes for
/// them.
constexpr float least_gain = -1e38f;

/// An edge with midpoint m, ends a = m - v and b = m + v; vectors in doubled coordinates, which
/// makes v also b - a in pixels. Apexes are relative to m; a zero apex: none, the hull's rim.
///
/// An edge can be flipped if it is the diagonal of a parallelogram, which makes one apex the
/// opposite of the other, and its flipped state is no longer than longest_edge. So of an edge
/// either its gain is told or its right apex.
struct Edge {
    Vec v;
    Vec left;
    /// Of an edge that can be flipped its gain as a float, of others rigid_mark above the bytes of
    /// the right apex.
    uint32_t word = 0;

    Edge() = default;
    /// With a gain that is not known, which is told by no_gain.
    Edge(Vec v_, Vec left_, Vec right) : v(v_), left(left_) {
        if (is_diagonal(left_, right))
            set_gain(no_gain);
        else
            word = rigid_mark << 16 | bytes_of(right.x, right.y);
    }

    bool flippable() const { return word >> 16 != rigid_mark; }
    Vec right() const { return flippable() ? -left : vec_of(word); }
    /// The sum of both apexes: zero of an edge that can be flipped.
    Vec apexes() const { return left + right(); }

    /// no_gain of an edge that cannot be flipped, or whose gain is not known.
    float gain() const { return std::max(float_of(word), no_gain); }
    /// Of an edge that can be flipped.
    void set_gain(float gain) {
        gain = gain < least_gain ? least_gain : gain;
        word = bits_of(gain != gain ? std::fabs(gain) : gain);
    }

    /// Whether an edge with these apexes can be flipped. Without branches, since half of all can.
    static bool is_diagonal(Vec left, Vec right) {
        const auto allowed = [](int n) { return unsigned(n + longest_edge) <= 2u * longest_edge; };
        return ((left.x | left.y) != 0) & (left.x + right.x == 0) & (left.y + right.y == 0) &
               allowed(left.x) & allowed(left.y);
    }
};

/// Pixels across that a lattice may have whose sites are worked on several at a time
/// (site_lanes-inl.h): offsets are products of 16 bits. No tile has more; in wider lattices sites
/// are worked on one by one.
constexpr int widest_lanes = INT16_MAX / 2;

/// Cells whose divisions are looked at together (crossed_columns.h).
constexpr int cells_at_once = 8;

/// How a cell (2x2 pixels) is divided, told by the edge at its centre.
/// A cell divided in two is called plain.
enum class Division : uint8_t {
    down = division_down,       ///< in two, by the diagonal from upper left to lower right
    up = division_up,           ///< in two, by the other diagonal
    crossed = division_crossed, ///< edges that are not the cell's own cross it
};

/// v and left of an edge's record as one number.
constexpr uint32_t first_word(int vx, int vy, int left_x, int left_y) {
    return bytes_of(vx, vy) | bytes_of(left_x, left_y) << 16;
}
inline uint32_t first_word(const Edge& e) {
    return first_word(e.v.x, e.v.y, e.left.x, e.left.y);
}

/// An edge's vectors as one number: v in the low two bytes, then left, then right; the record of
/// an edge as shaders have it (shaders/lattice.glsl).
inline uint64_t vectors_of(const Edge& e) {
    const Vec right = e.right();
    return first_word(e) | uint64_t(bytes_of(right.x, right.y)) << 32;
}
/// The bits of a shader's record that are those; the others are scratch.
constexpr uint64_t vectors_mask = 0xffffffffffffu;

/// First words of the central edge of a cell that its own diagonal divides, which can always be
/// flipped: the apexes are the cell's other corners, and the edge may run either way.
constexpr uint32_t down_word = first_word(1, 1, -1, 1), down_word_back = first_word(-1, -1, 1, -1),
                   up_word = first_word(-1, 1, -1, -1), up_word_back = first_word(1, -1, 1, 1);

/// The division of the cell that `centre` is the central edge of.
inline Division division(const Edge& centre) {
    const uint32_t first = first_word(centre);
    const bool down = centre.flippable() & ((first == down_word) | (first == down_word_back));
    const bool up = centre.flippable() & ((first == up_word) | (first == up_word_back));
    return Division(2 - 2 * int(down) - int(up));
}

struct Vertex {
    float guide = 0;
    union {
        /// While edges flip: the contour word (core/guide/contour.h) of the cell that has this as
        /// its upper left corner.
        uint32_t contour = 0;
        /// Afterwards: midpoint of the incident edge with the smallest address, relative to the
        /// vertex.
        Vec first;
    };
};

union Site {
    Edge edge;
    Vertex vertex;
    Site() : edge() {}
};
static_assert(sizeof(Site) == 8 && sizeof(Edge) == 8, "one edge, 8 bytes");

#include "core/lattice/quad-inl.h"

/// The parallelogram round a flippable edge.
struct Quad : QuadOf<Vec> {
    explicit Quad(const Edge& e) : QuadOf(e.v, e.left) {}
};

/// A triangulation of width x height pixels, both at least 2.
class Lattice {
public:
    /// Make all edges of the mesh that has the diagonal from upper left to lower right in every
    /// 2x2 cell, or with `flat` the diagonal whose ends differ less in the guide (on a tie that
    /// one). `guide`: width x height floats. With `contours` the vertices receive the guide's
    /// contour words, and `flat` prefers the diagonal that goes along the contour, if one does.
    /// Memory is kept from one use to the next.
    void start(int width, int height, const float* guide, bool flat, bool contours = false);

    /// Room for the guide of a lattice of width x height pixels, within what that lattice is to be
    /// made in: start() may be given it.
    float* guide_place(int width, int height);

    /// Take the memory for so many sites: 4 a pixel are enough.
    void reserve(size_t sites) {
        reserve_large(m_sites, sites);
        m_divisions.reserve(sites / 4 + cells_at_once);
    }

    /// The bytes that it takes.
    size_t bytes() const {
        return m_sites.capacity() * sizeof(Site) + m_divisions.capacity() * sizeof(Division) +
               m_longest_down.capacity();
    }

    int width() const { return m_width; }
    int height() const { return m_height; }
    int stride() const { return m_stride; }
    /// Sites there are; those outside the doubled lattice are never edges.
    size_t size() const { return m_sites.size(); }

    int site(int doubled_x, int doubled_y) const { return doubled_y * m_stride + doubled_x; }
    int vertex_site(int x, int y) const { return site(2 * x, 2 * y); }
    int offset(Vec v) const { return v.y * m_stride + v.x; }

    Edge& edge(int site) { return m_sites[size_t(site)].edge; }
    const Edge& edge(int site) const { return m_sites[size_t(site)].edge; }
    Vertex& vertex(int site) { return m_sites[size_t(site)].vertex; }
    const Vertex& vertex(int site) const { return m_sites[size_t(site)].vertex; }
    Site* sites() { return m_sites.data(); }
    const Site* sites() const { return m_sites.data(); }
    float guide(int site) const { return m_sites[size_t(site)].vertex.guide; }

    /// No edge is longer than this in either coordinate, in pixels.
    int longest() const { return m_longest; }
    /// The same of |v.y| of edges with midpoints in row y of the doubled lattice.
    int longest_down(int y) const { return m_longest_down[size_t(y)]; }
    /// Whether no edge was flipped since start().
    bool fresh() const { return m_fresh; }

    // What schemes ask any mesh that they flip; twin: core/tin/tin_mesh.h.
    bool flippable(int m) const { return edge(m).flippable(); }
    /// no_gain of an edge that cannot be flipped, or whose gain is not known: flips leave those
    /// behind.
    float gain(int m) const { return edge(m).gain(); }
    void set_gain(int m, float gain) { edge(m).set_gain(gain); }
    /// Whether an edge can be flipped and has not been touched since its gain was found.
    bool settled(int m) const { return edge(m).word < least_unsettled; }
    /// Say that the edge's gain is about to be found. False if it cannot be flipped, or was touched
    /// before.
    bool touch(int m) {
        uint32_t& word = edge(m).word;
        const bool is_new = word < least_unsettled;
        // Branch-free: compilers make a branch of ?: here, and it would be mispredicted.
        word = choose(is_new, touched_word, word);
        return is_new;
    }
    size_t vertices() const { return size_t(m_width) * size_t(m_height); }
    size_t edges() const { return size_t(2 * m_width - 1) * size_t(2 * m_height - 1) - vertices(); }
    /// Where in the image an edge is, as one number: its midpoint, in doubled coordinates, in an
    /// image in which the lattice's first pixel is at (origin_x, origin_y).
    uint64_t place(int m, int origin_x, int origin_y) const {
        return uint64_t(uint32_t(m / m_stride + 2 * origin_y)) << 32 |
               uint32_t(m % m_stride + 2 * origin_x);
    }
    /// The sides of the parallelogram round the flippable edge at m: ac, cb, bd, da.
    std::array<int, 4> sides(int m) const {
        const Quad q(edge(m));
        return {m + offset(q.middle[0]), m + offset(q.middle[1]), m + offset(q.middle[2]),
                m + offset(q.middle[3])};
    }

    /// Flip the flippable edge at m: (v, L, R) <- (L, -v, v); in its parallelogram's sides the apex
    /// that went away is replaced.
    void flip(int m);
    /// Flip flippable edges outside each other's 2-regions.
    void flip_all(const int* edges, size_t n);
    /// Undo the last flip of the edge at m, if no side of it was flipped since.
    void flip_back(int m);

    /// The apex of side k of the parallelogram q round m that lies beyond, relative to the side's
    /// midpoint; zero on the rim.
    Vec outer_apex(int m, const Quad& q, int k) const {
        return apex_beyond(edge(m + offset(q.middle[k])), q.inner[k]);
    }

    /// Call f(site) for every edge in address order.
    template <class F>
    void each_edge(F&& f) const {
        each_edge(0, 2 * m_height - 1, f);
    }
    /// Of those in rows y0 to y1 - 1 of sites.
    template <class F>
    void each_edge(int y0, int y1, F&& f) const {
        for (int y = y0; y < y1; ++y)
            for (int x = 1 - (y & 1), step = 2 - (y & 1); x < 2 * m_width - 1; x += step)
                f(site(x, y));
    }

    /// Call f(site) for the 2-region of the flippable edge at m without m itself until it returns
    /// true: the sides of its parallelogram, then the other edges of the triangles beyond them; 12
    /// edges away from the rim. Returns whether f did.
    template <class F>
    bool any_of_region(int m, F&& f) const {
        const Quad q(edge(m));
        for (int k = 0; k < 4; ++k)
            if (f(m + offset(q.middle[k])))
                return true;
        for (int k = 0; k < 4; ++k) {
            const Vec apex = outer_apex(m, q, k);
            if (apex.zero())
                continue;
            const int middle = m + offset(q.middle[k]);
            if (f(middle + offset(from_last_end(apex, q.side[k]))) ||
                f(middle + offset(from_first_end(apex, q.side[k]))))
                return true;
        }
        return false;
    }

    /// Call f(site) for the whole 2-region of the flippable edge at m without m itself.
    template <class F>
    void each_of_region(int m, F&& f) const {
        any_of_region(m, [&](int other) {
            f(other);
            return false;
        });
    }

    Rect all() const { return {0, 0, m_width, m_height}; }

    /// Find how the cells round the vertices of `part` are divided; after the last flip.
    void find_divisions(const Rect& part);
    /// What it found of the cells with upper corners (0, y), (1, y), ...; as many as cells_at_once
    /// more may be read.
    const Division* divisions(int y) const {
        return m_divisions.data() + size_t(y) * size_t(m_width - 1);
    }

    /// Fill Vertex::first of the vertices of `part`; after the last flip.
    void find_first_edges(const Rect& part);
    /// The same of those alone that are corners of crossed cells (Division::crossed) or on the
    /// lattice's rim; others may be left as they are. The part's divisions have been found.
    void find_walked_first_edges(const Rect& part);

private:
    void find_short_first_edges(const Rect& part);
    void find_long_first_edges(const Rect& part);
    /// The edge at m goes over `down` rows.
    void note_down(int m, int down) {
        uint8_t& longest = m_longest_down[size_t(m / m_stride)];
        longest = std::max(longest, uint8_t(down));
    }

    int m_width = 0, m_height = 0, m_stride = 0;
    int m_longest = 1;
    std::vector<uint8_t> m_longest_down;
    bool m_fresh = false;
    std::vector<Site> m_sites;
    std::vector<Division> m_divisions; ///< a cell
};

} // namespace ddt
