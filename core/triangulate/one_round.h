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
constexpr size_t touched_at_once = regions_at_once * most_in_region;

/// A list of edges to evaluate.
class Dirty {
public:
    size_t size() const { return m_size; }
    bool full() const { return m_size >= edges_at_once; }
    void clear() { m_size = 0; }
    void add(int m) { m_edges[m_size++] = m; }
    /// Add those of no more than touched_at_once edges that are not stamped so, and stamp them; to
    /// a list that is not full. Without a branch: whether an edge was met before is anyone's guess.
    template <class Mesh>
    void add_unstamped(Mesh& mesh, const int* edges, size_t n, uint8_t iteration) {
        size_t size = m_size; // stamps are bytes, which the compiler thinks might be m_size's
        for (size_t i = 0; i < n; ++i) {
            const int m = edges[i];
            uint8_t& stamp = mesh.stamp(m);
            m_edges[size] = m;
            size += stamp != iteration;
            stamp = iteration;
        }
        m_size = size;
    }
    const int* begin() const { return m_edges; }
    const int* end() const { return m_edges + m_size; }

private:
    size_t m_size = 0;
    int m_edges[edges_at_once + touched_at_once];
};

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
    Workspace::Blocked again[256];
    Workspace::Blocked* const all = w.blocked.data();
    const size_t size = w.blocked.size();
    size_t kept = 0;
    for (size_t i = 0; i < size;) {
        // Without branches, which would be guesses, and each of which would wait for its stamps.
        const size_t end = std::min(size, i + std::size(again));
        size_t number = 0;
        for (; i < end; ++i) {
            const auto b = all[i];
            // Evaluated, so among the candidates if it still is one.
            const bool own = mesh.stamp(b.site) == iteration;
            const bool others = mesh.stamp(b.blocker) == iteration;
            all[kept] = again[number] = b;
            kept += !(own | others);
            number += !own & others;
        }
        for (size_t k = 0; k < number; ++k)
            if (goes_before(w.gain, again[k].blocker, again[k].site))
                all[kept++] = again[k];
            else
                w.candidates.push_back(again[k].site);
    }
    w.blocked.resize(kept);
}

/// Make a vector longer by n; its memory doubles as by push_back(), not by what resize() thinks of.
template <class T>
void add_room(std::vector<T>& v, size_t n) {
    const size_t size = v.size() + n;
    if (size > v.capacity())
        v.reserve(std::max(size, 2 * v.capacity()));
    v.resize(size);
}

/// Divide the candidates into those that are the best of their regions, w.selected, and others.
template <class Mesh>
void select(const Mesh& mesh, Workspace& w) {
    int blockers[regions_at_once];
    w.selected.clear();
    for (size_t i = 0; i < w.candidates.size(); i += regions_at_once) {
        const int* sites = w.candidates.data() + i;
        const size_t n = std::min(w.candidates.size() - i, regions_at_once);
        find_blockers(mesh, w.gain, sites, n, blockers);
        // Without branches, which would be guesses.
        size_t best = w.selected.size(), waiting = w.blocked.size();
        add_room(w.selected, n);
        add_room(w.blocked, n);
        for (size_t k = 0; k < n; ++k) {
            const bool blocked = blockers[k] >= 0;
            w.selected[best] = sites[k];
            w.blocked[waiting] = {sites[k], blockers[k]};
            best += !blocked;
            waiting += blocked;
        }
        w.selected.resize(best);
        w.blocked.resize(waiting);
    }
}

/// Flip edges outside each other's 2-regions.
template <class Mesh>
void flip_all(Mesh& mesh, const std::vector<int>& edges) {
    for (const int m : edges)
        mesh.flip(m);
}
inline void flip_all(Lattice& lattice, const std::vector<int>& edges) {
    lattice.flip_all(edges.data(), edges.size());
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
    flip_all(mesh, w.selected);
    int regions[touched_at_once];
    for (size_t i = 0; i < w.selected.size(); i += regions_at_once) {
        const size_t n = std::min(w.selected.size() - i, regions_at_once);
        find_regions(mesh, w.selected.data() + i, n, regions);
        dirty.add_unstamped(mesh, regions, n * most_in_region, next_iteration);
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
