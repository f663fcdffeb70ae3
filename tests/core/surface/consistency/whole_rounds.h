// SPDX-License-Identifier: Apache-2.0
// Rounds of consistency on all rows of a net at once. Jobs are worked on row by row, by
// CorrectedRows (core/surface/consistency/corrected_rows.h).
#pragma once

#include <algorithm>
#include <vector>

#include "core/surface/consistency/consistency.h"

namespace ddt::test {

/// One group's source values, and rounds on a net of all rows (tests/core/surface/whole_net.h),
/// whose edges must be there.
class WholeRounds {
public:
    /// Take the net's vertices as the source.
    void begin(const Lattice& lattice, const ControlNet& net, const Correction& correction) {
        m_count = net.count();
        m_source.resize(lattice.vertices() * size_t(m_count));
        for (int y = 0; y < lattice.height(); ++y)
            std::copy_n(net.vertex(lattice.vertex_site(0, y)), row_size(lattice), row(lattice, y));
        m_correction = correction;
    }

    /// The first half of correct(): find the surface's means, and leave the vertices as they are.
    void measure(const Lattice& lattice, Surface surface, const ControlNet& net) {
        m_sum.assign(m_source.size(), 0.0f);
        m_crossed.begin(lattice, mean_positions(), 1);
        for (int y = 0; y + 1 < lattice.height(); ++y) {
            float* upper = m_sum.data() + size_t(y) * row_size(lattice);
            add_means(lattice, surface, net, lattice.all(), y, m_crossed, m_scratch, upper,
                      upper + row_size(lattice));
        }
    }

    /// One round.
    void correct(const Lattice& lattice, Surface surface, ControlNet& net) {
        measure(lattice, surface, net);
        std::vector<float> moved(row_size(lattice));
        for (int y = 1; y + 1 < lattice.height(); ++y) {
            move_row(lattice, net, 1, lattice.width() - 1, y,
                     {row(lattice, y - 1), row(lattice, y), row(lattice, y + 1)},
                     m_sum.data() + size_t(y) * row_size(lattice), m_correction, moved.data());
            std::copy(moved.begin() + m_count, moved.end() - m_count,
                      net.vertex(lattice.vertex_site(1, y)));
        }
    }

    /// The sums of the quadrants' means: ControlNet::count() floats a pixel.
    const std::vector<float>& sum() const { return m_sum; }

private:
    size_t row_size(const Lattice& lattice) const {
        return size_t(lattice.width()) * size_t(m_count);
    }
    float* row(const Lattice& lattice, int y) {
        return m_source.data() + size_t(y) * row_size(lattice);
    }

    std::vector<float> m_source, m_sum;
    int m_count = 0; ///< of channels
    Correction m_correction;
    CrossedRows m_crossed;
    MeanScratch m_scratch;
};

} // namespace ddt::test
