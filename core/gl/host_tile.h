// SPDX-License-Identifier: Apache-2.0
// A tile on its way to the device.
#pragma once

#include <vector>

#include "core/gl/device_mesh.h"
#include "core/gl/surfaces.h"
#include "core/tiles/grid.h"
#include "ddt/core.h"

namespace ddt::gl {

/// A tile in the layout of slots, one a mesh.
struct HostTile {
    Tile tile;
    TileSize size;
    std::vector<float> guides;   ///< a mesh after the other
    std::vector<float> values;   ///< a group after the other
    std::vector<uint64_t> sites; ///< the finished meshes, of a scheme the device does not know
    Statistics statistics;       ///< of making those
};

/// Read t.tile. False if the source fails.
bool read(Source& source, const Job& job, const SlotShape& shape, HostTile& t);

/// Write what was read to the slots from first_slot on. On the context's thread.
void upload(const HostTile& t, const Job& job, int first_slot, DeviceMesh& mesh,
            Surfaces& surfaces);

/// Its values alone.
void upload_values(const HostTile& t, const Job& job, int first_slot, Surfaces& surfaces);

/// What the job's groups of channels are.
std::vector<GroupKinds> kinds_of(const Job& job);

} // namespace ddt::gl
