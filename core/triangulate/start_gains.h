// SPDX-License-Identifier: Apache-2.0
// The first evaluation of a mesh: all edges, before any was flipped.
#pragma once

#include "core/triangulate/triangulate.h"

namespace ddt {

/// Find the gains of all edges of a lattice that was just started; w.candidates receives those
/// above min_gain. Adds to statistics.evaluations.
///
/// False if an edge was flipped since the start, or the guide is not in steps as guide_step() makes
/// them: then no gain is what it should be.
bool start_gains(Lattice& lattice, const Criterion& criterion, float min_gain, Workspace& w,
                 Statistics& statistics);

/// About the bytes that it takes meanwhile, of a lattice of this width.
size_t start_gains_memory(int width);

/// Only a started lattice has a quick way.
template <class Mesh>
bool start_gains(Mesh&, const Criterion&, float, Workspace&, Statistics&) {
    return false;
}

} // namespace ddt
