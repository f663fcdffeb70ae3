// SPDX-License-Identifier: Apache-2.0
// The gain of flipping an edge: what the mesh's total cost falls by.
#pragma once

#include <vector>

#include "core/cost/cost.h"
#include "core/cost/criterion.h"
#include "core/guide/contour.h"
#include "core/lattice/lattice.h"

namespace ddt {

namespace scalar {

#include "core/triangulate/gain-inl.h"

/// A lattice as neighbourhood() sees it, a site at a time.
struct OneSite {
    using Sites = int;
    using V = Vec;
    const Lattice& lattice;

    const Edge& flippable_edge(int m) const { return lattice.edge(m); }
    const Edge& side(int, int middle) const { return lattice.edge(middle); }
    int offset(Vec v) const { return lattice.offset(v); }
    float guide(int m) const { return lattice.guide(m); }
    float x(Vec v) const { return float(v.x); }
    float y(Vec v) const { return float(v.y); }
    float present(Vec apex) const { return apex.zero() ? 0.0f : 1.0f; }
    float guide_beyond(int middle, Vec apex, float otherwise) const {
        return apex.zero() ? otherwise : guide(middle + offset(apex));
    }
    int contour(int corner) const { return int(lattice.vertex(corner).contour); }
    template <int k>
    float steps(int words) const {
        return float(words >> k * contour_bits & contour_mask);
    }
};

/// The gain of flipping the flippable edge at m; `contour` as in Criterion.
template <class CostOfFloat>
inline float gain(const Lattice& lattice, int m, float contour = 0.0f) {
    const OneSite mesh{lattice};
    if (contour == 0)
        return flip_gain<CostOfFloat>(neighbourhood<float>(mesh, m));
    return gain_with_contours<CostOfFloat, float>(mesh, m, contour * contour_unit);
}

} // namespace scalar

/// The same under the name by which schemes ask any mesh.
template <class CostOfFloat>
inline float gain_of(const Lattice& lattice, int m, float contour) {
    return scalar::gain<CostOfFloat>(lattice, m, contour);
}

/// Gains of the flippable edges sites[0..n): gains[sites[i]] receives the gain of sites[i]. By the
/// widest vectors this machine has; the bits are those of scalar::gain().
void gains(const Lattice& lattice, const Criterion& criterion, const int* sites, size_t n,
           float* gains);

/// How many of some edges can be flipped, and how many of these gain enough.
struct Evaluated {
    size_t flippable = 0, candidates = 0;
};
/// Numbers that may be written past the last candidate.
constexpr size_t candidate_padding = 64;

/// Find the gains of the edges sites[0..n), no_gain of those that cannot be flipped; those above
/// min_gain go to `candidates`, in their order. Without branches, since half of the edges can be
/// flipped; `candidates` holds those that can before it holds those that gain.
template <class Mesh>
Evaluated find_candidates(const Mesh& mesh, const Criterion& criterion, float min_gain,
                          const int* sites, size_t n, std::vector<float>& gain, int* candidates) {
    Evaluated found;
    for (size_t i = 0; i < n; ++i) {
        gain[size_t(sites[i])] = no_gain;
        candidates[found.flippable] = sites[i];
        found.flippable += mesh.flippable(sites[i]);
    }
    gains(mesh, criterion, candidates, found.flippable, gain.data());
    for (size_t i = 0; i < found.flippable; ++i) {
        const int m = candidates[i];
        candidates[found.candidates] = m;
        found.candidates += gain[size_t(m)] > min_gain;
    }
    return found;
}

/// The same by the widest vectors this machine has.
Evaluated find_candidates(const Lattice& lattice, const Criterion& criterion, float min_gain,
                          const int* sites, size_t n, std::vector<float>& gain, int* candidates);

/// The cost of the whole mesh: each edge between two triangles, summed in double.
double total_cost(const Lattice& lattice, Cost cost);

} // namespace ddt
