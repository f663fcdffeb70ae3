// SPDX-License-Identifier: Apache-2.0
// Rounds of consistency on a whole lattice at once, for tests and tools that look at the stages.
// Jobs are worked on row by row, by CorrectedRows.
#pragma once

#include <vector>

#include "core/surface/consistency/consistency.h"

namespace ddt {

/// One group's source values, and rounds on a whole lattice, whose edges must all be there.
class Consistency {
public:
    /// Take the net's vertices as the source.
    void begin(const Lattice& lattice, const ControlNet& net, const Correction& correction);

    /// The first half of correct(): find the surface's means, and leave the vertices as they are.
    void measure(const Lattice& lattice, Surface surface, const ControlNet& net);

    /// One round.
    void correct(const Lattice& lattice, Surface surface, ControlNet& net);

    // ControlNet::count() floats a pixel.
    std::vector<float> source;
    std::vector<float> sum; ///< of the quadrants' means

private:
    size_t row_size(const Lattice& lattice) const {
        return size_t(lattice.width()) * size_t(m_count);
    }
    float* row(const Lattice& lattice, int y) {
        return source.data() + size_t(y) * row_size(lattice);
    }

    int m_count = 0; ///< of channels
    Correction m_correction;
    CrossedRows m_crossed;
    MeanScratch m_scratch;
};

} // namespace ddt
