// SPDX-License-Identifier: Apache-2.0
#include "plugin/openfx/windows.h"

#include <algorithm>
#include <cmath>

#include "plugin/host/buffer.h"

namespace ddt::ofx {
namespace {

/// By settings of the result's size, at least the source's.
void factors(const Rect& window, const Settings& s, double& x, double& y) {
    x = s.width > 0 ? double(s.width) / window.width() : 0;
    y = s.height > 0 ? double(s.height) / window.height() : 0;
    x = std::max(x > 0 ? x : y, 1.0);
    y = std::max(y > 0 ? y : x, 1.0);
}

/// What becomes what at another render scale than it does here, but for less than a pixel.
Rect at_scale(const Rect& here, const PixelScale& factor) {
    const auto times = [](int n, double f) { return int(std::lround(n * f)); };
    const int x0 = times(here.x0, factor.x), y0 = times(here.y0, factor.y);
    return {x0, y0, x0 + here.width(), y0 + here.height()};
}

/// The nearest corner of pixels to the centre, which so stays the same while the scale changes.
host::Placing zoomed(const Rect& window, const Settings& s) {
    const auto within = [](int begin, int size, double share) {
        return begin + int(std::lround(std::clamp(share, 0.0, 1.0) * size));
    };
    // Downwards from the top.
    return host::about(within(window.x0, window.width(), s.centre_x),
                       within(window.y0, window.height(), 1 - s.centre_y), window, s.scale_x,
                       s.scale_y);
}

/// The smallest rectangle with the pixels of both.
Rect hull(const Rect& a, const Rect& b) {
    if (a.empty() || b.empty())
        return a.empty() ? b : a;
    return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

} // namespace

Rect to_pixels(const RectD& r, const PixelScale& scale, double hair) {
    return host::flipped({host::begin_of(r.x1 * scale.x, hair),
                          host::begin_of(r.y1 * scale.y, hair), host::end_of(r.x2 * scale.x, hair),
                          host::end_of(r.y2 * scale.y, hair)});
}

RectD to_canonical(const Rect& pixels, const PixelScale& scale) {
    const Rect r = host::flipped(pixels);
    return {r.x0 / scale.x, r.y0 / scale.y, r.x1 / scale.x, r.y1 / scale.y};
}

RectD to_region(const Rect& pixels, const PixelScale& scale) {
    // Where a pixel is a unit nothing is rounded.
    const auto drawn_in = [](double side, double s, double inwards) {
        return s == 1 ? side : side + inwards * std::abs(side) * 0x1p-49;
    };
    const RectD r = to_canonical(pixels, scale);
    return {drawn_in(r.x1, scale.x, 1), drawn_in(r.y1, scale.y, 1), drawn_in(r.x2, scale.x, -1),
            drawn_in(r.y2, scale.y, -1)};
}

Rect Windows::window_of(const Rect& defined) const {
    const auto rounded = [](int side, double of) { return std::abs(side - of) < 1; };
    const bool is_window = rounded(defined.x0, region.x1) && rounded(defined.y0, region.y1) &&
                           rounded(defined.x1, region.x2) && rounded(defined.y1, region.y2);
    // What lies beyond the window has less than a hair of the region.
    const Rect common = intersection(defined, place.window);
    return is_window && !common.empty() ? common : place.window;
}

Rect Windows::needed(const Rect& box, Holes holes) const {
    Rect all = host::needed(place, box, holes);
    // Tiles are counted from the left and the upper side, so that all of them lie elsewhere then.
    host::Placing other = place;
    for (int sides = 0; sides < 16; ++sides) { // a bit says that one is rounded up
        const auto rounded = [&](int bit, double side) {
            return int(sides & bit ? std::ceil(side) : std::floor(side));
        };
        other.window = window_of({rounded(1, region.x1), rounded(2, region.y1),
                                  rounded(4, region.x2), rounded(8, region.y2)});
        if (!(other.window == place.window))
            all = hull(all, host::needed(other, box, holes));
    }
    return all;
}

Windows windows_of(const RectD& region, const PixelScale& scale, const PixelScale& at_full_scale,
                   const Settings& settings, bool zoom) {
    Windows w;
    const Rect& window = w.place.window = to_pixels(region, scale);
    w.region = {region.x1 * scale.x, -region.y2 * scale.y, region.x2 * scale.x,
                -region.y1 * scale.y};
    if (!w.bounded()) {
        w.place = host::onto(window, window);
        return w;
    }
    const Rect whole = to_pixels(region, at_full_scale);
    host::Placing at_full;
    if (zoom) {
        w.place = zoomed(window, settings);
        at_full.full = whole;
    } else if (settings.width > 0 || settings.height > 0) {
        double x = 1, y = 1;
        factors(whole, settings, x, y);
        const Rect upwards = host::scaled(host::flipped(whole), x, y);
        at_full = host::onto(whole, host::flipped(upwards));
        const PixelScale factor{scale.x / at_full_scale.x, scale.y / at_full_scale.y};
        w.place.from = at_scale(at_full.from, factor);
        w.place.to = at_scale(at_full.to, factor);
    } else {
        at_full = host::by_factors(whole, settings.scale_x, settings.scale_y);
        w.place.from = at_full.from;
        w.place.to = at_full.to;
    }
    Rect& full = w.place.full;
    // As the host does, which asks for all that the region touches.
    full = to_pixels(to_canonical(at_full.full, at_full_scale), scale, 1e-6);
    // A hair above 1 and at a small render scale it might come out smaller.
    full.x1 = std::max(full.x1, full.x0 + window.width());
    full.y0 = std::min(full.y0, full.y1 - window.height());
    return w;
}

} // namespace ddt::ofx
