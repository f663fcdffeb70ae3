// SPDX-License-Identifier: Apache-2.0
// delaunay() and optimise() of ddt/points.h for callers that tell want of memory from other
// failures.
#pragma once

#include <string>

#include "core/base/progress.h"
#include "core/tin/delaunay.h"
#include "ddt/points.h"

namespace ddt {

/// delaunay(); ties.guide: a number a point of the mesh. False with one line in `error`; throws
/// std::bad_alloc and what `progress` throws.
bool delaunay_points(PointMesh& mesh, Ties ties, std::string& error,
                     const ProgressCallback& progress);

/// optimise(). False with one line in `error`; throws std::bad_alloc and what `progress` throws.
bool optimise_points(PointMesh& mesh, const float* guide, const MeshOptions& given,
                     MeshReport* report, std::string& error, const ProgressCallback& progress,
                     Device device);

} // namespace ddt
