// SPDX-License-Identifier: Apache-2.0
// A picture that was reduced, the mesh over what is left of it, and where its own pixels lie there.
#pragma once

#include <string>
#include <vector>

#include "core/lattice/lattice.h"
#include "core/surface/fitted/weights.h"
#include "tests/bench/light.h"

namespace fit {

/// A pixel of the picture: its triangle's sites and weights.
struct Sample {
    int vertex[3], edge[3];
    float b[3];
};

/// The features of one channel, a site.
struct Features {
    struct Vertex {
        float z, low, high; ///< the pixel, and the limits that it may be moved within
        float f[ddt::fitted_vertex_features], share[ddt::fitted_nodes];
        float bound; ///< VertexFeatures::bound
        bool moves;
    };
    struct Edge {
        float null[ddt::fitted_edge_null], shared[ddt::fitted_edge_shared];
        float share[ddt::fitted_nodes];
        float limit; ///< of the bend
    };
    std::vector<Vertex> vertices; ///< by site; only vertices' are filled in
    std::vector<Edge> edges;      ///< by site; only edges' are
};

/// What belongs to an edge in all channels.
struct EdgeKind {
    int length;                     ///< its class (fitted_length())
    int kind;                       ///< 0: cannot be flipped, 1: can
    float near;                     ///< how near its gain is to 0, 0 to 1
    float softness;                 ///< weight of its flipped state
    int a = 0, b = 0, c = 0, d = 0; ///< sites of its ends and apexes
};

struct Scene {
    std::string name;
    int scale = 0;
    bench::Light light = bench::Light::encoded;
    metrics::Image original; ///< display values
    ddt::Lattice lattice;
    std::vector<EdgeKind> kinds; ///< by site; only edges' are filled in
    std::vector<Sample> samples; ///< of the original's pixels, row by row
    Features features[3];
};

/// Reduce the picture by boxes in `light` and make all of the above, as ddt-sharp does. False, and
/// why, if the file cannot be used.
bool make_scene(const std::string& file, int scale, bench::Light light, Scene& scene,
                std::string& error);

} // namespace fit
