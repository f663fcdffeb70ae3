// SPDX-License-Identifier: Apache-2.0
#include "core/surface/fitted/weights.h"

#include <algorithm>
#include <cstring>

namespace ddt {

const FittedWeights fitted_weights =
#include "core/surface/fitted/weights.inc"
    ;

FittedTable table_of(const FittedWeights& weights) {
    FittedTable t = {};
    t.node_scale = fitted_node_scale;
    t.index_epsilon = fitted_index_epsilon;
    t.gain_scale = 1.0f / fitted_gain_scale;
    t.bend_limit = fitted_bend_limit;
    t.black_scale = fitted_black_scale;
    t.white_scale = fitted_white_scale;
    t.bound_limit = fitted_bound_limit;
    for (int k = 0; k < fitted_nodes; ++k) {
        t.node[k] = fitted_node[k];
        std::copy_n(weights.vertex[k], fitted_vertex_features, t.vertex[k]);
        std::copy_n(weights.bound[k], fitted_vertex_features, t.bound[k]);
    }
    std::memcpy(t.shared, weights.shared, sizeof t.shared);
    std::memcpy(t.null, weights.null, sizeof t.null);
    return t;
}

const FittedTable& fitted_table() {
    static const FittedTable table = table_of(fitted_weights);
    return table;
}

} // namespace ddt
