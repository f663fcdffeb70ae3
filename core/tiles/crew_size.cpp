// SPDX-License-Identifier: Apache-2.0
#include "core/tiles/crew_size.h"

#include <algorithm>

#include "core/surface/corrections.h"
#include "core/tiles/channel_groups.h"
#include "core/tiles/tile_io.h"
#include "core/tiles/tile_memory.h"
#include "core/tiles/tile_worker.h"

namespace ddt {

namespace {

/// Of few threads together, and of each further one.
constexpr size_t few_limit = size_t(200) << 20;
constexpr size_t few_threads = 40, limit_per_thread = size_t(6) << 20;

/// With fewer places than members by this factor, meshes would be what they wait for: they are a
/// fifth of the work or more.
constexpr size_t usual_members_a_place = 5;

/// Who takes rows of a tile makes what is round them once more. Where many channels are corrected,
/// that is most of the work: three threads at a tile take twice as much of the processors as one.
size_t members_a_place(const Job& job) {
    return is_corrected(job.surface) && group_count(job.channels) > 1 ? 1 : usual_members_a_place;
}

/// Output pixels that are worth a thread, where there are fewer tiles than threads.
constexpr size_t least_pixels_a_thread = size_t(1) << 16;

} // namespace

size_t memory_limit(size_t threads, int meshes) {
    return (few_limit + (threads - std::min(threads, few_threads)) * limit_per_thread) *
           size_t(meshes);
}

CrewSize crew_size(const Mapping& mapping, const Job& job, const Grid& grid, size_t threads) {
    const size_t bytes = memory_limit(threads, job.mesh.meshes);
    const size_t worker = TileWorker::memory(job, mapping), place = TileMemory::needed(job);
    const auto tiles = size_t(grid.count());
    const size_t useful = std::max(tiles, output_of(mapping).area() / least_pixels_a_thread);
    const size_t sharing = members_a_place(job);
    const size_t fitting = bytes * sharing / (worker * sharing + place);

    CrewSize size;
    size.members = std::max<size_t>(1, std::min({fitting, useful, threads}));
    const size_t left = bytes - std::min(bytes, size.members * worker);
    size.places = std::max<size_t>(1, std::min({left / place, tiles, size.members}));
    return size;
}

} // namespace ddt
