// SPDX-License-Identifier: Apache-2.0
// How many threads work on how many tiles at once.
#pragma once

#include <cstddef>

#include "core/tiles/grid.h"
#include "ddt/core.h"

namespace ddt {

/// Threads, and tiles whose meshes are there at once. A mesh takes most of the memory and, with
/// most filters, least of the time: where memory does not allow a tile for each thread, several
/// threads share a tile; with corrections of many channels fewer threads work.
struct CrewSize {
    size_t members = 1;
    size_t places = 1; ///< for tiles; no more than members
};

/// As many of up to `threads` as there is work for, within what ddt/job.h says of memory; one of
/// each there is in any case.
CrewSize crew_size(const Mapping& mapping, const Job& job, const Grid& grid, size_t threads);

/// The bytes that all threads together may take beside what source and sink hold, as ddt/job.h
/// says.
size_t memory_limit(size_t threads, int meshes);

} // namespace ddt
