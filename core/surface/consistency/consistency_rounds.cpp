// SPDX-License-Identifier: Apache-2.0
#include "core/surface/consistency/consistency_rounds.h"

#include <algorithm>

namespace ddt {

void Consistency::begin(const Lattice& lattice, const ControlNet& net,
                        const Correction& correction) {
    m_count = net.count();
    source.resize(lattice.vertices() * size_t(m_count));
    for (int y = 0; y < lattice.height(); ++y)
        std::copy_n(net.vertex(lattice.vertex_site(0, y)), row_size(lattice), row(lattice, y));
    m_correction = correction;
}

void Consistency::measure(const Lattice& lattice, Surface surface, const ControlNet& net) {
    sum.assign(source.size(), 0.0f);
    m_crossed.begin(lattice, mean_positions(), 1);
    for (int y = 0; y + 1 < lattice.height(); ++y) {
        float* upper = sum.data() + size_t(y) * row_size(lattice);
        add_means(lattice, surface, net, lattice.all(), y, m_crossed, m_scratch, upper,
                  upper + row_size(lattice));
    }
}

void Consistency::correct(const Lattice& lattice, Surface surface, ControlNet& net) {
    measure(lattice, surface, net);
    std::vector<float> moved(row_size(lattice));
    for (int y = 1; y + 1 < lattice.height(); ++y) {
        move_row(lattice, net, 1, lattice.width() - 1, y,
                 {row(lattice, y - 1), row(lattice, y), row(lattice, y + 1)},
                 sum.data() + size_t(y) * row_size(lattice), m_correction, moved.data());
        std::copy(moved.begin() + m_count, moved.end() - m_count,
                  net.vertex(lattice.vertex_site(1, y)));
    }
}

} // namespace ddt
