// SPDX-License-Identifier: Apache-2.0
// Correcting the vertices so that the surface's mean over each source pixel is the pixel's value.
//
// A camera's or renderer's pixel is a mean over an area; a surface through the pixel values has
// other means. One round moves each vertex by the difference: z <- z + (source - mean). Vertices on
// the lattice's rim, whose pixels the mesh covers only in part, stay. What comes out is limited to
// the range of the 3x3 source pixels, widened (SurfaceOptions::limit).
#pragma once

#include <cfloat>
#include <vector>

#include "core/lattice/locate.h"
#include "core/surface/net.h"
#include "ddt/core.h"

namespace ddt {

/// Add what the cells of row y have, as far as the vertices of `part` need it, to the sums of
/// quadrants' means of the vertices above and below them, group_size floats each. The edges that
/// cross the row must have been bent (for Surface::patch) and softened (where the net has soft
/// edges), the divisions been found.
void add_means(const Lattice& lattice, Surface surface, const Net& net, const Rect& part, int y,
               float* upper, float* lower);

/// SurfaceOptions::limit in a net's lanes: 0 in strict ones.
void limits_of(const Net& net, float limit, float* limits);
/// The `lowest` of widen() (consistency-inl.h), by SurfaceOptions::clipped.
inline float lowest_of(bool clipped) {
    return clipped ? -FLT_MAX : 0.0f;
}

/// One group's source values and limits, kept from one tile to the next.
class Consistency {
public:
    /// Take the net's vertices as the source. limit: SurfaceOptions::limit; 0 in strict lanes.
    /// clipped: SurfaceOptions::clipped. part: where vertices will be corrected, in pixels.
    void begin(const Lattice& lattice, const Net& net, float limit, bool clipped, const Rect& part);
    void begin(const Lattice& lattice, const Net& net, float limit, bool clipped = false);

    /// To be called before the rows of a round are added.
    void begin_sums() { sum.assign(source.size(), 0.0f); }
    /// Add to the sums what row y of cells has, by add_means(); rows in order.
    void add_row(const Lattice& lattice, Surface surface, const Net& net, const Rect& part, int y);
    /// Then move the vertices of `part`.
    void move(const Lattice& lattice, const Rect& part, Net& net) const;

    /// The first half of correct(): find the surface's means, and leave the vertices as they are.
    void measure(const Lattice& lattice, Surface surface, const Net& net);

    /// One round on the whole lattice, whose edges must all be there.
    void correct(const Lattice& lattice, Surface surface, Net& net);

    /// Give the lanes whose bit is set their source values back: identifiers are nothing to
    /// correct.
    void restore(const Lattice& lattice, unsigned lanes, Net& net) const;

    // For the SIMD twins: group_size floats a pixel.
    std::vector<float> source, low, high;
    std::vector<float> sum; ///< of the quadrants' means
};

} // namespace ddt
