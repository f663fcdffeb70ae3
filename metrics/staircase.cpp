// SPDX-License-Identifier: Apache-2.0
#include "metrics/staircase.h"

#include <cmath>

namespace metrics {

namespace {

constexpr int size = 48;
constexpr double pi = 3.14159265358979323846;

/// Share of the unit square round the origin where nx x + ny y < limit: the integral of a
/// trapezoid.
double covered(double nx, double ny, double limit) {
    double a = std::abs(nx) / 2, b = std::abs(ny) / 2;
    if (a < b)
        std::swap(a, b);
    if (b < 1e-12) // the edge runs along the pixels
        return std::fmin(std::fmax((limit + a) / (2 * a), 0.0), 1.0);
    // Convolution of two boxes of half widths a and b, integrated: differences of half squares.
    auto half_square = [](double t) { return t > 0 ? t * t / 2 : 0.0; };
    return (half_square(limit + a + b) - half_square(limit + a - b) - half_square(limit - a + b) +
            half_square(limit - a - b)) /
           (4 * a * b);
}

Plane edge(double angle) {
    // Off the centre by odd fractions, so that no edge runs through a lattice of corners.
    double nx = -std::sin(angle), ny = std::cos(angle);
    double offset = nx * (size / 2 + 0.137) + ny * (size / 2 - 0.211);
    Plane plane(size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            plane.at(x, y) = 192 - 128 * covered(nx, ny, offset - nx * (x + 0.5) - ny * (y + 0.5));
    return plane;
}

/// Sums for a straight-line fit of v over u.
struct Fit {
    double n = 0, u = 0, v = 0, uu = 0, uv = 0, vv = 0;
    void add(double x, double y) {
        ++n;
        u += x;
        v += y;
        uu += x * x;
        uv += x * y;
        vv += y * y;
    }
    /// Root mean square distance, at right angles, from the line v = p u + q.
    double deviation() const {
        double suu = uu / n - u / n * (u / n), suv = uv / n - u / n * (v / n),
               svv = vv / n - v / n * (v / n);
        double slope = suv / suu;
        double residual = std::fmax(svv - slope * suv, 0.0);
        return std::sqrt(residual / (1 + slope * slope));
    }
};

} // namespace

double staircase_at(const std::function<Plane(const Plane&)>& enlarge, int scale, double angle) {
    Plane large = enlarge(edge(angle));
    // Look across the edge: along rows if it is steep, along columns if it is flat.
    bool steep = std::abs(std::sin(angle)) > std::abs(std::cos(angle));
    auto value = [&](int along, int across) {
        return steep ? large.at(across, along) : large.at(along, across);
    };
    // The middle third only: there every line across meets the edge well inside the picture.
    Fit fit;
    for (int along = size * scale / 3; along < size * scale * 2 / 3; ++along)
        for (int across = 0; across + 1 < size * scale; ++across) {
            double u = value(along, across) - 128, v = value(along, across + 1) - 128;
            if ((u < 0) != (v < 0)) {
                fit.add((along + 0.5) / scale, (across + 0.5 + u / (u - v)) / scale);
                break;
            }
        }
    return fit.n > 0 ? fit.deviation() : 0;
}

Staircase staircase(const std::function<Plane(const Plane&)>& enlarge, int scale) {
    Staircase all;
    int count = 0;
    for (int degrees = 0; degrees < 180; degrees += 3, ++count) {
        const double one = staircase_at(enlarge, scale, degrees * pi / 180);
        all.mean += one;
        all.worst = std::fmax(all.worst, one);
    }
    all.mean /= count;
    return all;
}

} // namespace metrics
