// SPDX-License-Identifier: Apache-2.0
#include "core/tiles/tile_memory.h"

#include <array>
#include <atomic>

#include "ddt/job.h"

namespace ddt {

namespace {

template <class T>
size_t bytes_of(const std::vector<T>& v) {
    return v.capacity() * sizeof(T);
}

/// Without locks: a process that forks meanwhile may go on enlarging in its child.
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

size_t TileMemory::bytes() const {
    const Workspace& w = workspace;
    size_t sum = bytes_of(guide) + bytes_of(blurred) + bytes_of(meshed.values) + bytes_of(w.gain) +
                 bytes_of(w.dirty) + bytes_of(w.flippable) + bytes_of(w.candidates) +
                 bytes_of(w.selected) + bytes_of(w.blocked);
    for (const TileMesh& mesh : meshed.meshes)
        sum += mesh.bytes();
    return sum;
}

std::unique_ptr<TileMemory> take_idle_memory() {
    if (std::unique_ptr<TileMemory> kept = idle.take())
        return kept;
    return std::make_unique<TileMemory>();
}

void keep_idle_memory(std::unique_ptr<TileMemory> memory) noexcept {
    if (memory->bytes() <= most_idle_bytes)
        idle.keep(memory);
}

void release_memory() {
    idle.release();
}

} // namespace ddt
