// SPDX-License-Identifier: Apache-2.0
// The starting triangulation of points.
#pragma once

#include <array>
#include <vector>

#include "core/base/progress.h"
#include "core/tin/tin.h"

namespace ddt {

/// Which of a quadrilateral's diagonals is made where its corners lie on one circle, as those of
/// every square do: the one along which `guide`, a number a point, changes less, or, where `seed`
/// is not 0, one by chance, another one for another seed. With neither, whichever comes.
struct Ties {
    const float* guide = nullptr;
    uint32_t seed = 0;
};

/// The Delaunay triangles of the points, which are all different, sorted row by row (by y, then by
/// x) and not all on one line: they cover the points' convex hull, whatever shape the points have
/// together, every triangle with positive orientation. A point takes 0.5 to 2 microseconds, be
/// there a million. False: `progress`, told the share of points that have their triangles,
/// cancelled it.
bool find_delaunay(const std::vector<Steps>& points, std::vector<std::array<int32_t, 3>>& triangles,
                   Ties ties = {}, const ProgressCallback& progress = {});

} // namespace ddt
