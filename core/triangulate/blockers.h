// SPDX-License-Identifier: Apache-2.0
// Which candidates wait for which: of those whose flips would get in each other's way, the one that
// gains most goes first.
#pragma once

#include <vector>

#include "core/lattice/lattice.h"

namespace ddt {

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

/// The same by the widest vectors this machine has: the best of those that go before it.
void find_blockers(const Lattice& lattice, const std::vector<float>& gain, const int* sites,
                   size_t n, int* blockers);

} // namespace ddt
