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
// the blend of the mesh with its flipped state: at g = 0 both diagonals count alike.
//
// Non-finite values stay inside the triangles that touch them: such a triangle counts for no
// gradient and the edges of such a vertex have e = 0.
#pragma once

#include <vector>

#include "core/lattice/lattice.h"
#include "ddt/core.h"

namespace ddt {

/// Channels that are worked on together, one a SIMD lane.
constexpr int group_size = 4;

/// z and e of one group of channels over the doubled lattice: site s has its group_size numbers at
/// at(s), z at a vertex, e at an edge's midpoint. Some rows of the lattice, or all of them.
struct Net {
    std::vector<float> values;
    std::vector<float> soft; ///< q at an edge's site; empty: no soft edges
    /// The sites that `values` and `soft` begin with.
    int first = 0, first_soft = 0;
    /// 1 in the lanes whose values must stay within their triangle's range even with soft edges.
    float strict[group_size] = {};
    int stride = 0; ///< the lattice's
    const float* at(int site) const { return values.data() + ptrdiff_t(site - first) * group_size; }
    float* at(int site) { return values.data() + ptrdiff_t(site - first) * group_size; }
    const float* soft_at(int site) const {
        return soft.data() + ptrdiff_t(site - first_soft) * group_size;
    }
    float* soft_at(int site) { return soft.data() + ptrdiff_t(site - first_soft) * group_size; }
};

/// One group's channels in the pixels of a lattice: first .. first + count (count <= group_size) of
/// `channels` interleaved floats a pixel.
struct GroupValues {
    const float* values = nullptr;
    int channels = 0, first = 0, count = 0;
};

/// Makes a group's values row by row: group_size floats for each pixel of a lattice's row.
class ValueRows {
public:
    virtual ~ValueRows() = default;
    /// Row y; there until the next is asked for. Rows are asked for from the top downwards, each
    /// once.
    virtual const float* row(int y) = 0;
};

/// Set the vertices of a net of the whole lattice to a group's values. Unused lanes are 0.
void set_vertices(const Lattice& lattice, const float* values, int channels, int first, int count,
                  Net& net);
/// Those of the pixels of `part` alone, whose rows the net must have.
void set_vertices(const Lattice& lattice, const GroupValues& values, const Rect& part, Net& net);
void set_vertices(const Lattice& lattice, ValueRows& values, const Rect& part, Net& net);
/// Copy a group's values of so many pixels, group_size floats each. Unused lanes are 0.
void copy_group(const GroupValues& values, size_t pixels, float* to);

} // namespace ddt
