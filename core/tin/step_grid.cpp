// SPDX-License-Identifier: Apache-2.0
#include "core/tin/step_grid.h"

#include <algorithm>
#include <cmath>

#include "ddt/points.h"

namespace ddt {

bool StepGrid::fit(const std::vector<double>& x, const std::vector<double>& y, std::string& error) {
    if (x.size() != y.size() || x.empty() || x.size() > most_points) {
        error = "ddt: a mesh has 1 to " + std::to_string(most_points) + " points, as many x as y";
        return false;
    }
    for (size_t i = 0; i < x.size(); ++i)
        if (!std::isfinite(x[i]) || !std::isfinite(y[i])) {
            error = "ddt: point " + std::to_string(i) + " has a position that is not finite";
            return false;
        }
    const auto range_x = std::minmax_element(x.begin(), x.end());
    const auto range_y = std::minmax_element(y.begin(), y.end());
    m_x = *range_x.first;
    m_y = *range_y.first;
    const double extent = std::max(*range_x.second - m_x, *range_y.second - m_y);
    if (!std::isfinite(extent)) {
        error = "ddt: the points' positions are too far apart; x and y may span 1.7e308 at most";
        return false;
    }
    // The extent is then from 2^29 steps to most_steps.
    m_scale = extent > 0 ? std::ldexp(1.0, 29 - std::ilogb(extent)) : 1;
    if (!std::isfinite(m_scale)) {
        error =
            "ddt: the points' positions are too close together; x or y must span 6e-300 or more";
        return false;
    }
    return true;
}

int64_t StepGrid::nearest(double step) {
    constexpr double limit = 2147483647.0;
    return std::llround(std::min(std::max(step, -limit), limit));
}

std::vector<Tin::Vertex> vertices_of(const StepGrid& grid, const std::vector<double>& x,
                                     const std::vector<double>& y) {
    std::vector<Tin::Vertex> vertices(x.size());
    for (size_t i = 0; i < x.size(); ++i)
        vertices[i].at = grid.steps(x[i], y[i]);
    return vertices;
}

} // namespace ddt
