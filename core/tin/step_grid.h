// SPDX-License-Identifier: Apache-2.0
// From a file's units to the whole steps in which orientation is exact.
#pragma once

#include <string>
#include <vector>

#include "core/tin/tin.h"

namespace ddt {

/// A power of two of steps a unit, so that positions which are whole numbers of some binary
/// fraction keep their exact place.
class StepGrid {
public:
    /// The finest grid on which all points fit. False with one line in `error` if there are none
    /// or more than most_points, a position is not finite, or all span too much or too little.
    bool fit(const std::vector<double>& x, const std::vector<double>& y, std::string& error);

    Steps steps(double x, double y) const { return {int32_t(step_x(x)), int32_t(step_y(y))}; }
    /// The nearest step of a position, which may be outside the points' box: then within 2^31.
    int64_t step_x(double x) const { return nearest((x - m_x) * m_scale); }
    int64_t step_y(double y) const { return nearest((y - m_y) * m_scale); }

private:
    static int64_t nearest(double step);

    double m_x = 0, m_y = 0, m_scale = 1;
};

/// The vertices of points, without guide.
std::vector<Tin::Vertex> vertices_of(const StepGrid& grid, const std::vector<double>& x,
                                     const std::vector<double>& y);

} // namespace ddt
