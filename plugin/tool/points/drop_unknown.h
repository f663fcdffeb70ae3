// SPDX-License-Identifier: Apache-2.0
// Points whose values are not all known.
#pragma once

#include <cstddef>
#include <vector>

#include "plugin/tool/points/point_file.h"

namespace ddt::tool {

/// Leave out the points that lack a number in one of the columns, and triangles with such a corner.
/// Returns how many points those were.
size_t drop_unknown(PointFile& points, const std::vector<const Column*>& columns);

} // namespace ddt::tool
