// SPDX-License-Identifier: Apache-2.0
// A part of the plane that points lie in.
#pragma once

#include "ddt/points.h"

namespace ddt::tool {

struct Window {
    double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// What a mesh's triangles, of which there are some, span. Points that are no corner of one do not
/// count: nothing is drawn there.
Window window_of(const PointMesh& mesh);

} // namespace ddt::tool
