// SPDX-License-Identifier: Apache-2.0
// The definition of one_round() of core/triangulate/schemes.h.
#pragma once

#include <algorithm>
#include <iterator>

#include "core/triangulate/candidates.h"
#include "core/triangulate/regions.h"
#include "core/triangulate/schemes.h"
#include "core/triangulate/start_gains.h"

namespace ddt {

namespace one_round_steps {

/// Divide the candidates into those that are the best of their regions, w.selected, and others.
template <class Mesh>
void select(const Mesh& mesh, Workspace& w) {
    int blockers[regions_at_once], best[regions_at_once];
    Workspace::Blocked others[regions_at_once];
    w.selected.clear();
    for (size_t i = 0; i < w.candidates.size(); i += regions_at_once) {
        const int* sites = w.candidates.data() + i;
        const size_t n = std::min(w.candidates.size() - i, regions_at_once);
        find_blockers(mesh, sites, n, blockers);
        // Branch-free: the branches would be mispredicted.
        size_t selected = 0, blocked = 0;
        for (size_t k = 0; k < n; ++k) {
            const bool waits = blockers[k] >= 0;
            best[selected] = sites[k];
            others[blocked] = {sites[k], blockers[k]};
            selected += !waits;
            blocked += waits;
        }
        append(w.selected, best, selected);
        append(w.blocked, others, blocked);
    }
}

/// Flip edges outside each other's 2-regions.
template <class Mesh>
void flip_all(Mesh& mesh, const ArenaVector<int>& edges) {
    for (const int m : edges)
        mesh.flip(m);
}
inline void flip_all(Lattice& lattice, const ArenaVector<int>& edges) {
    lattice.flip_all(edges.data(), edges.size());
}

/// Flip the selected edges; w.candidates receives what must be evaluated again, their 2-regions,
/// which are touched.
template <class Mesh>
void flip_selected(Mesh& mesh, Workspace& w) {
    w.candidates.clear();
    flip_all(mesh, w.selected);
    int edges[regions_at_once * most_in_region + region_padding];
    for (size_t i = 0; i < w.selected.size(); i += regions_at_once) {
        const size_t n = std::min(w.selected.size() - i, regions_at_once);
        const size_t found = find_settled(mesh, w.selected.data() + i, n, edges);
        // Branch-free: a branch on whether an edge was met before would be mispredicted.
        size_t touched = 0;
        for (size_t k = 0; k < found; ++k) {
            const int m = edges[k];
            edges[touched] = m;
            touched += mesh.touch(m);
        }
        append(w.candidates, edges, touched);
    }
}

/// A candidate that waits is looked at again when its blocker has been evaluated again and no
/// longer goes before it. Nothing else can free it: a flip in its region would have touched the
/// candidate itself, and it is among the candidates if it still is one.
///
/// Before the touched are evaluated: forget candidates that are touched themselves, and move those
/// whose blockers are to w.again.
template <class Mesh>
void sort_blocked(const Mesh& mesh, Workspace& w) {
    Workspace::Blocked again[256];
    size_t kept = 0;
    for (size_t i = 0; i < w.blocked.size();) {
        const size_t end = std::min(w.blocked.size(), i + std::size(again));
        // Branch-free: the branches would be mispredicted.
        size_t number = 0;
        for (; i < end; ++i) {
            const Workspace::Blocked b = w.blocked[i];
            const bool own = mesh.settled(b.site), blocker = mesh.settled(b.blocker);
            w.blocked[kept] = again[number] = b;
            kept += own & blocker;
            number += own & !blocker;
        }
        append(w.again, again, number);
    }
    w.blocked.resize(kept);
}

/// Afterwards: add those that are free to the candidates.
template <class Mesh>
void wake_blocked(const Mesh& mesh, Workspace& w) {
    for (const Workspace::Blocked b : w.again)
        if (goes_before(mesh, b.blocker, b.site))
            w.blocked.push_back(b);
        else
            w.candidates.push_back(b.site);
    w.again.clear();
}

} // namespace one_round_steps

template <class Mesh>
void one_round(Mesh& mesh, const Criterion& criterion, float min_gain, int max_iterations,
               Workspace& w, Statistics& statistics) {
    using namespace one_round_steps;
    w.reserve(mesh.vertices());
    w.blocked.clear();
    w.again.clear();
    // Of edges whose gains are known, and are not counted yet.
    int64_t evaluated = 0;
    if (max_iterations < 1 || !start_gains(mesh, criterion, min_gain, w, statistics))
        evaluated = evaluate_all(mesh, criterion, min_gain, w);
    for (int iteration = 1; iteration <= max_iterations; ++iteration) {
        statistics.evaluations += evaluated;
        wake_blocked(mesh, w);
        if (w.candidates.empty())
            break;
        select(mesh, w);
        flip_selected(mesh, w);
        sort_blocked(mesh, w);
        evaluated = evaluate(mesh, criterion, min_gain, 0, w);
        statistics.flips += int64_t(w.selected.size());
        if (statistics.iterations < iteration)
            statistics.iterations = iteration;
        if (!w.go_on(size_t(evaluated), mesh.size()))
            break;
    }
}

} // namespace ddt
