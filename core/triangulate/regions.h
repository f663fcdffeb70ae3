// SPDX-License-Identifier: Apache-2.0
// The 2-regions of many edges (Lattice::any_of_region): which candidates wait for which, and what
// flips touch. A lattice's by the widest vectors this machine has, an edge a lane.
#pragma once

#include <algorithm>
#include <vector>

#include "core/lattice/lattice.h"

namespace ddt {

/// Edges in a 2-region, the edge itself among them, at most.
constexpr size_t most_in_region = 13;
/// Of so many edges regions are best looked at together.
constexpr size_t regions_at_once = 64;

/// Whether the candidate at `other`, in the 2-region of the one at m, goes before it.
inline bool goes_before(const std::vector<float>& gain, int other, int m) {
    const float g = gain[size_t(other)], own = gain[size_t(m)];
    return g > own || (g == own && other < m);
}

/// For each of the flippable edges sites[0..n) an edge of its 2-region that goes before it, or -1
/// if it is the best of its region. gain: a site, no_gain of edges that cannot be flipped. Which of
/// several is found is open: nothing depends on it but how often is looked.
template <class Mesh>
void find_blockers(const Mesh& mesh, const std::vector<float>& gain, const int* sites, size_t n,
                   int* blockers) {
    for (size_t i = 0; i < n; ++i) {
        blockers[i] = -1;
        mesh.any_of_region(sites[i], [&](int other) {
            const bool better = goes_before(gain, other, sites[i]);
            blockers[i] = better ? other : -1;
            return better;
        });
    }
}
/// The best of those that go before it.
void find_blockers(const Lattice& lattice, const std::vector<float>& gain, const int* sites,
                   size_t n, int* blockers);

/// The edges of the 2-regions of the flippable edges sites[0..n), one region after the other,
/// most_in_region sites each: where there are fewer, some twice.
template <class Mesh>
void find_regions(const Mesh& mesh, const int* sites, size_t n, int* regions) {
    for (size_t i = 0; i < n; ++i, regions += most_in_region) {
        std::fill_n(regions, most_in_region, sites[i]);
        int* next = regions;
        mesh.each_of_region(sites[i], [&](int other) { *++next = other; });
    }
}
void find_regions(const Lattice& lattice, const int* sites, size_t n, int* regions);

} // namespace ddt
