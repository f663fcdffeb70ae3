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

/// Which of a quadrilateral's diagonals is made where its corners lie on one circle, as those of
/// every square do: the one along which `guide`, a number a point, changes less, or, where `seed`
/// is not 0, one by chance, another one for another seed. With neither, whichever comes.
struct Ties {
    const float* guide = nullptr;
    uint32_t seed = 0;
};

/// The Delaunay triangles of such points, all of them whatever shape they have together. A point
/// takes 0.5 to 2 microseconds, be there a million. False: `progress`, told the share of points
/// that have their triangles, cancelled it.
bool swept_delaunay(const std::vector<Steps>& points,
                    std::vector<std::array<int32_t, 3>>& triangles, Ties ties = {},
                    const Tell& progress = {});

/// Whether the triangles' areas add up to that of the points' convex hull.
bool covers_hull(const std::vector<Steps>& points,
                 const std::vector<std::array<int32_t, 3>>& triangles);

} // namespace ddt
