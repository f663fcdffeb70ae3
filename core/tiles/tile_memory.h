// SPDX-License-Identifier: Apache-2.0
// The largest memory that working on tiles takes, and where it stays between jobs.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/tiles/tile_mesh.h"

namespace ddt {

/// What a tile's meshes are made in, from one tile to the next.
struct TileMemory {
    std::vector<float> guide, blurred; ///< of several meshes
    MeshedTile meshed;

    /// About the bytes that this takes for a job.
    static size_t needed(const Job& job);
    /// Take what the largest tile of a job needs: a vector that grows from tile to tile would take
    /// up to twice of it.
    void reserve(const Job& job);
    /// Those that it takes.
    size_t bytes() const;

    /// Where the guide has room. A lattice that was started needs it no more: that of a single mesh
    /// lies where the lattice will.
    float* guide_place(int width, int height) {
        return guide.empty() ? meshed.meshes[0].guide_place(width, height) : guide.data();
    }
};

/// Width, height and pixels of the lattice of the largest tile of a job.
int largest_width(const Job& job);
int largest_height(const Job& job);
size_t largest_pixels(const Job& job);

/// A process that makes many small pictures would spend a quarter of its time on pages that it is
/// given, cleared, for each and gives back: so some memory is kept. At most so many of these, none
/// that is larger (ddt/job.h says their product).
constexpr size_t most_idle = 2;
constexpr size_t most_idle_bytes = size_t(12) << 20;

/// Memory that an earlier tile left, or new and empty memory. Left for a later one at the end,
/// unless as much is kept already.
class KeptMemory {
public:
    KeptMemory();
    ~KeptMemory();
    KeptMemory(const KeptMemory&) = delete;
    KeptMemory& operator=(const KeptMemory&) = delete;

    TileMemory& operator*() const { return *m_memory; }

private:
    std::unique_ptr<TileMemory> m_memory;
};

} // namespace ddt
