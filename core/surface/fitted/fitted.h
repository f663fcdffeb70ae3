// SPDX-License-Identifier: Apache-2.0
// Vertices and bends by weights that were fitted to pictures (SurfaceOptions::fitted).
//
// They stand in place of the rounds of consistency. An edge and its apexes are a basis of the
// lattice: the pixels round its midpoint are a + i v + j l, a its end, v its vector, l an apex from
// the midpoint in doubled coordinates. In such slanted coordinates one small filter serves all
// directions, long along the contour that the edge follows. From the source s:
//
//     z = clamp(s + sum_n t_n sum_f W_nf f, limits of a consistency round)
//     e = clamp(sum_n t_n (sum_f S_nf f + sum_g N_kng g), -2 r, 2 r),   r the range of s over a, b,
//         c and d
//
// with a vertex' features f: the means over five rings of the 5x5 pixels round it, less its own,
// and the step of one consistency round; an edge's f: the pixels along it, less its midpoint's
// value, the plain bend e of net.h, and what the next pixels along it tell, within its rise; an
// edge's g: combinations of 30 pixels that are 0 wherever the picture varies along one axis only,
// so that an exactly level, upright or diagonal contour stays as even as it is.
//
// t_0 = 1, the others rise from 0 to 1 between nodes of an index between 0, where there are but two
// levels, and about 0.2, in texture: the mean of min(s - low, high - s) over the 5x5 pixels in
// units of high - low; an edge has the mean of its ends'. N differs by the edge's length and by
// whether, and how nearly, a flip of it would pay (class k). The weights, and how they were made,
// are in weights.inc.
//
// Vertices on the rim stay. What is not finite keeps the plain value.
#pragma once

#include <vector>

#include "core/surface/consistency.h"
#include "core/surface/fitted/weights.h"

namespace ddt {

/// Whether a surface is made of fitted vertices and bends.
inline bool is_fitted(const SurfaceOptions& options) {
    return options.fitted && options.consistency > 0 && options.kind == Surface::patch;
}

/// One group's fitted net; memory is kept from one to the next.
class Fitted {
public:
    /// Move the vertices of a net that goes through the source and whose edges were all bent, and
    /// softened where they are, after consistency.measure().
    void move_vertices(const Lattice& lattice, const Consistency& consistency, Net& net);
    /// Only those of `part`, and perhaps some beside them, which are then of no use.
    void move_vertices(const Lattice& lattice, const Rect& part, const Consistency& consistency,
                       Net& net);

    /// Then make e of the edges whose ends both lie in `part` (in pixels) from the plain one, which
    /// is in its place. gain: Workspace::gain of the finished mesh.
    void bend_edges(const Lattice& lattice, const Rect& part, const float* gain,
                    const Consistency& consistency, Net& net) const;

    // For the SIMD twins.
    std::vector<float> index; ///< group_size floats a pixel
};

} // namespace ddt
