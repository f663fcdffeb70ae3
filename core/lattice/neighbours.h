// SPDX-License-Identifier: Apache-2.0
// How far the mesh ties a part of the lattice to what lies round it.
#pragma once

#include "core/lattice/lattice.h"
#include "ddt/rect.h"

namespace ddt {

/// What of a rectangle of pixels lies in a lattice.
Rect clipped_to(const Lattice& lattice, const Rect& part);
/// A part of a lattice, in pixels, and so many pixels round it.
Rect grown(const Lattice& lattice, const Rect& part, int by);

/// The same part, of 2 x 2 pixels at least, one pixel round it, and every end of an edge whose
/// bounding box touches it. So all vertices are in it that share an edge with one of the part's,
/// and those of every triangle that meets the part: a triangle holds no pixel but its vertices, so
/// of one without vertices in the part two edges pass through it.
///
/// Less by far than Lattice::longest() round the part, since few edges are long.
Rect with_neighbours(const Lattice& lattice, const Rect& part);

} // namespace ddt
