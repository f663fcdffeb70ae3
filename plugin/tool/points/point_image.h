// SPDX-License-Identifier: Apache-2.0
// An image of points.
#pragma once

#include <string>
#include <vector>

#include "plugin/tool/command/exit_code.h"
#include "plugin/tool/points/point_file.h"

namespace ddt::tool {

/// The channels that columns become: red, green, blue, alpha and z are R, G, B, A and Z, others
/// keep their names; without alpha there is one more, A, that tells where triangles are.
std::vector<std::string> channel_names(const std::vector<const Column*>& columns);

/// Draw the columns of triangulated points and write as much of it as OUT's format has room for
/// (fit_format.h), as channel_names(), which must each be another. Points' red, green and blue are
/// not associated with their alpha, the image's are. Numbers that are so by the columns' type are
/// sRGB, or linear light where files of the format are that whatever they say.
bool write_point_image(const PointFile& points, const std::vector<const Column*>& columns,
                       const PixelGrid& grid, const std::string& path, Failure& failure);

} // namespace ddt::tool
