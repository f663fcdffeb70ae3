// SPDX-License-Identifier: Apache-2.0
#include "core/lattice/neighbours.h"

#include <algorithm>
#include <cstdlib>

namespace ddt {

Rect clipped_to(const Lattice& lattice, const Rect& part) {
    return intersection(part, lattice.all());
}

Rect grown(const Lattice& lattice, const Rect& part, int by) {
    return clipped_to(lattice, {part.x0 - by, part.y0 - by, part.x1 + by, part.y1 + by});
}

Rect with_neighbours(const Lattice& lattice, const Rect& part) {
    Rect all = grown(lattice, part, 1);
    const int far = lattice.longest();
    if (far <= 1)
        return all;
    // In doubled coordinates, the last included.
    const int x0 = 2 * part.x0, x1 = 2 * (part.x1 - 1), y0 = 2 * part.y0, y1 = 2 * (part.y1 - 1);
    const int last_x = 2 * (lattice.width() - 1), last_y = 2 * (lattice.height() - 1);
    const auto look_at = [&](int x, int y) {
        const Vec v = lattice.edge(lattice.site(x, y)).v;
        const int along = std::abs(v.x), down = std::abs(v.y);
        if (std::max(along, down) <= 1 || x + along < x0 || x - along > x1 || y + down < y0 ||
            y - down > y1)
            return;
        all.x0 = std::min(all.x0, (x - along) / 2);
        all.y0 = std::min(all.y0, (y - down) / 2);
        all.x1 = std::max(all.x1, (x + along) / 2 + 1);
        all.y1 = std::max(all.y1, (y + down) / 2 + 1);
    };
    const auto look_along = [&](int begin, int end, int y) {
        const int odd = y & 1, step = 2 - odd;
        begin = std::max(begin, 0);
        if (!odd)
            begin |= 1; // vertices are between
        for (int x = begin; x <= std::min(end, last_x); x += step)
            look_at(x, y);
    };
    // An edge that touches the part and leaves it has its midpoint near the part's rim.
    for (int y = std::max(y0 - far, 0); y <= std::min(y1 + far, last_y); ++y) {
        const int down = lattice.longest_down(y);
        if (y + down < y0 || y - down > y1)
            continue;
        const bool beside_only = y - down >= y0 && y + down <= y1;
        look_along(x0 - far, beside_only ? x0 + far : x1 + far, y);
        if (beside_only)
            look_along(x1 - far, x1 + far, y);
    }
    return all;
}

} // namespace ddt
