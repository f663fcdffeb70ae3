// SPDX-License-Identifier: Apache-2.0
// Where the picture lies and where its enlargement. Hosts count rows upwards and speak of regions
// in canonical coordinates: pixels at render scale 1, made square. Here all are pixels of the
// render scale, rows downwards: mirrored about y = 0 (host::flipped), so that ties break as in
// oiiotool.
#pragma once

#include "plugin/host/placing.h"
#include "plugin/openfx/abi.h"
#include "plugin/openfx/settings.h"

namespace ddt::ofx {

/// Pixels a canonical unit has.
struct PixelScale {
    double x = 1, y = 1;
};

struct Windows {
    host::Placing place; ///< window, full: the regions of definition of source and output
    /// The source's region in pixels, rows downwards. The window is all that it touches, as most
    /// hosts have it; others round sides down, up, or to the nearest pixel.
    RectD region{};

    /// The window of an image that is said to be a part of `defined`: as much of the window as that
    /// has, if each side is the region's, rounded in whatever way. Hosts that say others do not
    /// mean pixels, or a tile.
    Rect window_of(const Rect& defined) const;
    /// See host::needed(); of each such window, as the image that tells which is not there yet.
    Rect needed(const Rect& box, Holes holes) const;

    /// Whether there is a picture, and not an endless one, as that of a constant.
    bool bounded() const { return !place.window.empty() && place.window.within_limits(); }
};

/// What a region touches, but for less than `hair` of a pixel.
Rect to_pixels(const RectD& canonical, const PixelScale& scale, double hair = 0.01);
RectD to_canonical(const Rect& pixels, const PixelScale& scale);
/// The same for a host that looks for the pixels that the region touches: its right side times the
/// scale may come out a hair beyond the whole number, and the host then wants a pixel more. So
/// sides that are rounded are drawn in by more than that, and by less than any host sees.
RectD to_region(const Rect& pixels, const PixelScale& scale);

/// `region`: the source's, canonical. At render scales other than 1 `full` is that of scale 1,
/// scaled along, as the host expects it. An endless region stays as it is.
Windows windows_of(const RectD& region, const PixelScale& scale, const PixelScale& at_full_scale,
                   const Settings& settings, bool zoom);

} // namespace ddt::ofx
