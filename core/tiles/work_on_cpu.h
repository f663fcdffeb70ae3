// SPDX-License-Identifier: Apache-2.0
// A job's tiles, worked on by the CPU's threads.
#pragma once

#include "core/base/memory/numa_node.h"
#include "core/tiles/job_state.h"
#include "core/tiles/tiled_job.h"

namespace ddt {

/// Tells the node of memory that is nearest to the calling thread, a number of at least 0.
using NodeOfThread = int (*)();

/// Work on all tiles that are not done, with up to job.threads threads and at as many tiles at once
/// as memory allows (crew_size.h). A thread that finds no tile to begin, or no place for its mesh,
/// takes half of the rows that another thread's tile has left: a mesh is made by one thread, but
/// sampled by any number. On a machine with several nodes of memory each node has tiles of its own
/// as long as there are any (tile_order.h), and its threads help with those first. Adds to
/// `statistics`.
void work_on_cpu(const TiledJob& job, JobState& state, Statistics& statistics,
                 NodeOfThread node = this_memory_node);

} // namespace ddt
