// SPDX-License-Identifier: Apache-2.0
// Where a host's picture lies and where its enlargement.
#pragma once

#include "ddt/core.h"

namespace ddt::host {

struct Placing {
    Rect window;   ///< all of the source: what edges are sought in, and where tiles begin
    Rect full;     ///< all of the result; pixels that no position lies within show the nearest
    Rect from, to; ///< by how much all is enlarged: pixels of the source become these of the result

    /// Whether the result has the source's pixels as they are, but for holes that are filled.
    bool copies() const {
        return from.width() == to.width() && from.height() == to.height() &&
               window.width() == full.width() && window.height() == full.height();
    }
    /// Positions of the pixels of a part of `full`.
    ResizeMapping mapping(const Rect& box) const;
};

/// All of `window` becomes all of `full`.
Placing onto(const Rect& window, const Rect& full);

/// Everything lies by the factors, at least 1, from where it was to (0, 0): so a picture that is
/// cut off differently from frame to frame does not move. `full` has the pixels that the enlarged
/// window touches, but for less than a hundredth of one.
Placing by_factors(const Rect& window, double x_factor, double y_factor);

/// Enlarged by the factors, at least 1, and cut off to the window again, so that (x, y), a corner
/// of pixels, stays where it is.
Placing about(int x, int y, const Rect& window, double x_factor, double y_factor);

/// `window` enlarged by factors: sizes rounded to whole pixels, at least 1; the corner rounded too.
Rect scaled(const Rect& window, double x_factor, double y_factor);

/// Where the pixels begin and end that an interval from or to here touches, but for less than
/// `hair` of one.
int begin_of(double v, double hair = 0.01);
int end_of(double v, double hair = 0.01);

/// The pixels of the window that the part `box` of the result depends on: whole tiles and their
/// halos; to fill holes the whole of it. Empty if box misses `full`.
Rect needed(const Placing& place, const Rect& box, Holes holes = Holes::keep);

/// What of the result is best made at once for a host that asks for the part `box`, keeps what it
/// gets, and is likely to ask for what lies beside it: everything, so that no tile is worked on
/// twice, if that is at most most_at_once pixels; of more, which the host may not want or not have
/// memory for, along an axis where it asks for little what lies with it on the same tiles. Filled
/// holes are those of everything.
Rect made_at_once(const Placing& place, const Rect& box, Holes holes = Holes::keep);
constexpr size_t most_at_once = size_t(1) << 26;

} // namespace ddt::host
