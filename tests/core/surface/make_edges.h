// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/surface/edge_maker.h"

namespace ddt::test {

/// All edges of a part at once: see EdgeMaker.
inline void make_edges(const Lattice& lattice, const Rect& part, bool bend, bool soft, float tau,
                       EdgeMaker& edges, ControlNet& net) {
    edges.begin(lattice, part, bend, soft, tau, net);
    edges.finish();
}

} // namespace ddt::test
