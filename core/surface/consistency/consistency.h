// SPDX-License-Identifier: Apache-2.0
// Correcting the vertices so that the surface's mean over each source pixel is the pixel's value.
//
// A camera's or renderer's pixel is a mean over an area; a surface through the pixel values has
// other means. One round moves each vertex by the difference: z <- z + (source - mean). Where
// output pixels are not much smaller than the source's, the mean counts as nearer to the vertex
// (correction_strength()). Vertices on the lattice's rim, whose pixels the mesh covers only in
// part, stay. What comes out is limited to the range of the 3x3 source pixels, widened
// (SurfaceOptions::limit).
#pragma once

#include <vector>

#include "core/base/constants.h"
#include "core/lattice/crossed_rows.h"
#include "core/surface/control_net.h"
#include "core/surface/corrections.h"
#include "ddt/core.h"

namespace ddt {

/// Positions along an axis at which quadrants' means are taken (consistency-inl.h).
constexpr int quadrant_side = 4;

/// The positions of means in a crossed cell.
const CellPositions& mean_positions();

/// What add_means() works in, kept from one row to the next.
struct MeanScratch {
    std::vector<float> means; ///< of a row of cells' quadrants, one after the other
    std::vector<float> down;  ///< 1 where a cell's diagonal is down, else 0
};

/// Add what the cells of row y have, as far as the vertices of `part` need it, to the sums of
/// quadrants' means of the vertices above them, and begin those of the vertices below with it,
/// ControlNet::count() floats each. The edges that cross the row must have been bent (for
/// Surface::patch) and softened (where the net has soft edges), the divisions been found. `crossed`
/// has begun with mean_positions().
void add_means(const Lattice& lattice, Surface surface, const ControlNet& net, const Rect& part,
               int y, CrossedRows& crossed, MeanScratch& scratch, float* upper, float* lower);

/// A picture's rows of pixels above, at and below one, from column 0 on.
struct NearRows {
    const float *above, *here, *below;
};

/// Put where the vertices of a net in columns x0 .. x1 - 1 of row y go, none of which is on the
/// rim, into `moved`, which is not the net's own. sum, moved: rows from column 0 on.
void move_row(const Lattice& lattice, const ControlNet& net, int x0, int x1, int y,
              const NearRows& source, const float* sum, const Correction& correction, float* moved);

} // namespace ddt
