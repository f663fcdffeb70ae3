// SPDX-License-Identifier: Apache-2.0
// The gain of flipping an edge: what the mesh's total cost falls by.
#pragma once

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
    return gain_at<CostOfFloat, float>(OneSite{lattice}, m, contour * contour_unit);
}

} // namespace scalar

/// The same under the name by which schemes ask any mesh.
template <class CostOfFloat>
inline float gain_of(const Lattice& lattice, int m, float contour) {
    return scalar::gain<CostOfFloat>(lattice, m, contour);
}

/// Find the gains of the flippable edges sites[0..n), which the mesh then has.
template <class Mesh>
void find_gains(Mesh& mesh, const Criterion& criterion, const int* sites, size_t n) {
    dispatch(criterion.cost, [&](auto cost) {
        for (size_t i = 0; i < n; ++i)
            mesh.set_gain(sites[i], gain_of<decltype(cost)>(mesh, sites[i], criterion.contour));
    });
}
/// By the widest vectors this machine has; the bits are those of scalar::gain().
void find_gains(Lattice& lattice, const Criterion& criterion, const int* sites, size_t n);

/// Sites that may be written past the last.
constexpr size_t candidate_padding = 64;

/// The same, and moves those that gain more than min_gain to the front, in their order. Returns how
/// many these are.
template <class Mesh>
size_t find_candidates(Mesh& mesh, const Criterion& criterion, float min_gain, int* sites,
                       size_t n) {
    find_gains(mesh, criterion, sites, n);
    size_t found = 0;
    for (size_t i = 0; i < n; ++i) {
        const int m = sites[i];
        sites[found] = m;
        found += mesh.gain(m) > min_gain;
    }
    return found;
}
/// By the widest vectors this machine has.
size_t find_candidates(Lattice& lattice, const Criterion& criterion, float min_gain, int* sites,
                       size_t n);

/// The cost of the whole mesh: each edge between two triangles, summed in double.
double total_cost(const Lattice& lattice, Cost cost);

} // namespace ddt
