// SPDX-License-Identifier: Apache-2.0
// delaunay() and optimise() of ddt/points.h for callers that tell want of memory from other
// failures.
#pragma once

#include <string>

#include "core/base/progress.h"
#include "core/tin/delaunay.h"
#include "ddt/points.h"

namespace ddt {

/// delaunay(). False with one line in `error`; throws std::bad_alloc.
bool delaunay_points(PointMesh& mesh, std::string& error);

/// The same by the sweep alone (core/tin/sweep.cpp): for pixels, where it takes a twentieth to half
/// of GEOS's time, none of its memory, and can be cancelled. False with one line in `error`; throws
/// std::bad_alloc and what `progress` throws.
bool swept_delaunay_points(PointMesh& mesh, Ties ties, std::string& error, const Tell& progress);

/// optimise(). False with one line in `error`; throws std::bad_alloc and what `progress` throws.
bool optimise_points(PointMesh& mesh, const float* guide, MeshOptions options, MeshReport* report,
                     std::string& error, const Tell& progress, Device device);

} // namespace ddt
