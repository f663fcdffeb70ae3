// SPDX-License-Identifier: Apache-2.0
// Which cells above and below a row of pixels are divided by the diagonal that goes down.
#pragma once

#include <vector>

#include "core/lattice/lattice.h"
#include "ddt/rect.h"

namespace ddt {

/// Flag those of cells x0 .. x1 - 1 of a row whose diagonal is down: 1, else 0.
inline void flag_down(const Division* divisions, int x0, int x1, float* down) {
    for (int x = x0; x < x1; ++x)
        down[x] = divisions[x] == Division::down ? 1.0f : 0.0f;
}

/// Flags as of flag_down(), padded for spread(), of the rows of cells above and below the row of
/// pixels that is worked on.
struct NearCells {
    std::vector<float> rows[2]; ///< row y of cells at [y % 2]

    void resize(int width);
    const float* above(int y) const { return rows[(y + 1) % 2].data(); }
    const float* below(int y) const { return rows[y % 2].data(); }

    /// Before rows y, y + 1, ... of pixels are worked on: load the cells above.
    void begin(const Lattice& lattice, const Rect& part, int y);
    /// Before row y is: load the cells below, as far as `part` (in pixels) needs them.
    void load_below(const Lattice& lattice, const Rect& part, int y);
};

} // namespace ddt
