// SPDX-License-Identifier: Apache-2.0
#include "core/tin/step_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ddt/points.h"

namespace ddt {

namespace {

bool check_points(const std::vector<double>& x, const std::vector<double>& y, std::string& error) {
    if (x.size() != y.size() || x.empty() || x.size() > most_points) {
        error = "ddt: a mesh has 1 to " + std::to_string(most_points) + " points, as many x as y";
        return false;
    }
    for (size_t i = 0; i < x.size(); ++i)
        if (!std::isfinite(x[i]) || !std::isfinite(y[i])) {
            error = "ddt: point " + std::to_string(i) + " has a position that is not finite";
            return false;
        }
    return true;
}

/// The smallest coordinates and the larger of both extents.
struct Box {
    double x, y, extent;
};

/// Of the points i of which counts(i) is true: one at least.
template <class Counts>
Box box_of(const std::vector<double>& x, const std::vector<double>& y, Counts&& counts) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double left = infinity, right = -infinity, low = infinity, high = -infinity;
    for (size_t i = 0; i < x.size(); ++i) {
        if (!counts(i))
            continue;
        left = std::min(left, x[i]);
        right = std::max(right, x[i]);
        low = std::min(low, y[i]);
        high = std::max(high, y[i]);
    }
    return {left, low, std::max(right - left, high - low)};
}

} // namespace

bool StepGrid::fit(const std::vector<double>& x, const std::vector<double>& y, std::string& error) {
    if (!check_points(x, y, error))
        return false;
    const Box box = box_of(x, y, [](size_t) { return true; });
    return cover(box.x, box.y, box.extent, error);
}

bool StepGrid::fit(const PointMesh& mesh, std::string& error) {
    if (!check_points(mesh.x, mesh.y, error) ||
        !check_vertices(mesh.triangles, mesh.x.size(), error))
        return false;
    Box box = box_of(mesh.x, mesh.y, [](size_t) { return true; });
    if (!mesh.triangles.empty()) {
        const std::vector<uint8_t> is_corner = corners_of(mesh.triangles, mesh.x.size());
        const Box corners = box_of(mesh.x, mesh.y, [&](size_t i) { return is_corner[i] != 0; });
        if (box.extent / 4 > corners.extent)
            box = corners;
    }
    return cover(box.x, box.y, box.extent, error);
}

bool StepGrid::cover(double x, double y, double extent, std::string& error) {
    if (!std::isfinite(extent)) {
        error = "ddt: the points' positions are too far apart; x and y may span 1.7e308 at most";
        return false;
    }
    // The extent is then from 2^29 steps to most_steps.
    const double scale = extent > 0 ? std::ldexp(1.0, 29 - std::ilogb(extent)) : 1;
    if (!std::isfinite(scale)) {
        error =
            "ddt: the points' positions are too close together; x or y must span 6e-300 or more";
        return false;
    }
    m_x = x;
    m_y = y;
    m_scale = scale;
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
