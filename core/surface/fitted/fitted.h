// SPDX-License-Identifier: Apache-2.0
// Vertices and bends by weights that were fitted to pictures (SurfaceOptions::fitted).
//
// They stand in place of the rounds of consistency. An edge and its apexes are a basis of the
// lattice: the pixels round its midpoint are a + i v + j l, a its end, v its vector, l an apex from
// the midpoint in doubled coordinates. In such slanted coordinates one small filter serves all
// directions, long along the contour that the edge follows. From the source s:
//
//     z = clamp(s + h sum_n t_n sum_f (W_nf + u U_nf) f, limits of a consistency round, wider by u)
//     e = clamp(sum_n t_n (sum_f S_nf f + sum_g N_kng g), -2 r, 2 r),   r the range of s over a, b,
//         c and d
//
// with h = Correction::strength; a vertex' features f: the means over five rings of the 5x5 pixels
// round it, less its own, and the step of one consistency round; an edge's f: the pixels along it,
// less its midpoint's value, the plain bend e of control_net.h, and what the next pixels along it
// tell, within its rise; an edge's g: combinations of 30 pixels that are 0 wherever the picture
// varies along one axis only, so that an exactly horizontal, vertical or diagonal contour stays as
// even as it is.
//
// t_0 = 1, the others rise from 0 to 1 between nodes of an index between 0, where there are but two
// levels, and about 0.2, in texture: the mean of min(s - low, high - s) over the 5x5 pixels in
// units of high - low; an edge has the mean of its ends'. N differs by the edge's length and by
// whether, and how nearly, a flip of it would pay (class k). The weights, and how they were made,
// are in weights.inc.
//
// u, from 0 to 1, says that what is put past the range will not be seen, because the result is cut
// off to 0 .. 1 (SurfaceOptions::clipped): the vertex is one of the darker of its 5x5 pixels, and
// the darkest is black, or one of the brighter, and the brightest is white. There outlines get
// steeper than a patch of their own height could be.
//
// Vertices on the rim stay. What is not finite keeps the plain value.
#pragma once

#include <cstddef>
#include <vector>

#include "core/surface/consistency/consistency.h"
#include "core/surface/control_net.h"
#include "core/surface/fitted/weights.h"
#include "core/surface/near_cells.h"

namespace ddt {

/// One group's source: `count` floats for every pixel of the lattice, and as many more that may be
/// read as make up group_size.
struct FittedSource {
    const Lattice& lattice;
    const float* pixels;
    int count;
    const float* at(int x, int y) const {
        return pixels + (ptrdiff_t(y) * lattice.width() + x) * count;
    }
};

/// Put where the vertices in columns x0 .. x1 - 1 of row y of pixels go into the net, those on the
/// rim excepted, and their index into `index`; sum: of add_means(). Both rows begin with column 0.
void move_fitted(const FittedSource& source, int x0, int x1, int y, const Correction& correction,
                 const float* sum, float* index, ControlNet& net);

/// The rows of indices of the vertices round an edge: row y at rows[y % count].
struct IndexRows {
    const float* rows;
    int count;
    size_t row;   ///< floats
    int channels; ///< in a pixel
    const float* at(int x, int y) const {
        return rows + size_t(y % count) * row + ptrdiff_t(x) * channels;
    }
};

/// Kept from one row to the next.
struct BendScratch {
    NearCells cells;
    /// Of the edges of a row of the doubled lattice, of even and of odd columns: how nearly a flip
    /// would pay, 0 to 1, and 1 where it can be flipped, else 0.
    std::vector<float> near[2], flippable[2];
    std::vector<int> columns; ///< of edges that are made one by one
};

/// Put e of the edges with midpoints in row y of the doubled lattice whose ends both lie in `part`,
/// in pixels, into the net, made from `plain`'s and the finished mesh's gains. Those of the row
/// before were made last, if it is in the part.
void bend_fitted(const FittedSource& source, const Rect& part, int y, const IndexRows& index,
                 const ControlNet& plain, BendScratch& scratch, ControlNet& net);

} // namespace ddt
