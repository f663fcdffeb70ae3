// SPDX-License-Identifier: Apache-2.0
// Any scheme on any mesh.
#pragma once

#include "core/triangulate/accept_reject.h"
#include "core/triangulate/annealing.h"
#include "core/triangulate/lawson.h"
#include "core/triangulate/look_ahead.h"
#include "core/triangulate/one_round.h"

namespace ddt {

/// Flip edges of a mesh by options.scheme. Adds to `statistics`.
template <class Mesh>
void run_scheme(Mesh& mesh, const MeshOptions& options, Workspace& workspace,
                Statistics& statistics) {
    const Criterion by = criterion(options);
    const float threshold = min_gain(options);
    const int iterations = options.max_iterations;
    statistics.pixels += int64_t(mesh.vertices());
    switch (options.scheme) {
    case Scheme::one_round:
        return one_round(mesh, by, threshold, iterations, workspace, statistics);
    case Scheme::lawson:
        return lawson(mesh, by, threshold, iterations, workspace, statistics);
    case Scheme::look_ahead:
        return look_ahead(mesh, by, threshold, iterations, workspace, statistics);
    case Scheme::annealing:
        return annealing(mesh, by, threshold, iterations, options.seed, workspace, statistics);
    case Scheme::basic:
    case Scheme::exproi:
    case Scheme::maxgain:
    case Scheme::exproi_maxgain:
    case Scheme::exproi_n_maxgain:
        return accept_reject(mesh, by, threshold, iterations, find_rules(options).value(),
                             workspace, statistics);
    case Scheme::pixel:
        return; // the starting mesh is the result
    }
}

} // namespace ddt
