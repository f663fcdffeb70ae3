// SPDX-License-Identifier: Apache-2.0
// Candidates: edges that gain enough.
#pragma once

#include "core/triangulate/gain.h"
#include "core/triangulate/triangulate.h"

namespace ddt {

/// Find the gains of the edges w.candidates[first..); those above min_gain stay candidates. Returns
/// how many gains were found.
template <class Mesh>
int64_t evaluate(Mesh& mesh, const Criterion& criterion, float min_gain, size_t first,
                 Workspace& w) {
    const size_t n = w.candidates.size() - first;
    w.candidates.resize(first + n + candidate_padding);
    const size_t found = find_candidates(mesh, criterion, min_gain, w.candidates.data() + first, n);
    w.candidates.resize(first + found);
    return int64_t(n);
}

/// Evaluate all edges.
template <class Mesh>
int64_t evaluate_all(Mesh& mesh, const Criterion& criterion, float min_gain, Workspace& w) {
    constexpr size_t at_once = 1024; // a list of all would be as long as the mesh
    int64_t evaluated = 0;
    w.candidates.clear();
    size_t first = 0;
    mesh.each_edge([&](int m) {
        mesh.touch(m); // clears the gain of an edge that is no longer flippable
        if (!mesh.flippable(m))
            return;
        w.candidates.push_back(m);
        if (w.candidates.size() - first < at_once)
            return;
        evaluated += evaluate(mesh, criterion, min_gain, first, w);
        first = w.candidates.size();
    });
    return evaluated + evaluate(mesh, criterion, min_gain, first, w);
}

} // namespace ddt
