// SPDX-License-Identifier: Apache-2.0
// The definition of look_ahead() of core/triangulate/schemes.h.
#pragma once

#include "core/lattice/region.h"
#include "core/triangulate/gain.h"
#include "core/triangulate/schemes.h"

namespace ddt {

template <class CostOfFloat, class Mesh>
class LookAhead {
public:
    LookAhead(Mesh& mesh, float contour, float min_gain, Statistics& statistics)
        : m_mesh(mesh), m_contour(contour), m_min_gain(min_gain), m_statistics(statistics),
          m_changed(mesh.size(), 1) {}

    /// Treat every edge to which something has changed since it was last looked at. Returns the
    /// number of flips.
    int64_t sweep() {
        const int64_t before = m_statistics.flips;
        m_mesh.each_edge([&](int m) {
            if (!m_changed[size_t(m)])
                return;
            m_changed[size_t(m)] = 0;
            if (m_mesh.flippable(m))
                treat(m);
        });
        return m_statistics.flips - before;
    }

private:
    float gain(int m) {
        ++m_statistics.evaluations;
        return gain_of<CostOfFloat>(m_mesh, m, m_contour);
    }

    void treat(int m) {
        const float alone = gain(m);
        m_mesh.flip(m);
        if (alone > m_min_gain) {
            flipped(m);
            return;
        }
        const int second = best_second(m, alone);
        if (second < 0) {
            m_mesh.flip_back(m);
            return;
        }
        flipped(m);
        m_mesh.flip(second);
        flipped(second);
    }

    /// The side of the parallelogram round m whose flip makes the two gain most, -1 if none does.
    int best_second(int m, float first_gain) {
        int best = -1;
        float most = m_min_gain;
        for (const int side : m_mesh.sides(m)) {
            if (!m_mesh.flippable(side))
                continue;
            const float both = first_gain + gain(side);
            if (both > most) {
                most = both;
                best = side;
            }
        }
        return best;
    }

    /// Count the flip and have all edges looked at again for which a pair's gain depends on it:
    /// those that have m in their region of degree 3. Right after the flip, while m is flippable.
    void flipped(int m) {
        ++m_statistics.flips;
        m_changed[size_t(m)] = 1;
        any_of_wide_region(m_mesh, m, [&](int other) {
            m_changed[size_t(other)] = 1;
            return false;
        });
    }

    Mesh& m_mesh;
    const float m_contour, m_min_gain;
    Statistics& m_statistics;
    std::vector<uint8_t> m_changed; ///< an edge
};

template <class Mesh>
void look_ahead(Mesh& mesh, const Criterion& criterion, float min_gain, int max_sweeps,
                const Workspace& workspace, Statistics& statistics) {
    dispatch(criterion.cost, [&](auto which) {
        LookAhead<decltype(which), Mesh> scheme(mesh, criterion.contour, min_gain, statistics);
        for (int sweep = 1; sweep <= max_sweeps; ++sweep) {
            const int64_t flips = scheme.sweep();
            if (statistics.iterations < sweep)
                statistics.iterations = sweep;
            if (flips == 0 || !workspace.go_on(size_t(flips), mesh.size()))
                break;
        }
    });
}

} // namespace ddt
