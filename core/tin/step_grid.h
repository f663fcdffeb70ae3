// SPDX-License-Identifier: Apache-2.0
// From a file's units to the whole steps in which orientation is exact.
#pragma once

#include <string>
#include <vector>

#include "core/tin/tin.h"

namespace ddt {

struct PointMesh;

/// A power of two of steps a unit, so that positions which are whole numbers of some binary
/// fraction keep their exact place.
class StepGrid {
public:
    /// The finest grid on which all points fit. False with one line in `error` if there are none
    /// or more than most_points, a position is not finite, or all span too much or too little.
    bool fit(const std::vector<double>& x, const std::vector<double>& y, std::string& error);
    /// That of a mesh; where all its points span more than four times what its triangles' corners
    /// do, the corners' alone: a single point far away, which no triangle uses, would leave them
    /// few steps. (Not wherever there is such a point: of those that lie together delaunay() makes
    /// one a corner, and the grid of its mesh is to be the one that it was made on.) False, too, if
    /// a triangle is of points that there are not.
    bool fit(const PointMesh& mesh, std::string& error);

    /// The step of a point; of one that was not looked at, the nearest within the box.
    Steps steps(double x, double y) const { return {within(step_x(x)), within(step_y(y))}; }
    /// The nearest step of a position, which may be outside the points' box: then within 2^31.
    int64_t step_x(double x) const { return nearest((x - m_x) * m_scale); }
    int64_t step_y(double y) const { return nearest((y - m_y) * m_scale); }

private:
    /// From the smallest coordinates over the larger of both extents.
    bool cover(double x, double y, double extent, std::string& error);
    static int64_t nearest(double step);
    static int32_t within(int64_t step) {
        return int32_t(step < 0 ? 0 : step < most_steps ? step : most_steps);
    }

    double m_x = 0, m_y = 0, m_scale = 1;
};

/// The vertices of points, without guide.
std::vector<Tin::Vertex> vertices_of(const StepGrid& grid, const std::vector<double>& x,
                                     const std::vector<double>& y);

} // namespace ddt
