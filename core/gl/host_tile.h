// SPDX-License-Identifier: Apache-2.0
// A tile on its way to the device.
#pragma once

#include <memory>
#include <vector>

#include "core/gl/device_mesh.h"
#include "core/gl/host_buffer.h"
#include "core/gl/surfaces.h"
#include "core/tiles/grid.h"
#include "ddt/core.h"

namespace ddt::gl {

/// A tile in the layout of slots, one a mesh.
struct HostTile {
    Tile tile;
    TileSize size;
    /// What is uploaded: first the guides where with_guides(), as they travel, a mesh after the
    /// other; then the numbers of the tile's pixels, rows without gaps.
    std::unique_ptr<HostBuffer> memory;
    std::vector<size_t> guide_bytes;
    std::vector<uint64_t> sites; ///< the finished meshes, of a scheme the device does not know
    Statistics statistics;       ///< of making those
};

/// Bytes of HostTile::memory.
size_t host_bytes(const Job& job, const SlotShape& shape, const Numbers& numbers);

/// Memory of a thread that reads tiles, the same for all of them.
struct ReadMemory {
    std::vector<float> guide, blurred;
};

/// Read t.tile into t.memory, which is made, of plain memory, if it is not there. False if the
/// source fails.
bool read(Source& source, const Job& job, const SlotShape& shape, const Numbers& numbers,
          HostTile& t, ReadMemory& memory);

/// Whether guides are wanted on the device.
bool with_guides(const Job& job);
/// Have what was read copied to the slots from first_slot on; when all tiles are there, unpack() is
/// to be called. Returns the bytes. On the context's thread; t.memory must stay until a Fence has
/// passed.
size_t upload(const HostTile& t, const Job& job, int first_slot, DeviceMesh& mesh,
              Surfaces& surfaces);
void unpack(const Job& job, DeviceMesh& mesh, Surfaces& surfaces);
/// The guides alone, and the numbers.
size_t upload_guides(const HostTile& t, const Job& job, int first_slot, DeviceMesh& mesh);
size_t upload_numbers(const HostTile& t, const Job& job, int first_slot, const SlotShape& shape,
                      Surfaces& surfaces);

/// What the job's groups of channels are.
std::vector<GroupKinds> kinds_of(const Job& job);

} // namespace ddt::gl
