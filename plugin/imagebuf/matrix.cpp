// SPDX-License-Identifier: Apache-2.0
#include "plugin/imagebuf/matrix.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <OpenImageIO/Imath.h>

#include "core/base/constants.h"

namespace ddt {
namespace {

/// The map's derivative at (x, y), where its w is not 0.
struct Derivative {
    double a, b; ///< of x along x and y
    double c, d; ///< of y

    Derivative(const Projective& m, const Projective::Point& p) {
        const double px = p.x / p.w, py = p.y / p.w;
        a = (m.m[0] - px * m.m[2]) / p.w, b = (m.m[3] - px * m.m[5]) / p.w;
        c = (m.m[1] - py * m.m[2]) / p.w, d = (m.m[4] - py * m.m[5]) / p.w;
    }
};

/// The smaller singular value of the map's derivative at (x, y).
double least_scale(const Projective& m, double x, double y) {
    const auto p = m(x, y);
    if (p.w == 0)
        return std::numeric_limits<double>::infinity();
    const auto [a, b, c, d] = Derivative(m, p);
    // Both singular values are s and t of s + t = |(a+d, b-c)|, s - t = |(a-d, b+c)|, halved.
    const double sum = std::hypot(a + d, b - c), difference = std::hypot(a - d, b + c);
    return 0.5 * std::fabs(sum - difference);
}

double largest_of(const std::array<double, 9>& m) {
    double largest = 0;
    for (const double v : m)
        largest = std::max(largest, std::fabs(v));
    return largest;
}

/// Whether a determinant is as good as 0. It goes with the cube of the matrix's scale, which says
/// nothing of the map. Entries above 1 do not count: a large shift makes no map singular.
bool vanishes(double determinant, const std::array<double, 9>& m) {
    const double scale = std::min(largest_of(m), 1.0);
    return determinant == 0 || std::fabs(determinant) < 1e-30 * scale * scale * scale;
}

double clamp_position(double v, int begin, int end) {
    return std::clamp(v, double(begin), double(end - 1));
}

} // namespace

bool Projective::invert(Projective& inverse) const {
    const auto& a = m;
    const double c0 = a[4] * a[8] - a[5] * a[7], c1 = a[5] * a[6] - a[3] * a[8],
                 c2 = a[3] * a[7] - a[4] * a[6];
    const double det = a[0] * c0 + a[1] * c1 + a[2] * c2;
    if (!std::isfinite(det) || vanishes(det, a))
        return false;
    const double s = 1 / det;
    inverse.m = {c0 * s, (a[2] * a[7] - a[1] * a[8]) * s, (a[1] * a[5] - a[2] * a[4]) * s,
                 c1 * s, (a[0] * a[8] - a[2] * a[6]) * s, (a[2] * a[3] - a[0] * a[5]) * s,
                 c2 * s, (a[1] * a[6] - a[0] * a[7]) * s, (a[0] * a[4] - a[1] * a[3]) * s};
    return std::all_of(inverse.m.begin(), inverse.m.end(),
                       [](double v) { return std::isfinite(v); });
}

Projective Projective::scaled_up() const {
    const double largest = largest_of(m);
    Projective scaled = *this;
    if (largest > 0 && largest < std::ldexp(1.0, -30))
        for (double& v : scaled.m)
            v = std::ldexp(v, -std::ilogb(largest));
    return scaled;
}

Projective Projective::float_inverse() const {
    const Projective scaled = scaled_up();
    Imath::M33f matrix;
    for (int i = 0; i < 9; ++i)
        matrix[i / 3][i % 3] = float(scaled.m[size_t(i)]);
    matrix.invert();
    Projective inverse;
    for (int i = 0; i < 9; ++i)
        inverse.m[size_t(i)] = double(matrix[i / 3][i % 3]);
    return inverse;
}

bool shrinks(const Projective& m, const Rect& window) {
    // Where w is the same, the derivative is affine in the point and its determinant is the same,
    // so the least scale is least at the ends of such a line: on the window's border.
    constexpr int steps = 256;
    const int n = m.affine() ? 1 : steps;
    for (int i = 0; i <= n; ++i) {
        const double x = window.x0 + double(window.width()) * i / n;
        const double y = window.y0 + double(window.height()) * i / n;
        if (std::min({least_scale(m, x, window.y0), least_scale(m, x, window.y1),
                      least_scale(m, window.x0, y), least_scale(m, window.x1, y)}) <
            1 - shrink_tolerance)
            return true;
    }
    return false;
}

double filtered_pixels(const Projective& to_source, const Rect& output, double width) {
    const auto along = [&](double u, double v) {
        return width * std::max({1.0, std::fabs(u), std::fabs(v)}) + 1;
    };
    const auto of_pixel = [&](int x, int y) {
        const auto p = to_source(x + 0.5, y + 0.5);
        const Derivative of(to_source, p);
        const double pixels = along(of.a, of.b) * along(of.c, of.d);
        return p.w != 0 && pixels >= 0 ? pixels : std::numeric_limits<double>::infinity();
    };
    if (to_source.affine())
        return of_pixel(output.x0, output.y0) * output.width() * output.height();
    double sum = 0;
    for (int y = output.y0; y < output.y1; ++y)
        for (int x = output.x0; x < output.x1; ++x)
            sum += of_pixel(x, y);
    return sum;
}

bool moves_only(const Projective& m, int& dx, int& dy) {
    const auto& a = m.m;
    const bool shift = m.affine() && a[0] == 1 && a[1] == 0 && a[3] == 0 && a[4] == 1;
    const bool whole = shift && a[6] == std::floor(a[6]) && a[7] == std::floor(a[7]) &&
                       std::fabs(a[6]) < largest_coordinate && std::fabs(a[7]) < largest_coordinate;
    if (whole) {
        dx = int(a[6]);
        dy = int(a[7]);
    }
    return whole;
}

Mapping::Scale MatrixMapping::scale() const {
    const auto middle = [](int begin, int end) { return (double(begin) + double(end)) / 2; };
    const auto p =
        m_to_output(middle(m_display.x0, m_display.x1), middle(m_display.y0, m_display.y1));
    const Derivative of(m_to_output, p);
    const auto length = [](double x, double y) { return std::sqrt(x * x + y * y); };
    return {length(of.a, of.c), length(of.b, of.d)};
}

Rect MatrixMapping::reach(double x0, double y0, double x1, double y1) const {
    // To pixel coordinates, with the half pixel that clamps and some for rounding.
    constexpr double margin = 0.5 + 1.0 / 64;
    const double left = std::max(x0 + 0.5 - margin, m_window.x0 - 1.0);
    const double right = std::min(x1 + 0.5 + margin, m_window.x1 + 1.0);
    const double top = std::max(y0 + 0.5 - margin, m_window.y0 - 1.0);
    const double bottom = std::min(y1 + 0.5 + margin, m_window.y1 + 1.0);

    constexpr double infinity = std::numeric_limits<double>::infinity();
    double min_x = infinity, min_y = infinity, max_x = -infinity, max_y = -infinity;
    double min_w = infinity, max_w = -infinity;
    for (const double x : {left, right})
        for (const double y : {top, bottom}) {
            const auto p = m_to_output(x, y);
            min_w = std::min(min_w, p.w);
            max_w = std::max(max_w, p.w);
            min_x = std::min(min_x, p.x / p.w);
            max_x = std::max(max_x, p.x / p.w);
            min_y = std::min(min_y, p.y / p.w);
            max_y = std::max(max_y, p.y / p.w);
        }
    // Across the horizon, w = 0, a rectangle does not lie between its mapped corners.
    if (!(min_w > 0 || max_w < 0))
        return m_output;
    const auto first = [](double v, int begin, int end) {
        return int(std::clamp(std::floor(v - 0.5) - 1, double(begin), double(end)));
    };
    const auto last = [](double v, int begin, int end) {
        return int(std::clamp(std::ceil(v - 0.5) + 2, double(begin), double(end)));
    };
    return {first(min_x, m_output.x0, m_output.x1), first(min_y, m_output.y0, m_output.y1),
            last(max_x, m_output.x0, m_output.x1), last(max_y, m_output.y0, m_output.y1)};
}

void MatrixMapping::row(int y, int x0, int x1, Position* positions, uint8_t* inside) const {
    for (int x = x0; x < x1; ++x, ++positions, ++inside) {
        const auto p = m_to_source(x + 0.5, y + 0.5);
        const double sx = p.x / p.w, sy = p.y / p.w;
        // False for NaN too.
        *inside = sx >= m_window.x0 && sx < m_window.x1 && sy >= m_window.y0 && sy < m_window.y1;
        if (!*inside) {
            *positions = {};
            continue;
        }
        positions->x = int64_t(
            std::floor(clamp_position(sx - 0.5, m_window.x0, m_window.x1) * position_one + 0.5));
        positions->y = int64_t(
            std::floor(clamp_position(sy - 0.5, m_window.y0, m_window.y1) * position_one + 0.5));
    }
}

} // namespace ddt
