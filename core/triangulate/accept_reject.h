// SPDX-License-Identifier: Apache-2.0
// The definition of accept_reject() of core/triangulate/schemes.h.
#pragma once

#include "core/lattice/region.h"
#include "core/triangulate/gain.h"
#include "core/triangulate/regions.h"
#include "core/triangulate/schemes.h"

namespace ddt {

template <class Mesh>
class AcceptReject {
public:
    AcceptReject(Mesh& mesh, const Criterion& criterion, float min_gain, const Rules& rules,
                 Workspace& w, Statistics& statistics)
        : m_mesh(mesh), m_criterion(criterion), m_min_gain(min_gain), m_rules(rules), m_w(w),
          m_statistics(statistics), m_marks(mesh.size(), idle) {
        m_w.reserve_for_all(mesh.vertices());
        m_w.candidates.clear();
        m_w.dirty.clear();
        mesh.each_edge([&](int m) { touch(m); });
    }

    /// False if there was nothing to flip.
    bool iterate(int iteration) {
        evaluate();
        if (m_w.candidates.empty())
            return false;
        m_wide = iteration <= m_rules.wide_iterations;
        select();
        flip();
        return true;
    }

private:
    enum Mark : uint8_t { idle, dirty, untreated, accepted, rejected };
    Mark& mark(int m) { return m_marks[size_t(m)]; }

    void touch(int m) {
        if (mark(m) != dirty) {
            mark(m) = dirty;
            m_w.dirty.push_back(m);
        }
    }

    /// Evaluate the dirty edges; keep the candidates that are not, add those that become some.
    void evaluate() {
        size_t kept = 0;
        for (const int m : m_w.candidates)
            if (mark(m) != dirty)
                m_w.candidates[kept++] = m;
        m_w.candidates.resize(kept);
        m_w.flippable.clear();
        for (const int m : m_w.dirty) {
            mark(m) = idle;
            if (m_mesh.flippable(m))
                m_w.flippable.push_back(m);
        }
        find_gains(m_mesh, m_criterion, m_w.flippable.data(), m_w.flippable.size());
        m_statistics.evaluations += int64_t(m_w.flippable.size());
        for (const int m : m_w.flippable)
            if (m_mesh.gain(m) > m_min_gain)
                m_w.candidates.push_back(m);
    }

    template <class F>
    bool any_of_region(int m, F&& f) const {
        return m_wide ? any_of_wide_region(m_mesh, m, f) : m_mesh.any_of_region(m, f);
    }

    /// Whether candidate m comes before n.
    bool comes_before(int m, int n) const {
        return m_rules.by_gain ? goes_before(m_mesh, m, n) : m < n;
    }

    /// An untreated candidate in m's region that comes before m, or -1.
    int find_untreated_blocker(int m) {
        int blocker = -1;
        any_of_region(m, [&](int other) {
            if (mark(other) != untreated || !comes_before(other, m))
                return false;
            blocker = other;
            return true;
        });
        return blocker;
    }

    /// Rounds of accepting and rejecting; the accepted are in m_w.selected.
    void select() {
        m_w.selected.clear();
        m_w.blocked.clear();
        for (const int m : m_w.candidates) {
            mark(m) = untreated;
            m_w.blocked.push_back({m, -1});
        }
        do {
            const size_t first = m_w.selected.size();
            accept();
            for (size_t i = first; i < m_w.selected.size(); ++i)
                reject_region(m_w.selected[i]);
            ++m_statistics.rounds;
        } while (!m_w.blocked.empty());
    }

    /// Move every candidate that nothing blocks from m_w.blocked to m_w.selected. All see the marks
    /// as they were before the round, as if treated at once.
    void accept() {
        size_t kept = 0;
        for (auto& waiting : m_w.blocked) {
            if (mark(waiting.site) != untreated)
                continue;
            if (waiting.blocker < 0 || mark(waiting.blocker) != untreated)
                waiting.blocker = find_untreated_blocker(waiting.site);
            if (waiting.blocker < 0)
                m_w.selected.push_back(waiting.site);
            else
                m_w.blocked[kept++] = waiting;
        }
        m_w.blocked.resize(kept);
    }

    void reject_region(int winner) {
        mark(winner) = accepted;
        any_of_region(winner, [&](int other) {
            if (mark(other) == untreated)
                mark(other) = rejected;
            return false;
        });
    }

    /// Flip the selected and collect what must be evaluated again: their 2-regions.
    void flip() {
        for (const int m : m_w.candidates)
            mark(m) = idle;
        m_w.dirty.clear();
        for (const int m : m_w.selected)
            m_mesh.flip(m);
        for (const int m : m_w.selected) {
            touch(m);
            m_mesh.each_of_region(m, [&](int other) { touch(other); });
        }
        m_statistics.flips += int64_t(m_w.selected.size());
    }

    Mesh& m_mesh;
    const Criterion m_criterion;
    const float m_min_gain;
    const Rules m_rules;
    bool m_wide = false; ///< in this iteration
    Workspace& m_w;
    Statistics& m_statistics;
    std::vector<Mark> m_marks; ///< an edge
};

template <class Mesh>
void accept_reject(Mesh& mesh, const Criterion& criterion, float min_gain, int max_iterations,
                   const Rules& rules, Workspace& workspace, Statistics& statistics) {
    AcceptReject<Mesh> scheme(mesh, criterion, min_gain, rules, workspace, statistics);
    for (int i = 1; i <= max_iterations && scheme.iterate(i); ++i) {
        if (statistics.iterations < i)
            statistics.iterations = i;
        if (!workspace.go_on(workspace.dirty.size(), mesh.size()))
            break;
    }
}

} // namespace ddt
