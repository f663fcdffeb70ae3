// SPDX-License-Identifier: Apache-2.0
#include "core/gl/budget.h"

#include <algorithm>
#include <string>

#include <unistd.h>

#include "core/gl/context/failure.h"
#include "core/gl/transfer.h"
#include "core/surface/control_net.h"
#include "core/tiles/grid.h"

namespace ddt::gl {

namespace {

/// Device memory for tiles in flight. A software renderer's is the machine's own. Others work on
/// the GPU too; and NVIDIA's driver takes tens of milliseconds, each job, to find and give back
/// more than about a gigabyte.
constexpr size_t hardware_budget = size_t(768) << 20, software_budget = size_t(256) << 20;

/// So is that of a GPU within a processor, which OpenGL does not tell from others: no more than
/// this share of what the machine has.
constexpr size_t share_of_machine = 16;

/// Memory of the host for what is on its way there: of two batches, since one is read while the
/// other travels. What is on its way back takes half as much (work_on_gpu.cpp).
constexpr size_t host_budget = size_t(128) << 20;

/// Tiles of a batch, at most. Several batches, since the host reads the next and writes the one
/// before while the device has one; of some size, since each waits some 60 times for what the
/// device does one after the other.
constexpr size_t tiles_a_batch = 20;

size_t budget_of(const Gpu& gpu) {
    if (gpu.context->software)
        return software_budget;
    const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGESIZE);
    if (pages <= 0 || page <= 0)
        return hardware_budget;
    return std::min(hardware_budget, size_t(pages) / share_of_machine * size_t(page));
}

} // namespace

SlotShape shape_for(const Rect& window) {
    return {largest_tile(window.width()), largest_tile(window.height())};
}

size_t affordable_tiles(const Gpu& gpu, const SlotShape& shape, int groups, const MeshOptions& mesh,
                        const SurfaceOptions& surface, int tiles) {
    const auto slots = size_t(mesh.meshes); // a tile
    // The tile's numbers as they travel, at most.
    const size_t numbers = Numbers().room(shape.pixels() * size_t(groups * group_size));
    const size_t a_tile =
        slots * (DeviceMesh::bytes(shape, mesh) + Surfaces::bytes(shape, size_t(groups), surface)) +
        numbers;
    const size_t largest = std::max(
        slots * std::max(DeviceMesh::largest_bytes(shape), Surfaces::largest_bytes(shape, surface)),
        numbers);
    if (largest > gpu.block_limit)
        throw Failure("a tile takes " + std::to_string(largest) + " bytes of one buffer, and " +
                      gpu.context->renderer + " has " + std::to_string(gpu.block_limit));
    if (!gpu.context->software && a_tile > budget_of(gpu))
        throw Failure("a tile takes " + std::to_string(a_tile >> 20) + " MiB, and " +
                      std::to_string(budget_of(gpu) >> 20) + " are taken of a GPU at most");
    const size_t on_the_way = 2 * (numbers + slots * guide_room(shape.pixels()));
    const size_t n =
        std::min({budget_of(gpu) / a_tile, host_budget / on_the_way, gpu.block_limit / largest,
                  size_t(tiles), tiles_a_batch, size_t(max_tiles) / slots});
    return std::max<size_t>(1, n);
}

} // namespace ddt::gl
