// SPDX-License-Identifier: Apache-2.0
// The definition of one_round() of core/triangulate/schemes.h.
#pragma once

#include "core/triangulate/gain.h"
#include "core/triangulate/schemes.h"
#include "core/triangulate/start_gains.h"

namespace ddt {

namespace one_round_steps {

/// The first better candidate found in the 2-region of the edge at m, or -1 if m is the best.
template <class Mesh>
int find_blocker(const Mesh& mesh, const std::vector<float>& gain, int m) {
    const float own = gain[size_t(m)];
    int blocker = -1;
    mesh.any_of_region(m, [&](int other) {
        const float g = gain[size_t(other)];
        const bool better = g > own || (g == own && other < m);
        blocker = better ? other : -1;
        return better;
    });
    return blocker;
}

/// Put those of the edges that `each` calls its argument with that can be flipped into w.flippable;
/// there are at most `count`. Without branches, since half of them can.
template <class Mesh, class Each>
void find_flippable(const Mesh& mesh, size_t count, Each&& each, Workspace& w) {
    w.flippable.resize(count);
    int* out = w.flippable.data();
    each([&](int m) {
        w.gain[size_t(m)] = no_gain;
        *out = m;
        out += mesh.flippable(m);
    });
    w.flippable.resize(size_t(out - w.flippable.data()));
}

/// Evaluate the flippable edges; those above min_gain become candidates.
template <class Mesh>
void evaluate(const Mesh& mesh, Cost cost, float min_gain, Workspace& w, Statistics& statistics) {
    gains(mesh, cost, w.flippable.data(), w.flippable.size(), w.gain.data());
    statistics.evaluations += int64_t(w.flippable.size());
    w.candidates.resize(w.flippable.size() + 1);
    int* out = w.candidates.data();
    for (const int m : w.flippable) {
        *out = m;
        out += w.gain[size_t(m)] > min_gain;
    }
    w.candidates.resize(size_t(out - w.candidates.data()));
}

/// A candidate that waits is looked at again when its blocker was evaluated again. Nothing else can
/// free it: a flip in its region would have made the candidate itself dirty.
template <class Mesh>
void wake_blocked(const Mesh& mesh, uint8_t iteration, Workspace& w) {
    size_t kept = 0;
    for (const auto& b : w.blocked) {
        if (mesh.stamp(b.site) == iteration)
            continue; // evaluated, so among the candidates if it still is one
        if (mesh.stamp(b.blocker) == iteration)
            w.candidates.push_back(b.site);
        else
            w.blocked[kept++] = b;
    }
    w.blocked.resize(kept);
}

/// Flip the selected edges and collect what must be evaluated again: their 2-regions.
template <class Mesh>
void flip_selected(Mesh& mesh, uint8_t next_iteration, Workspace& w) {
    w.dirty.clear();
    const auto touch = [&](int m) {
        if (mesh.stamp(m) != next_iteration) {
            mesh.stamp(m) = next_iteration;
            w.dirty.push_back(m);
        }
    };
    for (const int m : w.selected)
        mesh.flip(m);
    for (const int m : w.selected) {
        touch(m);
        mesh.each_of_region(m, touch);
    }
}

} // namespace one_round_steps

template <class Mesh>
void one_round(Mesh& mesh, Cost cost, float min_gain, int max_iterations, Workspace& w,
               Statistics& statistics) {
    using namespace one_round_steps;
    w.gain.resize(mesh.size());
    w.blocked.clear();
    const auto all = [&](auto&& f) { mesh.each_edge(f); };
    const auto dirty = [&](auto&& f) {
        for (const int m : w.dirty)
            f(m);
    };
    // One more than there are, since a place is written before it is known to be taken.
    // Whether w.gain of w.flippable is to be found yet.
    bool stale = max_iterations < 1 || !start_gains(mesh, cost, min_gain, w, statistics);
    if (stale)
        find_flippable(mesh, mesh.edges() + 1, all, w);
    for (int iteration = 1; iteration <= max_iterations; ++iteration) {
        const auto stamp = uint8_t(iteration);
        if (stale)
            evaluate(mesh, cost, min_gain, w, statistics);
        stale = false;
        wake_blocked(mesh, stamp, w);
        if (w.candidates.empty())
            break;
        w.selected.clear();
        for (const int m : w.candidates) {
            const int blocker = find_blocker(mesh, w.gain, m);
            if (blocker < 0)
                w.selected.push_back(m);
            else
                w.blocked.push_back({m, blocker});
        }
        flip_selected(mesh, uint8_t(iteration + 1), w);
        find_flippable(mesh, w.dirty.size() + 1, dirty, w);
        stale = true;
        statistics.flips += int64_t(w.selected.size());
        if (statistics.iterations < iteration)
            statistics.iterations = iteration;
        if (!w.go_on(w.dirty.size(), mesh.size()))
            break;
    }
    if (stale)
        gains(mesh, cost, w.flippable.data(), w.flippable.size(), w.gain.data());
}

} // namespace ddt
