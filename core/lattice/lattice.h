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
//   site             what there is at a site, in 8 bytes
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
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/arith.h"
#include "core/base/memory/large_pages.h"
#include "core/lattice/site.h"
#include "ddt/rect.h"

namespace ddt {

/// Pixels across that a lattice may have whose sites are worked on several at a time
/// (site_lanes-inl.h): offsets are products of 16 bits. No tile has more; in wider lattices sites
/// are worked on one by one.
constexpr int widest_lanes = INT16_MAX / 2;

/// Cells whose divisions are looked at together (crossed_columns.h).
constexpr int cells_at_once = 8;

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
