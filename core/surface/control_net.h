// SPDX-License-Identifier: Apache-2.0
// The surface over the mesh, as a control net of quadratic Bezier triangles.
//
// With barycentric weights b of a triangle's vertices i, j, k
//     F = sum b_i z_i + b_i b_j e_ij + b_j b_k e_jk + b_k b_i e_ki
// where z is the pixel's value and e_ij, one number an edge,
//     e_ij = clamp(1.75 (g_i - g_j) . (p_j - p_i), -|z_j - z_i|, |z_j - z_i|)
// bends the edge to the gradients g estimated at its ends (0 for Surface::linear). The clamp keeps
// every Bezier control point between its edge's ends; so, by the convex hull property, F stays
// between the triangle's three values. 1 instead of 1.75 would follow the gradients; but those are
// means over pixels, which are less steep than the edges that were there (docs/quality.md).
//
// The gradient at a vertex is a mean over the triangles T round it,
//     g = sum w_T grad_T / sum w_T,   w_T = 1 / sqrt(eps + |grad_T|^2),  eps = 0.02^2,
// (w_T to 1 part in 500, which is exact enough for a weight,) so that a vertex beside an edge takes
// its slope from the flat side of the mesh.
//
// Soft edges (SurfaceOptions::soft = tau) add, for each flippable edge ij with apexes c and d and
// gain g,
//     min(b_i, b_j) q_ij,   q_ij = w (z_c + z_d - z_i - z_j),   w = max(0, 1 + min(g, 0) / tau) / 2
// the blend of the mesh with its flipped state: at g = 0 both diagonals count alike. Where values
// are cut off at their triangle's range (Bounds::vertices), q is bounded:
//     2 low <= z_i + z_j + e_ij / 2 + q_ij <= 2 high
// with low = min(z_i, z_j, max(z_c, z_d)) and high = max(z_i, z_j, min(z_c, z_d)): the edge's
// midpoint stays within the range that both its triangles have (elsewhere on the edge, bends may
// pass it by a sixteenth of the edge's own rise). Where one triangle let the edge rise and the
// other cut it off, the surface would jump. The bounds of an edge and its flipped state may differ.
// Of Bounds::dark there is the lower one alone, half as high, where `low` is not negative.
//
// Non-finite values stay inside the triangles that touch them: such a triangle counts for no
// gradient and the edges of such a vertex have e = 0.
//
// How a net is made, in this order:
//   set_vertices() (here)               z, from the pixels or a ValueRows
//   make_gradients() (gradients.cpp)    g at the vertices
//   make_edges() (edges.cpp)            e and q, from z, g and the mesh's gains
// EdgeMaker drives these row by row, downwards, just ahead of whoever reads the net. In filters
// that correct the vertices first, the same comes twice or more:
//   CorrectedRows   rounds of consistency.h, each a MeanRows: a net of its own, and the means of
//                   its surface over pixels. Each asks the round before for rows of values; the
//                   last one's values go to the EdgeMaker above
//   FittedMaker     (fitted/) one MeanRows; from its means move_fitted() makes z and bend_fitted()
//                   e, and an EdgeMaker q: in place of both above
// Whoever reads a finished net chooses by for_surface() which terms it has, and evaluates a
// triangle by Patch::at() (patch-inl.h): core/sample at positions, add_means() (consistency.cpp)
// for means.
//
// Regular vertices and edges, whose cells are all divided by their own diagonals, have neighbours
// that lie alike along a row: they are made in vectors (each_vector()). Irregular ones, at the rim
// or beside a crossed cell (Division::crossed), are listed (list_crossed()) and looked up one by
// one. Most arrays are SiteRows, which have all rows of a lattice, or only a window of them that
// moves downwards as rows are made and used (kept_rows.h).
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/memory/arena.h"
#include "core/base/vectors/row_lanes.h"
#include "core/lattice/lattice.h"
#include "core/surface/bounds.h"
#include "ddt/core.h"

namespace ddt {

static_assert(group_size == most_in_pixel, "a vector of a pixel has a lane for each");

/// Floats beyond the last of a row that may be read or written.
constexpr size_t edge_padding = most_lanes;

/// One number a channel at each site of even columns of the doubled lattice, or at each of odd
/// ones, in some rows of it or in all. What follows a site's may be read as if it were its own, up
/// to group_size numbers.
struct SiteRows {
    ArenaVector<float> numbers;
    int count = group_size; ///< of channels
    int first = 0; ///< the site, in column 0 and an even row, at or beside which they begin
    const float* at(int site) const {
        return numbers.data() + ptrdiff_t((site - first) >> 1) * count;
    }
    float* at(int site) { return numbers.data() + ptrdiff_t((site - first) >> 1) * count; }
};

/// The same at each site. Even columns have the vertices and, in the rows between, the vertical
/// edges of cells, odd columns their horizontal edges and their centres: of each, a row is one run
/// of floats, which is worked on by vectors wherever pixels begin
/// (core/base/vectors/row_lanes-inl.h).
struct SiteNumbers {
    SiteRows even, odd;
    const float* at(int site) const { return (site & 1 ? odd : even).at(site); }
    float* at(int site) { return (site & 1 ? odd : even).at(site); }
    bool empty() const { return even.numbers.empty(); }
};

/// z and e of one group of channels over the doubled lattice: z at a vertex, e at an edge's
/// midpoint. Some rows of the lattice, or all of them.
struct ControlNet {
    SiteNumbers values;
    SiteNumbers soft; ///< q at an edge's site; empty: no soft edges
    Bounds bounds = Bounds::vertices;
    int stride = 0; ///< the lattice's
    int count() const { return values.even.count; }
    const float* at(int site) const { return values.at(site); }
    float* at(int site) { return values.at(site); }
    const float* vertex(int site) const { return values.even.at(site); }
    float* vertex(int site) { return values.even.at(site); }
    const float* soft_at(int site) const { return soft.at(site); }
    float* soft_at(int site) { return soft.at(site); }
};

/// A net to read from. One place() serves all its arrays. Pointers and sizes are copies of the
/// net's: a vector store may alias anything, so that the compiler would load the net's again after
/// each.
struct NetView {
    struct Part {
        const float *even = nullptr, *odd = nullptr;
    };
    Part values, soft; ///< from the vertex at `first` and the edge beside it on
    int first;
    ptrdiff_t count, row; ///< floats from one column or row of the doubled lattice to the next

    explicit NetView(const ControlNet& net)
        : first(net.values.even.first), count(net.count()), row(ptrdiff_t(net.stride / 2) * count) {
        values = {net.values.even.at(first), net.values.odd.at(first)};
        if (!net.soft.empty())
            soft = {net.soft.even.at(first), net.soft.odd.at(first)};
    }
    ptrdiff_t place(int site) const { return ptrdiff_t((site - first) >> 1) * count; }
    const float* vertex(int site) const { return values.even + place(site); }
    const float* at(int site) const { return (site & 1 ? values.odd : values.even) + place(site); }
    const float* soft_at(int site) const { return (site & 1 ? soft.odd : soft.even) + place(site); }
};

/// What a net has round the cells of a row, `x` floats after that of the first: NetView::count from
/// one to the next.
class CellNumbers {
public:
    /// Those of no net: nothing can be read.
    CellNumbers() = default;
    /// Of the net's values or softness; site: of the first cell's first corner.
    CellNumbers(const NetView& net, const NetView::Part& part, int site) : m_count(net.count) {
        const float *even = part.even + net.place(site), *odd = part.odd + net.place(site);
        m_vertices[0] = even, m_left = even + net.row, m_vertices[1] = even + 2 * net.row;
        m_horizontal[0] = odd, m_centre = odd + net.row, m_horizontal[1] = odd + 2 * net.row;
    }
    /// right, below: 0 or 1.
    const float* corner(ptrdiff_t x, int right, int below) const {
        return m_vertices[below] + (x + right * m_count);
    }
    const float* top(ptrdiff_t x) const { return m_horizontal[0] + x; }
    const float* left(ptrdiff_t x) const { return m_left + x; }
    const float* centre(ptrdiff_t x) const { return m_centre + x; }
    const float* right(ptrdiff_t x) const { return m_left + (x + m_count); }
    const float* bottom(ptrdiff_t x) const { return m_horizontal[1] + x; }

private:
    const float *m_vertices[2] = {}, *m_horizontal[2] = {}, *m_left = nullptr, *m_centre = nullptr;
    ptrdiff_t m_count = 0;
};

/// One group's channels in the pixels of a lattice: first .. first + count (count <= group_size) of
/// `channels` interleaved floats a pixel.
struct GroupValues {
    const float* values = nullptr;
    int channels = 0, first = 0, count = 0;
};

/// Makes a group's values row by row: count() floats for each pixel of a lattice's row.
class ValueRows {
public:
    virtual ~ValueRows() = default;
    virtual int count() const = 0;
    /// Row y; there until the next is asked for. Rows are asked for from the top downwards, each
    /// once.
    virtual const float* row(int y) = 0;
};

/// A row of a picture's pixels with the group's channels alone, `count` floats each: the values'
/// own, or else what `copied` receives.
const float* group_row(const GroupValues& values, int width, int y, std::vector<float>& copied);

/// Set the vertices of the pixels of `part`, whose rows the net must have, to a group's values.
void set_vertices(const Lattice& lattice, const GroupValues& values, const Rect& part,
                  ControlNet& net);
void set_vertices(const Lattice& lattice, ValueRows& values, const Rect& part, ControlNet& net);
/// Copy those channels of some pixels, `count` floats each, whose bits are set in `lanes`.
void copy_lanes(const float* from, int pixels, int count, unsigned lanes, float* to);
/// Copy a group's values of so many pixels, `count` floats each.
void copy_group(const GroupValues& values, size_t pixels, float* to);

} // namespace ddt
