// SPDX-License-Identifier: Apache-2.0
#include "core/triangulate/gain.h"

namespace ddt {

double total_cost(const Lattice& lattice, Cost cost) {
    return dispatch(cost, [&](auto which) {
        using C = decltype(which);
        double sum = 0;
        lattice.each_edge([&](int m) {
            const Edge& e = lattice.edge(m);
            if (e.left.zero() || e.right().zero())
                return;
            const Vec v = e.v;
            const float za = lattice.guide(m - lattice.offset(v));
            const float de = lattice.guide(m + lattice.offset(v)) - za;
            // The right apex turns the triangle round.
            const Vec l = from_first_end(e.left, v), r = from_first_end(e.right(), v);
            const float dl = lattice.guide(m + lattice.offset(e.left)) - za;
            const float dr = lattice.guide(m + lattice.offset(e.right())) - za;
            const auto left = scalar::face_of<float, C>(v.x, v.y, l.x, l.y, de, dl);
            const auto right = scalar::face_of<float, C>(r.x, r.y, v.x, v.y, dr, de);
            sum += double(C::between(left, right, v.x, v.y));
        });
        return sum;
    });
}

} // namespace ddt
