// SPDX-License-Identifier: Apache-2.0
// Writing points and their triangles to a file.
#pragma once

#include <string>

#include "plugin/tool/command/exit_code.h"
#include "plugin/tool/file/whole_file.h"
#include "plugin/tool/points/point_file.h"

namespace ddt::tool {

/// Write a binary PLY (little endian) with x and y as double, the columns in their types, and the
/// triangles.
bool write_points(const std::string& path, const PointFile& points, Failure& failure);
/// The same into an open file, which is still to be committed. False with a failure if the system
/// did not take all of it.
bool write_points(WholeFile& file, const PointFile& points, Failure& failure);

} // namespace ddt::tool
