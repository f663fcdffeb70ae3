// SPDX-License-Identifier: Apache-2.0
// The largest memory that working on tiles takes, and where it stays between jobs.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/tiles/tile_mesh.h"

namespace ddt {

/// What a worker makes a tile's meshes in, from one tile to the next.
struct TileMemory {
    std::vector<float> guide, blurred;
    Workspace workspace;
    MeshedTile meshed;

    size_t bytes() const;
};

/// A process that makes many small pictures would spend a quarter of its time on pages that it is
/// given, cleared, for each and gives back: so some memory is kept. At most so many of these, none
/// that is larger (ddt/job.h says their product).
constexpr size_t most_idle = 2;
constexpr size_t most_idle_bytes = size_t(12) << 20;

/// What was kept, or new and empty. Thread-safe, and so is the next.
std::unique_ptr<TileMemory> take_idle_memory();
/// Keep it for who takes next, unless there is enough.
void keep_idle_memory(std::unique_ptr<TileMemory> memory) noexcept;

} // namespace ddt
