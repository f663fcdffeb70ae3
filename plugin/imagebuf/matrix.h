// SPDX-License-Identifier: Apache-2.0
// The mapping of a warp by a 3x3 matrix.
#pragma once

#include <array>

#include "ddt/core.h"

namespace ddt {

/// A projective map of the plane, (x, y, 1) * M as OpenImageIO multiplies: rows of M are what x, y
/// and 1 contribute.
struct Projective {
    std::array<double, 9> m{1, 0, 0, 0, 1, 0, 0, 0, 1};

    struct Point {
        double x, y, w; ///< the point is (x / w, y / w)
    };
    Point operator()(double x, double y) const {
        return {x * m[0] + y * m[3] + m[6], x * m[1] + y * m[4] + m[7], x * m[2] + y * m[5] + m[8]};
    }
    bool affine() const { return m[2] == 0 && m[5] == 0 && m[8] == 1; }
    /// False if the matrix has no inverse, or is not finite.
    bool invert(Projective& inverse) const;
    /// The same map by a matrix whose largest entry is 1 to 2, where all are below 2^-30: in
    /// float32, in which OpenImageIO inverts it, its determinant would be 0. By a power of two, so
    /// what is computed from it has the same bits.
    Projective scaled_up() const;
    /// The inverse that OpenImageIO goes by, if it is given scaled_up(): Imath's, in float32. Of a
    /// nearly singular matrix it is another map, and the identity where there is none.
    Projective float_inverse() const;
};

/// A scale below 1 by no more than this is not a smaller one: matrices arrive in float32.
constexpr double shrink_tolerance = 1e-3;

/// True if a picture in `window` gets smaller somewhere and in some direction, by more than
/// shrink_tolerance. Pixel coordinates, centres at half integers.
bool shrinks(const Projective& m, const Rect& window);

/// About the source pixels that a filter `width` pixels wide goes through for the pixels of
/// `output`: for each those of the upright rectangle that its image and the width span, in the
/// picture or not. Infinity where there is no end of them.
double filtered_pixels(const Projective& to_source, const Rect& output, double width);

/// If `m` moves pixels by whole numbers and does nothing else, true, and by what.
bool moves_only(const Projective& m, int& dx, int& dy);

/// Output pixels under a projective map. A pixel is inside if its centre comes from within the
/// area of the window's pixels; the half pixel round the hull of their centres clamps to it.
/// Positions are computed in double and rounded to 2^-16 pixel.
class MatrixMapping final : public Mapping {
public:
    /// `to_source` takes output to source pixel coordinates, `to_output` is its inverse. window: of
    /// the source's pixels; display: its display window.
    MatrixMapping(const Projective& to_source, const Projective& to_output, const Rect& window,
                  const Rect& display, const Rect& output)
        : m_to_source(to_source), m_to_output(to_output), m_window(window), m_display(display),
          m_output(output) {}
    Rect reach(double x0, double y0, double x1, double y1) const override;
    void row(int y, int x0, int x1, Position* positions, uint8_t* inside) const override;
    /// That in the middle of the display window, which is the same however little of it has pixels.
    Scale scale() const override;

private:
    Projective m_to_source, m_to_output;
    Rect m_window, m_display, m_output;
};

} // namespace ddt
