// SPDX-License-Identifier: Apache-2.0
// A guide's mesh from the start to the end, with what it cost on the way.
#pragma once

#include "core/triangulate/gain.h"
#include "core/triangulate/triangulate.h"
#include "tests/core/helpers.h"

namespace ddt::test {

struct Result {
    Lattice lattice;
    Statistics statistics;
    double cost_start, cost;
};

inline Result run(const std::vector<float>& guide, int width, int height,
                  const MeshOptions& options) {
    Result r;
    Workspace workspace;
    start(r.lattice, width, height, guide.data(), options);
    r.cost_start = total_cost(r.lattice, options.cost);
    triangulate(r.lattice, options, workspace, r.statistics);
    r.cost = total_cost(r.lattice, options.cost);
    return r;
}

} // namespace ddt::test
