// SPDX-License-Identifier: Apache-2.0
// The first evaluation of a mesh: all edges, before any was flipped.
#pragma once

#include "core/triangulate/triangulate.h"

namespace ddt {

/// Fill w.gain with the gains of all edges of a lattice that was just started, no_gain where one
/// cannot be flipped, and w.candidates with those above min_gain. Adds to statistics.evaluations.
///
/// False if an edge was flipped since the start, or the guide is not in steps of 2^-12 within -1024
/// to 1024 (as guide_step() makes it): then nothing was done.
bool start_gains(const Lattice& lattice, const Criterion& criterion, float min_gain, Workspace& w,
                 Statistics& statistics);

/// About the bytes that it takes meanwhile, of a lattice of this width.
size_t start_gains_memory(int width);

/// Only a started lattice has a quick way.
template <class Mesh>
bool start_gains(const Mesh&, const Criterion&, float, Workspace&, Statistics&) {
    return false;
}

} // namespace ddt
