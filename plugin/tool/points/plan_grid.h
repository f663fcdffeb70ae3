// SPDX-License-Identifier: Apache-2.0
// The pixels that show a part of the plane.
#pragma once

#include "ddt/points.h"
#include "plugin/tool/command/exit_code.h"
#include "plugin/tool/points/window.h"

namespace ddt::tool {

/// Pixels whose outer borders are the window's. A side that is 0 is left open and keeps the
/// window's shape. False with a failure if it would be too large.
bool plan_grid(const Window& window, int width, int height, bool y_down, PixelGrid& grid,
               Failure& failure);

} // namespace ddt::tool
