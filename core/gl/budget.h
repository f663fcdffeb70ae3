// SPDX-License-Identifier: Apache-2.0
// How large slots are, and how many of them fit on a device.
#pragma once

#include "core/gl/surfaces.h"

namespace ddt::gl {

/// The slot for the tiles of a window.
SlotShape shape_for(const Rect& window);

/// How many tiles to have on the device at a time: at most `tiles`, and as many as the device's
/// memory, its storage blocks, the host's memory for what travels and a dispatch have room for; at
/// least 1. Throws Failure if one does not fit a storage block, or does not fit the memory of a
/// device that is no software renderer.
size_t affordable_tiles(const Gpu& gpu, const SlotShape& shape, int groups, const MeshOptions& mesh,
                        const SurfaceOptions& surface, int tiles);

} // namespace ddt::gl
