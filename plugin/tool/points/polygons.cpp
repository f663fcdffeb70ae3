// SPDX-License-Identifier: Apache-2.0
// (Meisters, "Polygons have ears", 1975.)
#include "plugin/tool/points/polygons.h"

#include <algorithm>
#include <numeric>

#include "core/tin/step_grid.h"

namespace ddt::tool {

namespace {

using Triangle = std::array<int32_t, 3>;

/// A corner of a polygon: its vertex, and where that is.
struct Corner {
    int32_t vertex;
    Steps at;
};

int64_t orientation(const Corner& a, const Corner& b, const Corner& c) {
    return ddt::orientation(a.at, b.at, c.at);
}

bool is_same_place(const Corner& a, const Corner& b) {
    return a.at.x == b.at.x && a.at.y == b.at.y;
}

/// Whether p is in the triangle, whose orientation is positive, or on its rim, but at no corner.
bool is_covered(const Corner& p, const Corner& a, const Corner& b, const Corner& c) {
    return orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0 &&
           !is_same_place(p, a) && !is_same_place(p, b) && !is_same_place(p, c);
}

/// Triangles of a polygon whose area is positive, or none if it crosses itself. A corner on the
/// line between its neighbours is no ear and stays until it is another's neighbour.
std::vector<Triangle> clip_ears(std::vector<Corner> left) {
    std::vector<Triangle> triangles;
    size_t tip = 0, in_vain = 0;
    while (left.size() >= 3 && in_vain < left.size()) {
        const size_t n = left.size();
        const Corner a = left[(tip + n - 1) % n], b = left[tip % n], c = left[(tip + 1) % n];
        if (orientation(a, b, c) > 0 &&
            std::none_of(left.begin(), left.end(),
                         [&](const Corner& p) { return is_covered(p, a, b, c); })) {
            triangles.push_back({a.vertex, b.vertex, c.vertex});
            left.erase(left.begin() + std::ptrdiff_t(tip % n));
            in_vain = 0;
        } else {
            ++tip;
            ++in_vain;
        }
    }
    return left.size() == 2 ? triangles : std::vector<Triangle>();
}

/// How many of the triangles from `begin` on are one fan of one face.
size_t fan_length(const PointFile& points, size_t begin) {
    const std::vector<Triangle>& triangles = points.mesh.triangles;
    size_t end = begin + 1;
    while (end < triangles.size() && points.faces[end] == points.faces[begin] &&
           triangles[end][0] == triangles[begin][0] && triangles[end][1] == triangles[end - 1][2])
        ++end;
    return end - begin;
}

/// The areas of the triangles of a polygon's fan, twice, with their signs.
std::vector<int64_t> fan_areas(const std::vector<Corner>& polygon) {
    std::vector<int64_t> areas;
    for (size_t i = 2; i < polygon.size(); ++i)
        areas.push_back(orientation(polygon[0], polygon[i - 1], polygon[i]));
    return areas;
}

/// Whether the triangles lie side by side: all one way round.
bool lie_side_by_side(const std::vector<int64_t>& areas) {
    const auto [least, most] = std::minmax_element(areas.begin(), areas.end());
    return *least > 0 || *most < 0;
}

} // namespace

void mend_fans(PointFile& points) {
    constexpr size_t most_corners = 255;
    StepGrid grid;
    std::string ignored; // whoever works on the mesh says it
    // Of triangles alone, as most files are, there is nothing to mend.
    if (std::adjacent_find(points.faces.begin(), points.faces.end()) == points.faces.end() ||
        !grid.fit(points.mesh, ignored))
        return;
    const auto corner = [&](int32_t v) {
        return Corner{v, grid.steps(points.mesh.x[size_t(v)], points.mesh.y[size_t(v)])};
    };
    std::vector<Corner> polygon;
    for (size_t begin = 0, count; begin < points.mesh.triangles.size(); begin += count) {
        count = fan_length(points, begin);
        if (count < 2 || count + 2 > most_corners)
            continue;
        const auto fan = points.mesh.triangles.begin() + std::ptrdiff_t(begin);
        polygon = {corner(fan[0][0]), corner(fan[0][1])};
        std::for_each_n(fan, count, [&](const Triangle& t) { polygon.push_back(corner(t[2])); });
        const std::vector<int64_t> areas = fan_areas(polygon);
        if (lie_side_by_side(areas))
            continue;
        if (std::accumulate(areas.begin(), areas.end(), 0.0) < 0) // whole numbers might overflow
            std::reverse(polygon.begin(), polygon.end());
        const std::vector<Triangle> clipped = clip_ears(polygon);
        if (clipped.size() == count)
            std::copy(clipped.begin(), clipped.end(), fan);
    }
}

} // namespace ddt::tool
