// SPDX-License-Identifier: Apache-2.0
#include "plugin/openfx/windows.h"

#include <algorithm>
#include <cmath>

#include "plugin/host/enlargement.h"

namespace ddt::ofx {
namespace {

/// The pixels that an interval touches, but for less than a hundredth of one.
int begin_of(double v) {
    return int(std::floor(std::clamp(v, -1e9, 1e9) + 0.01));
}
int end_of(double v) {
    return int(std::ceil(std::clamp(v, -1e9, 1e9) - 0.01));
}

void factors(const Rect& window, const Settings& s, double& x, double& y) {
    x = s.width > 0 ? double(s.width) / window.width() : s.scale_x;
    y = s.height > 0 ? double(s.height) / window.height() : s.scale_y;
    if (s.width > 0 && s.height <= 0)
        y = x;
    if (s.height > 0 && s.width <= 0)
        x = y;
}

/// The enlargement placed so that the centre stays.
Rect zoomed(const Rect& window, const Settings& s) {
    Rect full = host::scaled(window, s.scale_x, s.scale_y);
    const int more_x = full.width() - window.width(), more_y = full.height() - window.height();
    const int x0 = window.x0 - int(std::lround(std::clamp(s.centre_x, 0.0, 1.0) * more_x));
    // Downwards from the top.
    const int y0 = window.y0 - int(std::lround((1 - std::clamp(s.centre_y, 0.0, 1.0)) * more_y));
    return {x0, y0, x0 + full.width(), y0 + full.height()};
}

} // namespace

Rect to_pixels(const RectD& r, const PixelScale& scale) {
    return host::flipped({begin_of(r.x1 * scale.x), begin_of(r.y1 * scale.y),
                          end_of(r.x2 * scale.x), end_of(r.y2 * scale.y)});
}

RectD to_canonical(const Rect& pixels, const PixelScale& scale) {
    const Rect r = host::flipped(pixels);
    return {r.x0 / scale.x, r.y0 / scale.y, r.x1 / scale.x, r.y1 / scale.y};
}

Windows windows_of(const RectD& region, const PixelScale& scale, const PixelScale& at_full_scale,
                   const Settings& settings, bool zoom) {
    Windows w;
    w.window = to_pixels(region, scale);
    if (!w.bounded()) {
        w.full = w.shown = w.window;
        return w;
    }
    if (zoom) {
        w.full = zoomed(w.window, settings);
        w.shown = w.window;
        return w;
    }
    const Rect whole = to_pixels(region, at_full_scale);
    double x = 1, y = 1;
    factors(whole, settings, x, y);
    const Rect upwards = host::scaled(host::flipped(whole), x, y);
    w.full = to_pixels(to_canonical(host::flipped(upwards), at_full_scale), scale);
    // A hair above 1 and at a small render scale it might come out smaller.
    w.full.x1 = std::max(w.full.x1, w.full.x0 + w.window.width());
    w.full.y0 = std::min(w.full.y0, w.full.y1 - w.window.height());
    w.shown = w.full;
    return w;
}

} // namespace ddt::ofx
