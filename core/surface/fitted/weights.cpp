// SPDX-License-Identifier: Apache-2.0
#include "core/surface/fitted/weights.h"

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
    const auto difference = [](auto& nodes, int k, int i) {
        return k == 0 ? nodes[k][i] : nodes[k][i] - nodes[k - 1][i];
    };
    for (int k = 0; k < fitted_nodes; ++k) {
        t.node[k] = fitted_node[k];
        for (int i = 0; i < fitted_vertex_features; ++i)
            t.vertex[k][i] = difference(weights.vertex, k, i);
        for (int i = 0; i < fitted_edge_shared; ++i)
            t.shared[k][i] = difference(weights.shared, k, i);
        for (int length = 0; length < fitted_lengths; ++length)
            for (int kind = 0; kind < fitted_kinds; ++kind)
                for (int i = 0; i < fitted_edge_null; ++i)
                    t.null[length][kind][k][i] = difference(weights.null[length][kind], k, i);
    }
    return t;
}

const FittedTable& fitted_table() {
    static const FittedTable table = table_of(fitted_weights);
    return table;
}

} // namespace ddt
