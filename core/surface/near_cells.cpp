// SPDX-License-Identifier: Apache-2.0
#include "core/surface/near_cells.h"

#include <algorithm>

#include "core/surface/control_net.h"

namespace ddt {

void NearCells::resize(int width) {
    for (std::vector<float>& row : rows)
        row.resize(size_t(width) + edge_padding);
}

void NearCells::begin(const Lattice& lattice, const Rect& part, int y) {
    if (y > 0)
        load_below(lattice, part, y - 1);
}

void NearCells::load_below(const Lattice& lattice, const Rect& part, int y) {
    if (y + 1 < lattice.height())
        flag_down(lattice.divisions(y), std::max(part.x0 - 1, 0),
                  std::min(part.x1, lattice.width() - 1), rows[y % 2].data());
}

} // namespace ddt
