// SPDX-License-Identifier: Apache-2.0
// Rows of a tile's output that are sampled in one go.
#pragma once

#include <vector>

#include "core/gl/surfaces.h"
#include "core/tiles/grid.h"
#include "ddt/core.h"

namespace ddt::gl {

/// The positions of a strip, where its results belong, and the results.
struct Strip {
    int batch_index = 0; ///< of the tile in its batch
    Rect rows;           ///< output pixels, all columns of the tile's reach
    bool last = false;   ///< of its tile
    SamplePlan plan;
    std::vector<int32_t> positions;
    /// Output pixels in the order of the results; one rectangle if the mapping is separable.
    std::vector<Rect> runs;
    std::vector<float> results;
};

/// Fill in plan, positions and runs for the rows that are set. `slot`: where the tile is.
void plan_strip(const Mapping& mapping, const Tile& tile, int slot, Strip& strip);

} // namespace ddt::gl
