// SPDX-License-Identifier: Apache-2.0
// How large slots are, and how many of them fit on a device.
#pragma once

#include "core/gl/surfaces.h"

namespace ddt::gl {

/// The slot for the tiles of a window.
SlotShape shape_for(const Rect& window);

/// Tiles to have on the device at a time: not more than `tiles`, than the device's memory, its
/// storage blocks or the host's memory for what travels take, or than a dispatch can hold; at least
/// 1. Throws Failure where one does not fit a storage block, or the device's memory, unless it is a
/// software renderer's.
size_t affordable_tiles(const Gpu& gpu, const SlotShape& shape, int groups,
                        const SurfaceOptions& options, int tiles, int meshes = 1);

} // namespace ddt::gl
