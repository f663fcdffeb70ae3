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
    const Rect& window = place.window;
    const bool is_window = defined.x0 == window.x0 && defined.y1 == window.y1 &&
                           (defined.x1 == window.x1 || defined.x1 == least.x1) &&
                           (defined.y0 == window.y0 || defined.y0 == least.y0);
    return is_window && !defined.empty() && !least.empty() ? defined : window;
}

Rect Windows::needed(const Rect& box, Holes holes) const {
    const Rect usual = host::needed(place, box, holes);
    host::Placing shorter = place;
    // Tiles are counted from the upper side, so that all of them lie elsewhere then.
    shorter.window.y0 = least.y0;
    const Rect other = host::needed(shorter, box, holes);
    if (usual.empty() || other.empty())
        return usual;
    return {std::min(usual.x0, other.x0), std::min(usual.y0, other.y0),
            std::max(usual.x1, other.x1), std::max(usual.y1, other.y1)};
}

Windows windows_of(const RectD& region, const PixelScale& scale, const PixelScale& at_full_scale,
                   const Settings& settings, bool zoom) {
    Windows w;
    const Rect& window = w.place.window = to_pixels(region, scale);
    w.least = window;
    w.least.x1 = std::min(window.x1, host::begin_of(region.x2 * scale.x, 0));
    w.least.y0 = std::max(window.y0, -host::begin_of(region.y2 * scale.y, 0));
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
