// SPDX-License-Identifier: Apache-2.0
// The starting triangulation of points.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/tin/tin.h"

namespace ddt {

/// The Delaunay triangles of the points, which are all different, sorted row by row (by y, then by
/// x) and not all on one line; every triangle with positive orientation. They cover the points'
/// convex hull but for slivers along its rim, which complete_hull() adds; where the points lie in a
/// narrow band some may be left out. False with one line in `error`. Twins: delaunay_geos.cpp and,
/// without GEOS, delaunay_stub.cpp.
bool find_delaunay(const std::vector<Steps>& points, std::vector<std::array<int32_t, 3>>& triangles,
                   std::string& error);

/// Add the triangles between the rim of a triangulation and the convex hull of its points.
void complete_hull(const std::vector<Steps>& points,
                   std::vector<std::array<int32_t, 3>>& triangles);

/// The Delaunay triangles of such points, all of them whatever shape they have together; of four or
/// more on a circle others than find_delaunay()'s. Of n points of a lattice it takes time with
/// n^1.5: 1 microsecond a point of 5000, 20 of a million. False: `progress`, told the share of
/// points that have their triangles, cancelled it.
bool swept_delaunay(const std::vector<Steps>& points,
                    std::vector<std::array<int32_t, 3>>& triangles, const Tell& progress = {});

/// Whether the triangles' areas add up to that of the points' convex hull.
bool covers_hull(const std::vector<Steps>& points,
                 const std::vector<std::array<int32_t, 3>>& triangles);

} // namespace ddt
