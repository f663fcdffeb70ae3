// SPDX-License-Identifier: Apache-2.0
// Polygons as triangles.
#pragma once

#include "plugin/tool/points/point_file.h"

namespace ddt::tool {

/// Have the polygons whose triangles are a fan from their first corner, and lie over one another or
/// have no area, triangulated by clipping ears: where that corner is on one line with the next two,
/// as beside a node that hangs on a side of a larger cell, or another is reflex. Other fans stay as
/// they are, and so do those of polygons that cross themselves or have more than 255 corners, the
/// most that usual lists have room for: optimise() refuses them.
void mend_fans(PointFile& points);

} // namespace ddt::tool
