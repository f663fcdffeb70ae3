// SPDX-License-Identifier: Apache-2.0
// The numbers of fitted bends and vertices (see fitted.h).
#pragma once

namespace ddt {

constexpr int fitted_nodes = 4;           ///< of the index that weights depend on
constexpr int fitted_vertex_features = 6; ///< VertexFeatures::f
constexpr int fitted_edge_shared = 4;     ///< EdgeFeatures::shared
constexpr int fitted_edge_null = 4;       ///< EdgeFeatures::null
constexpr int fitted_lengths = 3;         ///< classes of edges: |v|^2 is 1, 2, more
/// In each class, of edges that cannot be flipped, of those that would lose much by it, and what a
/// gain of 0 adds to these.
constexpr int fitted_kinds = 3;

constexpr float fitted_node[fitted_nodes] = {0.03f, 0.09f, 0.15f, 0.21f};
constexpr float fitted_node_scale = 1.0f / 0.06f;
constexpr float fitted_index_epsilon = 1e-3f;
/// A flip that loses this much is one that loses much; less, by shares.
constexpr float fitted_gain_scale = 0.3f;
/// Black is up to 1 / 200, and white from 1 - 1 / 16 on, less with the distance from 0 or 1.
constexpr float fitted_black_scale = 200.0f, fitted_white_scale = 16.0f;
/// What a vertex at black or white may leave its range by, in units of what others may, beside it.
constexpr float fitted_bound_limit = 4.0f;
/// A bend's limit in units of the range of the edge's ends and apexes.
constexpr float fitted_bend_limit = 2.0f;

/// What the features count at the first node of the index, and what each next node adds to that.
struct FittedWeights {
    float vertex[fitted_nodes][fitted_vertex_features];
    float bound[fitted_nodes][fitted_vertex_features]; ///< beside it, at black or white
    float shared[fitted_nodes][fitted_edge_shared];
    float null[fitted_lengths][fitted_kinds][fitted_nodes][fitted_edge_null];
};

/// weights.inc, as tools/fit made it.
extern const FittedWeights fitted_weights;

/// FittedWeights with all that goes with them. The block Fitted of shaders/fitted.glsl is laid out
/// alike.
struct FittedTable {
    float node[fitted_nodes];
    float node_scale, index_epsilon, gain_scale, bend_limit;
    float black_scale, white_scale, bound_limit, unused;
    float vertex[fitted_nodes][8]; ///< 6, and nothing
    float bound[fitted_nodes][8];
    float shared[fitted_nodes][fitted_edge_shared];
    float null[fitted_lengths][fitted_kinds][fitted_nodes][fitted_edge_null];
};

FittedTable table_of(const FittedWeights& weights);
/// That of fitted_weights.
const FittedTable& fitted_table();

/// The class of an edge with this vector in pixels.
inline int fitted_length(int vx, int vy) {
    const int square = vx * vx + vy * vy;
    return square > 2 ? 2 : square - 1;
}

} // namespace ddt
