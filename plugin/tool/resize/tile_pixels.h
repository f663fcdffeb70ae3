// SPDX-License-Identifier: Apache-2.0
// The pixels of a result that are read off given tiles of its source.
#pragma once

#include "ddt/mapping.h"

namespace ddt::tool {

/// The output pixels whose positions those tiles of the source serve (see core/tiles/grid.h), so
/// that no tile is worked for two parts. `x` and `y` are the axes of the whole result.
Rect pixels_of_tiles(const Rect& tiles, int columns, int rows, const ResizeMapping::Axis& x,
                     const ResizeMapping::Axis& y);

} // namespace ddt::tool
