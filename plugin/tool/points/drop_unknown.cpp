// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/points/drop_unknown.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace ddt::tool {

namespace {

/// Of each point whether it has a number in all of the columns.
std::vector<uint8_t> find_known(size_t count, const std::vector<const Column*>& columns) {
    std::vector<uint8_t> known(count, 1);
    for (const Column* column : columns)
        for (size_t i = 0; i < count; ++i)
            known[i] &= uint8_t(!std::isnan(column->values[i]));
    return known;
}

/// Leave those triangles whose three points stay, with their places among these.
void keep_triangles(PointFile& points, const std::vector<uint8_t>& keep) {
    const size_t count = keep.size();
    std::vector<int32_t> place(count);
    int32_t next = 0;
    for (size_t i = 0; i < count; ++i)
        place[i] = keep[i] ? next++ : -1;
    size_t left = 0;
    for (size_t i = 0; i < points.mesh.triangles.size(); ++i) {
        std::array<int32_t, 3> t = points.mesh.triangles[i];
        for (int32_t& v : t)
            v = size_t(v) < count ? place[size_t(v)] : v; // others are for optimise() to refuse
        if (*std::min_element(t.begin(), t.end()) < 0)
            continue;
        points.mesh.triangles[left] = t;
        points.faces[left++] = points.faces[i];
    }
    points.mesh.triangles.resize(left);
    points.faces.resize(left);
}

/// Leave the numbers of those points that stay.
void keep_numbers(std::vector<double>& numbers, const std::vector<uint8_t>& keep) {
    size_t to = 0;
    for (size_t i = 0; i < keep.size(); ++i)
        if (keep[i])
            numbers[to++] = numbers[i];
    numbers.resize(to);
}

} // namespace

size_t drop_unknown(PointFile& points, const std::vector<const Column*>& columns) {
    const std::vector<uint8_t> known = find_known(points.mesh.x.size(), columns);
    keep_triangles(points, known);
    keep_numbers(points.mesh.x, known);
    keep_numbers(points.mesh.y, known);
    for (Column& column : points.columns)
        keep_numbers(column.values, known);
    return known.size() - points.mesh.x.size();
}

} // namespace ddt::tool
