// SPDX-License-Identifier: Apache-2.0
// A job cut into tiles.
#pragma once

#include "core/tiles/grid.h"
#include "ddt/core.h"

namespace ddt {

/// What whoever works on a job's tiles is given; all of it outlives the work.
struct TiledJob {
    Source& source;
    Sink& sink;
    const Mapping& mapping;
    const Job& job;
    const Grid& grid;
    int threads; ///< how many may work, and so read the source and write to the sink, at a time
};

} // namespace ddt
