// SPDX-License-Identifier: Apache-2.0
#include "core/triangulate/gain.h"
#include "core/triangulate/triangulate.h"

namespace ddt {

void lawson(Lattice& lattice, const Criterion& criterion, float min_gain, int max_sweeps,
            const Workspace& workspace, Statistics& statistics) {
    dispatch(criterion.cost, [&](auto which) {
        for (int sweep = 0; sweep < max_sweeps; ++sweep) {
            int64_t flips = 0;
            lattice.each_edge([&](int m) {
                if (!lattice.edge(m).flippable())
                    return;
                ++statistics.evaluations;
                if (scalar::gain<decltype(which)>(lattice, m, criterion.contour) > min_gain) {
                    lattice.flip(m);
                    ++flips;
                }
            });
            statistics.flips += flips;
            if (statistics.iterations <= sweep)
                statistics.iterations = sweep + 1;
            if (flips == 0 || !workspace.go_on(size_t(flips), lattice.size()))
                break;
        }
    });
}

} // namespace ddt
