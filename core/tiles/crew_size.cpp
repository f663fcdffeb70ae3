// SPDX-License-Identifier: Apache-2.0
#include "core/tiles/crew_size.h"

#include <algorithm>

#include "core/tiles/tile_io.h"
#include "core/tiles/tile_memory.h"
#include "core/tiles/tile_worker.h"

namespace ddt {

namespace {

/// All together take no more than this for a few threads, times the meshes, and so much more for
/// each further one: less where parts of tiles are shared.
constexpr size_t few_limit = size_t(200) << 20;
constexpr size_t few_shared = 40, limit_per_thread = size_t(6) << 20;
constexpr size_t few_unshared = 16, limit_per_own_tile = size_t(22) << 20;

size_t memory_limit(size_t threads, bool shared) {
    const size_t few = shared ? few_shared : few_unshared;
    return few_limit +
           (threads - std::min(threads, few)) * (shared ? limit_per_thread : limit_per_own_tile);
}

/// With fewer places than members by this factor, meshes would be what they wait for: they are a
/// fifth of the work or more.
constexpr size_t members_a_place = 5;

/// Output pixels that are worth a thread, where there are fewer tiles than threads.
constexpr size_t pixels_a_thread = size_t(1) << 16;

} // namespace

CrewSize crew_size(const Mapping& mapping, const Job& job, const Grid& grid, size_t threads) {
    const bool shared = mapping.separable();
    const size_t bytes = memory_limit(threads, shared) * size_t(job.mesh.meshes);
    const size_t worker = TileWorker::memory(job, mapping), place = TileMemory::needed(job);
    const auto tiles = size_t(grid.count());
    const size_t useful = std::max(tiles, output_of(mapping).area() / pixels_a_thread);
    const size_t least_share = shared ? members_a_place : 1;
    const size_t fitting = bytes * least_share / (worker * least_share + place);

    CrewSize size;
    size.members = std::max<size_t>(1, std::min({fitting, useful, threads}));
    const size_t left = bytes - std::min(bytes, size.members * worker);
    size.places = std::max<size_t>(1, std::min({left / place, tiles, size.members}));
    return size;
}

} // namespace ddt
