// SPDX-License-Identifier: Apache-2.0
// The 2-regions of many edges (Lattice::any_of_region): which candidates wait for which, and what
// flips touch. A lattice's by the widest vectors this machine has, an edge a lane.
#pragma once

#include "core/base/vectors/row_lanes.h"
#include "core/lattice/lattice.h"

namespace ddt {

/// Edges whose regions are looked at together.
constexpr size_t regions_at_once = 64;

/// Whether the candidate at `other`, in the 2-region of the one at m, goes before it.
template <class Mesh>
bool goes_before(const Mesh& mesh, int other, int m) {
    const float g = mesh.gain(other), own = mesh.gain(m);
    return g > own || (g == own && other < m);
}

/// For each of the candidates sites[0..n) an edge of its 2-region that goes before it, or -1 if it
/// is the best of its region. Which of several is unspecified: it affects only how often a
/// candidate is looked at again.
template <class Mesh>
void find_blockers(const Mesh& mesh, const int* sites, size_t n, int* blockers) {
    for (size_t i = 0; i < n; ++i) {
        blockers[i] = -1;
        mesh.any_of_region(sites[i], [&](int other) {
            const bool better = goes_before(mesh, other, sites[i]);
            blockers[i] = better ? other : -1;
            return better;
        });
    }
}
/// The best of those that go before it.
void find_blockers(const Lattice& lattice, const int* sites, size_t n, int* blockers);

/// Edges that may be written past the last.
constexpr size_t region_padding = most_lanes;

/// The edges of the 2-regions of the flippable edges sites[0..n), some more than once; those that
/// touch() would refuse may be left out. Returns how many, at most most_in_region for each.
template <class Mesh>
size_t find_settled(const Mesh& mesh, const int* sites, size_t n, int* regions) {
    int* next = regions;
    for (size_t i = 0; i < n; ++i) {
        *next++ = sites[i];
        mesh.each_of_region(sites[i], [&](int other) { *next++ = other; });
    }
    return size_t(next - regions);
}
size_t find_settled(const Lattice& lattice, const int* sites, size_t n, int* regions);

} // namespace ddt
