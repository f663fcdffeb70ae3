// SPDX-License-Identifier: Apache-2.0
// What flips are judged by.
#pragma once

#include "ddt/core.h"

namespace ddt {

/// The sum that flips lower: the edges' cost, and for an edge of half vector v in doubled
/// coordinates `contour` times v' N v of the contours at its midpoint (core/guide/contour.h).
struct Criterion {
    /// Implicit: a plain cost is one without contours.
    Criterion(Cost cost_, float contour_ = 0.0f) : cost(cost_), contour(contour_) {}

    Cost cost;
    float contour; ///< if not 0, the lattice must have been started with contours
};

} // namespace ddt
