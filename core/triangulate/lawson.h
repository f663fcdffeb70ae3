// SPDX-License-Identifier: Apache-2.0
// The definition of lawson() of core/triangulate/schemes.h.
#pragma once

#include "core/triangulate/gain.h"
#include "core/triangulate/schemes.h"

namespace ddt {

template <class Mesh>
void lawson(Mesh& mesh, Cost cost, float min_gain, int max_sweeps, const Workspace& workspace,
            Statistics& statistics) {
    dispatch(cost, [&](auto which) {
        for (int sweep = 0; sweep < max_sweeps; ++sweep) {
            int64_t flips = 0;
            mesh.each_edge([&](int m) {
                if (!mesh.flippable(m))
                    return;
                ++statistics.evaluations;
                if (gain_of<decltype(which)>(mesh, m) > min_gain) {
                    mesh.flip(m);
                    ++flips;
                }
            });
            statistics.flips += flips;
            if (statistics.iterations <= sweep)
                statistics.iterations = sweep + 1;
            if (flips == 0 || !workspace.go_on(size_t(flips), mesh.size()))
                break;
        }
    });
}

} // namespace ddt
