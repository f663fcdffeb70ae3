// SPDX-License-Identifier: Apache-2.0
#include "core/tiles/tile_memory.h"

#include <algorithm>
#include <array>
#include <atomic>

#include "core/guide/contour.h"
#include "core/surface/control_net.h"
#include "core/tiles/grid.h"
#include "core/triangulate/start_gains.h"
#include "ddt/job.h"

namespace ddt {

namespace {

template <class T>
size_t bytes_of(const std::vector<T>& v) {
    return v.capacity() * sizeof(T);
}

/// Thread-safe, without locks: a child forked meanwhile does not wait for these. What else it may
/// wait for, ddt/core.h says.
class IdleMemory {
public:
    ~IdleMemory() { release(); }

    std::unique_ptr<TileMemory> take() {
        for (auto& slot : m_slots)
            if (TileMemory* kept = slot.exchange(nullptr))
                return std::unique_ptr<TileMemory>(kept);
        return nullptr;
    }
    /// Leaves what it has no room for.
    void keep(std::unique_ptr<TileMemory>& memory) {
        for (auto& slot : m_slots) {
            TileMemory* none = nullptr;
            if (slot.compare_exchange_strong(none, memory.get())) {
                memory.release();
                return;
            }
        }
    }
    void release() {
        while (take())
            ;
    }

private:
    std::array<std::atomic<TileMemory*>, most_idle> m_slots{};
};

IdleMemory idle;

} // namespace

int largest_width(const Job& job) {
    return largest_tile(job.window.width());
}

int largest_height(const Job& job) {
    return largest_tile(job.window.height());
}

size_t largest_pixels(const Job& job) {
    return size_t(largest_width(job)) * size_t(largest_height(job));
}

size_t TileMemory::needed(const Job& job) {
    const int width = largest_width(job);
    const size_t pixels = largest_pixels(job);
    const size_t meshes = size_t(job.mesh.meshes) * TileMesh::memory(width, largest_height(job));
    // Contours are found before gains.
    const size_t scratch = std::max(ContourRows::memory(width), start_gains_memory(width));
    const size_t guides = job.mesh.meshes > 1 ? 2 : 0;
    const size_t planes = pixels * sizeof(float) * (guides + size_t(job.channels));
    return meshes + scratch + planes;
}

void TileMemory::reserve(const Job& job) {
    const size_t pixels = largest_pixels(job), sites = 4 * pixels;
    meshed.values.reserve(pixels * size_t(job.channels) + group_size);
    guide.resize(job.mesh.meshes > 1 ? pixels : 0);
    meshed.meshes.resize(size_t(job.mesh.meshes));
    for (TileMesh& mesh : meshed.meshes)
        mesh.reserve(sites);
}

size_t TileMemory::bytes() const {
    size_t sum = bytes_of(guide) + bytes_of(blurred) + bytes_of(meshed.values);
    for (const TileMesh& mesh : meshed.meshes)
        sum += mesh.bytes();
    return sum;
}

KeptMemory::KeptMemory() : m_memory(idle.take()) {
    if (!m_memory)
        m_memory = std::make_unique<TileMemory>();
}

KeptMemory::~KeptMemory() {
    if (m_memory->bytes() <= most_idle_bytes)
        idle.keep(m_memory);
}

void release_memory() noexcept {
    idle.release();
}

} // namespace ddt
