// SPDX-License-Identifier: Apache-2.0
// A job's tiles, worked on by the CPU's threads.
#pragma once

#include "core/base/memory_node.h"
#include "core/tiles/grid.h"
#include "core/tiles/run.h"
#include "ddt/core.h"

namespace ddt {

/// Tells the node of memory that is nearest to the calling thread, a number of at least 0.
using NodeOfThread = int (*)();

/// Work on all tiles that are not done, by up to so many threads, at as many tiles, as their memory
/// allows (crew_size.h). Who finds no tile to begin, or no place for it, takes half of the rows
/// that another's tile has left: the mesh is one thread's work, what is read off it anyone's. On a
/// machine with several nodes of memory each has tiles of its own as long as there are any
/// (tile_order.h), and rows of those are taken first. Adds to `statistics`.
void work_on_cpu(Source& source, Sink& sink, const Mapping& mapping, const Job& job,
                 const Grid& grid, int threads, Run& run, Statistics& statistics,
                 NodeOfThread node = this_memory_node);

} // namespace ddt
