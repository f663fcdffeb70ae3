// SPDX-License-Identifier: Apache-2.0
// The definition of one_round() of core/triangulate/schemes.h.
#pragma once

#include <algorithm>
#include <iterator>

#include "core/triangulate/gain.h"
#include "core/triangulate/regions.h"
#include "core/triangulate/schemes.h"
#include "core/triangulate/start_gains.h"

namespace ddt {

namespace one_round_steps {

/// Edges that are evaluated at a time, about: lists of all that a round touches would be as long as
/// the mesh, and a few are still in the caches.
constexpr size_t edges_at_once = 1024;
/// What is touched between two looks at how many there are.
constexpr size_t touched_at_once = size_t(regions_at_once) * most_in_region;

/// A list of edges to evaluate.
class Dirty {
public:
    size_t size() const { return m_size; }
    bool full() const { return m_size >= edges_at_once; }
    void clear() { m_size = 0; }
    /// Add m if `add`, to a list that was not full before the regions that m is of. Without a
    /// branch: whether an edge was met before is anyone's guess.
    void add(int m, bool add = true) {
        m_edges[m_size] = m;
        m_size += add;
    }
    const int* begin() const { return m_edges; }
    const int* end() const { return m_edges + m_size; }

private:
    size_t m_size = 0;
    int m_edges[edges_at_once + touched_at_once];
};

/// Of any mesh; twin of the Lattice's. Without branches, since half of the edges can be flipped;
/// `candidates` holds those that can before it holds those that gain.
template <class Mesh>
Evaluated find_candidates(const Mesh& mesh, const Criterion& criterion, float min_gain,
                          const int* sites, size_t n, std::vector<float>& gain, int* candidates) {
    Evaluated found;
    for (size_t i = 0; i < n; ++i) {
        gain[size_t(sites[i])] = no_gain;
        candidates[found.flippable] = sites[i];
        found.flippable += mesh.flippable(sites[i]);
    }
    gains(mesh, criterion, candidates, found.flippable, gain.data());
    for (size_t i = 0; i < found.flippable; ++i) {
        const int m = candidates[i];
        candidates[found.candidates] = m;
        found.candidates += gain[size_t(m)] > min_gain;
    }
    return found;
}

/// Find the gains of the edges in `dirty`, which is emptied; those above min_gain become
/// candidates. Returns how many could be flipped.
template <class Mesh>
int64_t evaluate(const Mesh& mesh, const Criterion& criterion, float min_gain, Dirty& dirty,
                 Workspace& w) {
    const size_t before = w.candidates.size();
    w.candidates.resize(before + dirty.size() + candidate_padding);
    const Evaluated found = find_candidates(mesh, criterion, min_gain, dirty.begin(), dirty.size(),
                                            w.gain, w.candidates.data() + before);
    w.candidates.resize(before + found.candidates);
    dirty.clear();
    return int64_t(found.flippable);
}

/// A candidate that waits is looked at again when its blocker was evaluated again and no longer
/// goes before it. Nothing else can free it: a flip in its region would have made the candidate
/// itself dirty.
template <class Mesh>
void wake_blocked(const Mesh& mesh, uint8_t iteration, Workspace& w) {
    size_t kept = 0;
    for (const auto& b : w.blocked) {
        if (mesh.stamp(b.site) == iteration)
            continue; // evaluated, so among the candidates if it still is one
        if (mesh.stamp(b.blocker) == iteration && !goes_before(w.gain, b.blocker, b.site))
            w.candidates.push_back(b.site);
        else
            w.blocked[kept++] = b;
    }
    w.blocked.resize(kept);
}

/// Divide the candidates into those that are the best of their regions, w.selected, and others.
template <class Mesh>
void select(const Mesh& mesh, Workspace& w) {
    int blockers[256];
    w.selected.clear();
    for (size_t i = 0; i < w.candidates.size(); i += std::size(blockers)) {
        const int* sites = w.candidates.data() + i;
        const size_t n = std::min(w.candidates.size() - i, std::size(blockers));
        find_blockers(mesh, w.gain, sites, n, blockers);
        for (size_t k = 0; k < n; ++k)
            if (blockers[k] < 0)
                w.selected.push_back(sites[k]);
            else
                w.blocked.push_back({sites[k], blockers[k]});
    }
}

/// Flip the selected edges and evaluate again what must be: their 2-regions. `touched` receives
/// how many edges those have. Returns as evaluate() does.
template <class Mesh>
int64_t flip_selected(Mesh& mesh, const Criterion& criterion, float min_gain,
                      uint8_t next_iteration, Workspace& w, size_t& touched) {
    int64_t evaluated = 0;
    touched = 0;
    w.candidates.clear();
    Dirty dirty;
    const auto evaluate_dirty = [&] {
        touched += dirty.size();
        evaluated += evaluate(mesh, criterion, min_gain, dirty, w);
    };
    const auto touch = [&](int m) {
        uint8_t& stamp = mesh.stamp(m);
        dirty.add(m, stamp != next_iteration);
        stamp = next_iteration;
    };
    for (const int m : w.selected)
        mesh.flip(m);
    int regions[touched_at_once];
    for (size_t i = 0; i < w.selected.size();) {
        const size_t n = find_regions(mesh, w.selected.data() + i, w.selected.size() - i, regions);
        for (size_t k = 0; k < n * most_in_region; ++k)
            touch(regions[k]);
        i += n;
        if (dirty.full())
            evaluate_dirty();
    }
    evaluate_dirty();
    return evaluated;
}

/// Evaluate all edges.
template <class Mesh>
int64_t evaluate_all(const Mesh& mesh, const Criterion& criterion, float min_gain, Workspace& w) {
    int64_t evaluated = 0;
    w.candidates.clear();
    Dirty dirty;
    mesh.each_edge([&](int m) {
        dirty.add(m);
        if (dirty.full())
            evaluated += evaluate(mesh, criterion, min_gain, dirty, w);
    });
    return evaluated + evaluate(mesh, criterion, min_gain, dirty, w);
}

} // namespace one_round_steps

template <class Mesh>
void one_round(Mesh& mesh, const Criterion& criterion, float min_gain, int max_iterations,
               Workspace& w, Statistics& statistics) {
    using namespace one_round_steps;
    w.gain.resize(mesh.size());
    w.blocked.clear();
    // Of edges whose gains are known, and are not counted yet.
    int64_t evaluated = 0;
    if (max_iterations < 1 || !start_gains(mesh, criterion, min_gain, w, statistics))
        evaluated = evaluate_all(mesh, criterion, min_gain, w);
    for (int iteration = 1; iteration <= max_iterations; ++iteration) {
        const auto stamp = uint8_t(iteration);
        statistics.evaluations += evaluated;
        evaluated = 0;
        wake_blocked(mesh, stamp, w);
        if (w.candidates.empty())
            break;
        select(mesh, w);
        size_t touched = 0;
        evaluated = flip_selected(mesh, criterion, min_gain, uint8_t(iteration + 1), w, touched);
        statistics.flips += int64_t(w.selected.size());
        if (statistics.iterations < iteration)
            statistics.iterations = iteration;
        if (!w.go_on(touched, mesh.size()))
            break;
    }
}

} // namespace ddt
