// SPDX-License-Identifier: Apache-2.0
// Axes that span so much less than the other that positions along them are rounded.
#pragma once

#include <string>

#include "ddt/points.h"

namespace ddt::tool {

/// What is to be said of a mesh, of which there are triangles, where along one axis fewer than 2^16
/// positions are told apart: one grid of steps lies over both. Empty where there is no such axis.
std::string note_on_coarse_axis(const PointMesh& mesh);

} // namespace ddt::tool
