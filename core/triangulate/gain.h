// SPDX-License-Identifier: Apache-2.0
// The gain of flipping an edge: what the mesh's total cost falls by.
#pragma once

#include "core/cost/cost.h"
#include "core/lattice/lattice.h"

namespace ddt {

/// The gain of an edge that cannot be flipped.
constexpr float no_gain = -1e30f;

namespace scalar {

#include "core/triangulate/gain-inl.h"

/// Gather what the gain of the flippable edge at m depends on.
inline Neighbourhood<float> neighbourhood(const Lattice& lattice, int m) {
    const Edge& e = lattice.edge(m);
    const Quad q(e);
    Neighbourhood<float> n;
    n.vx = q.v.x;
    n.vy = q.v.y;
    n.wx = q.w.x;
    n.wy = q.w.y;
    const int dv = lattice.offset(e.v), dl = lattice.offset(e.left);
    n.za = lattice.guide(m - dv);
    n.zb = lattice.guide(m + dv);
    n.zc = lattice.guide(m + dl);
    n.zd = lattice.guide(m - dl);
    const float first_end[4] = {n.za, n.zc, n.zb, n.zd};
    for (int k = 0; k < 4; ++k) {
        const Vec apex = lattice.outer_apex(m, q, k);
        auto& outer = n.outer[k];
        // The side's first end is at -side from its midpoint, in doubled coordinates.
        outer.ox = float((apex.x + q.side[k].x) / 2);
        outer.oy = float((apex.y + q.side[k].y) / 2);
        outer.present = apex.zero() ? 0.0f : 1.0f;
        outer.z = apex.zero()
                      ? first_end[k]
                      : lattice.guide(m + lattice.offset(q.middle[k]) + lattice.offset(apex));
    }
    return n;
}

/// The gain of flipping the flippable edge at m.
template <class CostOfFloat>
inline float gain(const Lattice& lattice, int m) {
    return flip_gain<CostOfFloat>(neighbourhood(lattice, m));
}

} // namespace scalar

/// The same under the name by which schemes ask any mesh.
template <class CostOfFloat>
inline float gain_of(const Lattice& lattice, int m) {
    return scalar::gain<CostOfFloat>(lattice, m);
}

/// Gains of the flippable edges sites[0..n): gains[sites[i]] receives the gain of sites[i]. By the
/// widest vectors this machine has; the bits are those of scalar::gain().
void gains(const Lattice& lattice, Cost cost, const int* sites, size_t n, float* gains);

/// The cost of the whole mesh: each edge between two triangles, summed in double.
double total_cost(const Lattice& lattice, Cost cost);

} // namespace ddt
