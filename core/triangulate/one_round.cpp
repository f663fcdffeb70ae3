// SPDX-License-Identifier: Apache-2.0
#include "core/triangulate/gain.h"
#include "core/triangulate/start_gains.h"
#include "core/triangulate/triangulate.h"

namespace ddt {

namespace {

/// The first better candidate found in the 2-region of the edge at m, or -1 if m is the best.
int find_blocker(const Lattice& lattice, const std::vector<float>& gain, int m) {
    const float own = gain[size_t(m)];
    int blocker = -1;
    lattice.any_of_region(m, [&](int other) {
        const float g = gain[size_t(other)];
        const bool better = g > own || (g == own && other < m);
        blocker = better ? other : -1;
        return better;
    });
    return blocker;
}

/// Put those of the edges that `each` calls its argument with that can be flipped into w.flippable;
/// there are at most `count`. Without branches, since half of them can.
template <class Each>
void find_flippable(const Lattice& lattice, size_t count, Each&& each, Workspace& w) {
    w.flippable.resize(count);
    int* out = w.flippable.data();
    each([&](int m) {
        w.gain[size_t(m)] = no_gain;
        *out = m;
        out += lattice.edge(m).flippable();
    });
    w.flippable.resize(size_t(out - w.flippable.data()));
}

/// Evaluate the flippable edges; those above min_gain become candidates.
void evaluate(const Lattice& lattice, const Criterion& criterion, float min_gain, Workspace& w,
              Statistics& statistics) {
    gains(lattice, criterion, w.flippable.data(), w.flippable.size(), w.gain.data());
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
void wake_blocked(const Lattice& lattice, uint8_t iteration, Workspace& w) {
    size_t kept = 0;
    for (const auto& b : w.blocked) {
        if (lattice.edge(b.site).stamp == iteration)
            continue; // evaluated, so among the candidates if it still is one
        if (lattice.edge(b.blocker).stamp == iteration)
            w.candidates.push_back(b.site);
        else
            w.blocked[kept++] = b;
    }
    w.blocked.resize(kept);
}

/// Flip the selected edges and collect what must be evaluated again: their 2-regions.
void flip_selected(Lattice& lattice, uint8_t next_iteration, Workspace& w) {
    w.dirty.clear();
    const auto touch = [&](int m) {
        Edge& e = lattice.edge(m);
        if (e.stamp != next_iteration) {
            e.stamp = next_iteration;
            w.dirty.push_back(m);
        }
    };
    for (const int m : w.selected)
        lattice.flip(m);
    for (const int m : w.selected) {
        touch(m);
        lattice.each_of_region(m, touch);
    }
}

} // namespace

void one_round(Lattice& lattice, const Criterion& criterion, float min_gain, int max_iterations,
               Workspace& w, Statistics& statistics) {
    w.gain.resize(lattice.size());
    w.blocked.clear();
    const auto all = [&](auto&& f) { lattice.each_edge(f); };
    const auto dirty = [&](auto&& f) {
        for (const int m : w.dirty)
            f(m);
    };
    // One more than there are, since a place is written before it is known to be taken.
    const size_t pixels = size_t(lattice.width()) * size_t(lattice.height());
    // Whether w.gain of w.flippable is to be found yet.
    bool stale = max_iterations < 1 || !start_gains(lattice, criterion, min_gain, w, statistics);
    if (stale)
        find_flippable(lattice, 3 * pixels + 1, all, w);
    for (int iteration = 1; iteration <= max_iterations; ++iteration) {
        const auto stamp = uint8_t(iteration);
        if (stale)
            evaluate(lattice, criterion, min_gain, w, statistics);
        stale = false;
        wake_blocked(lattice, stamp, w);
        if (w.candidates.empty())
            break;
        w.selected.clear();
        for (const int m : w.candidates) {
            const int blocker = find_blocker(lattice, w.gain, m);
            if (blocker < 0)
                w.selected.push_back(m);
            else
                w.blocked.push_back({m, blocker});
        }
        flip_selected(lattice, uint8_t(iteration + 1), w);
        find_flippable(lattice, w.dirty.size() + 1, dirty, w);
        stale = true;
        statistics.flips += int64_t(w.selected.size());
        if (statistics.iterations < iteration)
            statistics.iterations = iteration;
        if (!w.go_on(w.dirty.size(), lattice.size()))
            break;
    }
    if (stale)
        gains(lattice, criterion, w.flippable.data(), w.flippable.size(), w.gain.data());
}

} // namespace ddt
