// SPDX-License-Identifier: Apache-2.0
// Which pixels a mesh's triangles cover.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/tin/step_grid.h"
#include "core/tin/tin.h"
#include "ddt/points.h"

namespace ddt {

/// A pixel within a triangle: its index and the weights of the triangle's vertices, which sum to 1.
struct Covered {
    size_t pixel;
    double weight[3];
};

/// One axis of a PixelGrid: where pixels are, in steps and ascending.
class PixelAxis {
public:
    template <class Step>
    PixelAxis(double first, double step, int count, Step&& to_steps) : m_reversed(step < 0) {
        for (int i = 0; i < count; ++i)
            m_steps.push_back(to_steps(first + (m_reversed ? count - 1 - i : i) * step));
    }
    /// The pixels from `low` to `high` steps are begin to end.
    int begin(int64_t low) const {
        return int(std::lower_bound(m_steps.begin(), m_steps.end(), low) - m_steps.begin());
    }
    int end(int64_t high) const {
        return int(std::upper_bound(m_steps.begin(), m_steps.end(), high) - m_steps.begin());
    }
    int64_t operator[](int i) const { return m_steps[size_t(i)]; }
    /// Its number in the image.
    size_t pixel(int i) const { return m_reversed ? m_steps.size() - 1 - size_t(i) : size_t(i); }

private:
    bool m_reversed;
    std::vector<int64_t> m_steps;
};

/// Of the columns x0 to x1 - 1 in the row at y leave those where none of the triangle's weights is
/// negative: each is a whole number that grows or falls evenly along the row.
inline void narrow(const Steps (&corner)[3], const PixelAxis& columns, int64_t y, int& x0,
                   int& x1) {
    const auto floor_divide = [](int64_t a, int64_t b) { // b > 0
        return a / b - (a % b < 0 ? 1 : 0);
    };
    for (int k = 0; k < 3; ++k) {
        const Steps p = corner[(k + 1) % 3], q = corner[(k + 2) % 3];
        const int64_t rise = int64_t(p.y) - q.y;
        const int64_t at_zero = (int64_t(q.x) - p.x) * (y - p.y) - rise * p.x;
        if (rise > 0)
            x0 = std::max(x0, columns.begin(-floor_divide(at_zero, rise)));
        else if (rise < 0)
            x1 = std::min(x1, columns.end(floor_divide(at_zero, -rise)));
    }
}

/// Call f(covered, owned) for every pixel within a triangle of positive orientation, its rim
/// included; `owned` says that the pixel belongs to this one of several with the pixel on their
/// rims: to the one that holds position + (d, d^2) for tiny d > 0, as core/lattice/locate.h has it.
template <class F>
void each_covered(const Steps (&corner)[3], const PixelAxis& columns, const PixelAxis& rows,
                  size_t width, F&& f) {
    const auto range_x = std::minmax({corner[0].x, corner[1].x, corner[2].x});
    const auto range_y = std::minmax({corner[0].y, corner[1].y, corner[2].y});
    const int64_t area = orientation(corner[0], corner[1], corner[2]);
    int64_t bias[3]; // 0 where weight 0 belongs to the triangle, else -1
    for (int k = 0; k < 3; ++k) {
        const Steps p = corner[(k + 1) % 3], q = corner[(k + 2) % 3];
        bias[k] = q.y < p.y || (q.y == p.y && q.x > p.x) ? 0 : -1;
    }
    const int x0 = columns.begin(range_x.first), x1 = columns.end(range_x.second);
    constexpr int wide = 16; // from there on what lies beside long thin triangles takes longest
    for (int j = rows.begin(range_y.first), end = rows.end(range_y.second); j < end; ++j) {
        int first = x0, last = x1;
        if (x1 - x0 > wide)
            narrow(corner, columns, rows[j], first, last);
        for (int i = first; i < last; ++i) {
            const Steps at{int32_t(columns[i]), int32_t(rows[j])};
            int64_t w[3];
            for (int k = 0; k < 3; ++k)
                w[k] = orientation(corner[(k + 1) % 3], corner[(k + 2) % 3], at);
            if ((w[0] | w[1] | w[2]) < 0)
                continue;
            const bool owned = ((w[0] + bias[0]) | (w[1] + bias[1]) | (w[2] + bias[2])) >= 0;
            f(Covered{rows.pixel(j) * width + columns.pixel(i),
                      {double(w[0]) / double(area), double(w[1]) / double(area),
                       double(w[2]) / double(area)}},
              owned);
        }
    }
}

/// Whether all pixels along an axis of a PixelGrid have positions, each its own.
inline bool is_axis(double first, double step, int count) {
    return count >= 0 && step != 0 && std::isfinite(first) && std::isfinite(step) &&
           std::isfinite(first + count * step);
}

/// Call f(triangle, covered) for each pixel of the grid that mesh.triangles cover: once, or where
/// it is on the rims of several once or twice, of which the last call counts. After a failure f was
/// not called.
template <class F>
bool each_pixel(const PointMesh& mesh, const PixelGrid& grid, uint8_t* inside, std::string& error,
                F&& f) {
    if (!is_axis(grid.x, grid.step_x, grid.width) || !is_axis(grid.y, grid.step_y, grid.height)) {
        error = "ddt: a grid of pixels must have a size of 0 or more, finite positions, and steps "
                "other than 0";
        return false;
    }
    StepGrid steps;
    if (!steps.fit(mesh, error))
        return false;
    const size_t size = size_t(grid.width) * size_t(grid.height);
    if (size == 0)
        return true;
    const PixelAxis columns(grid.x, grid.step_x, grid.width,
                            [&](double x) { return steps.step_x(x); });
    const PixelAxis rows(grid.y, grid.step_y, grid.height,
                         [&](double y) { return steps.step_y(y); });
    std::fill_n(inside, size, uint8_t(0));
    constexpr uint8_t touched = 1, owned_by_one = 2;
    for (const auto& t : mesh.triangles) {
        Steps corner[3];
        for (size_t k = 0; k < 3; ++k)
            corner[k] = steps.steps(mesh.x[size_t(t[k])], mesh.y[size_t(t[k])]);
        std::array<int32_t, 3> triangle = t;
        if (orientation(corner[0], corner[1], corner[2]) < 0) {
            std::swap(corner[1], corner[2]);
            std::swap(triangle[1], triangle[2]);
        }
        if (orientation(corner[0], corner[1], corner[2]) == 0)
            continue;
        each_covered(corner, columns, rows, size_t(grid.width),
                     [&](const Covered& covered, bool owned) {
                         uint8_t& state = inside[covered.pixel];
                         if (!owned && state != 0)
                             return;
                         state = owned ? owned_by_one : touched;
                         f(triangle, covered);
                     });
    }
    return true;
}

/// The value of channel `channel` there. Never outside the three; those whose weight is 0 are not
/// looked at, as they may be infinite.
inline float value_at(const float* values, int channels, int channel,
                      const std::array<int32_t, 3>& triangle, const Covered& covered) {
    double sum = 0;
    for (size_t k = 0; k < 3; ++k)
        if (covered.weight[k] != 0)
            sum += covered.weight[k] *
                   double(values[size_t(triangle[k]) * size_t(channels) + size_t(channel)]);
    return float(sum);
}

} // namespace ddt
