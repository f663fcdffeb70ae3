// SPDX-License-Identifier: Apache-2.0
// Which source position each output pixel shows.
#pragma once

#include <cstdint>

#include "ddt/rect.h"

namespace ddt {

/// One position in the source: pixel centres at integers, in units of 2^-16 pixel.
struct Position {
    int64_t x = 0, y = 0;
};

/// Which source position an output pixel shows. Called from several threads at once, whole rows and
/// parts of rows in any order and more than once: the answer must be a function of the pixel alone.
///
/// Positions lie within Job::window, from the centre of its first pixel to that of its last, on
/// both axes. A position outside reads nothing that is not there: its pixel shows the nearest
/// within the tile that asks, or is not written. Neighbours in a row at most 2 pixels apart are
/// fast; longer steps are allowed.
class Mapping {
public:
    virtual ~Mapping() = default;
    /// A rectangle that holds every output pixel whose position lies in the source rectangle
    /// [x0, x1) x [y0, y1) (pixel centres at integers). Its sides may be -infinity or +infinity:
    /// clamp them to Job::window before computing with them. The result lies within
    /// +-largest_coordinate. It may hold other pixels too, which row() is then asked for in vain.
    /// Asked for tiles of 256 x 256 pixels, for whole rows and columns of tiles and, unless
    /// separable(), for parts of tiles, which are 32 wide.
    virtual Rect reach(double x0, double y0, double x1, double y1) const = 0;
    /// Positions of the output pixels x0 <= x < x1 of row y. inside[i] = 0 marks a pixel that shows
    /// nothing of the source: it is not written.
    virtual void row(int y, int x0, int x1, Position* positions, uint8_t* inside) const = 0;
    /// True if reach() holds exactly the pixels of its rectangle, row() is all inside, x depends on
    /// the column alone and y on the row alone. Where both ascend it is fast.
    virtual bool separable() const { return false; }
    /// About how many output pixels lie across a source pixel, along the source's axes; 0 or more.
    struct Scale {
        double x, y;
    };
    /// Where vertices are corrected (SurfaceOptions::consistency, fitted), that is in full from 2
    /// on; the nearer to 1, the less, as an output pixel is then itself a mean over about as much
    /// as a source pixel. Along two axes: the mean of both. Asked once or more a job, which must
    /// get the same each time, whichever part of the output it makes.
    virtual Scale scale() const { return {2, 2}; }
};

/// Maps the interval [from0, from0 + from_size) onto [to0, to0 + to_size), pixel centres at half
/// integers, on both axes; positions outside `window` clamp to its outermost pixel centres.
///
/// To be seen to by the caller: on each axis from_size and to_size are at least 1, window0 <
/// window1, out0 <= out1, and all intervals lie within +-largest_coordinate.
class ResizeMapping final : public Mapping {
public:
    struct Axis {
        int from0 = 0, from_size = 1; ///< the source's display window
        int to0 = 0, to_size = 1;     ///< the output's display window
        int window0 = 0, window1 = 1; ///< the source's data window
        int out0 = 0, out1 = 1;       ///< the output pixels wanted
        /// Source position of the output pixel i, clamped, in 2^-16 pixel, by integer arithmetic.
        int64_t position(int i) const;
        /// First output pixel of [out0, out1) whose position is >= limit (a pixel coordinate).
        int first_at_or_after(int limit) const;
        /// Output pixels across a source pixel.
        double scale() const { return double(to_size) / from_size; }
        /// All of `from` pixels made all of `to`.
        static Axis whole(int from, int to) { return {0, from, 0, to, 0, from, 0, to}; }
    };
    ResizeMapping(const Axis& x, const Axis& y) : m_x(x), m_y(y) {}
    Rect reach(double x0, double y0, double x1, double y1) const override;
    void row(int y, int x0, int x1, Position* positions, uint8_t* inside) const override;
    bool separable() const override { return true; }
    Scale scale() const override { return {m_x.scale(), m_y.scale()}; }

private:
    Axis m_x, m_y;
};

} // namespace ddt
