// SPDX-License-Identifier: Apache-2.0
#include "core/lattice/region.h"
#include "core/triangulate/gain.h"
#include "core/triangulate/schemes.h"

namespace ddt {

namespace {

template <class CostOfFloat>
class LookAhead {
public:
    LookAhead(Lattice& lattice, float contour, float min_gain, Statistics& statistics)
        : m_lattice(lattice), m_contour(contour), m_min_gain(min_gain), m_statistics(statistics) {
        lattice.each_edge([&](int m) { lattice.edge(m).stamp = 1; });
    }

    /// Treat every edge to which something has changed since it was last looked at (its stamp is
    /// 1). Returns the number of flips.
    int64_t sweep() {
        const int64_t before = m_statistics.flips;
        m_lattice.each_edge([&](int m) {
            Edge& e = m_lattice.edge(m);
            if (e.stamp == 0)
                return;
            e.stamp = 0;
            if (e.flippable())
                treat(m);
        });
        return m_statistics.flips - before;
    }

private:
    float gain(int m) {
        ++m_statistics.evaluations;
        return scalar::gain<CostOfFloat>(m_lattice, m, m_contour);
    }

    void treat(int m) {
        const float alone = gain(m);
        const Edge unflipped = m_lattice.edge(m);
        m_lattice.flip(m);
        if (alone > m_min_gain) {
            flipped(m);
            return;
        }
        const int second = best_second(m, alone);
        if (second < 0) {
            // A flip twice over turns the edge round; the copy makes it what it was.
            m_lattice.flip(m);
            m_lattice.edge(m) = unflipped;
            return;
        }
        flipped(m);
        m_lattice.flip(second);
        flipped(second);
    }

    /// The side of the parallelogram round m whose flip makes the two gain most, -1 if none does.
    int best_second(int m, float first_gain) {
        const Quad q(m_lattice.edge(m));
        int best = -1;
        float most = m_min_gain;
        for (int k = 0; k < 4; ++k) {
            const int side = m + m_lattice.offset(q.middle[k]);
            if (!m_lattice.edge(side).flippable())
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
        m_lattice.edge(m).stamp = 1;
        any_of_wide_region(m_lattice, m, [&](int other) {
            m_lattice.edge(other).stamp = 1;
            return false;
        });
    }

    Lattice& m_lattice;
    const float m_contour, m_min_gain;
    Statistics& m_statistics;
};

} // namespace

void look_ahead(Lattice& lattice, const Criterion& criterion, float min_gain, int max_sweeps,
                const Workspace& workspace, Statistics& statistics) {
    dispatch(criterion.cost, [&](auto which) {
        LookAhead<decltype(which)> scheme(lattice, criterion.contour, min_gain, statistics);
        for (int sweep = 1; sweep <= max_sweeps; ++sweep) {
            const int64_t flips = scheme.sweep();
            if (statistics.iterations < sweep)
                statistics.iterations = sweep;
            if (flips == 0 || !workspace.go_on(size_t(flips), lattice.size()))
                break;
        }
    });
}

} // namespace ddt
