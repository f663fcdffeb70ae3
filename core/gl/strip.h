// SPDX-License-Identifier: Apache-2.0
// Rows of a tile's output that are sampled in one go.
#pragma once

#include <vector>

#include "core/gl/surfaces.h"
#include "core/tiles/grid.h"
#include "ddt/core.h"

namespace ddt::gl {

/// The positions of a strip, and where its results belong.
struct Strip {
    Rect rows; ///< output pixels, all columns of the tile's reach
    SamplePlan plan;
    std::vector<int32_t> positions;
    /// Output pixels in the order of the results; one rectangle if the mapping is separable.
    std::vector<Rect> runs;
};

/// Fill in plan, positions and runs for the rows that are set. `slot`: where the tile is.
void plan_strip(const Mapping& mapping, const Tile& tile, int slot, Strip& strip);

} // namespace ddt::gl
