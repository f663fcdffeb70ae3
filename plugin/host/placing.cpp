// SPDX-License-Identifier: Apache-2.0
#include "plugin/host/placing.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/tiles/cuts.h"
#include "core/tiles/tile_io.h"

namespace ddt::host {
namespace {

/// Beyond every limit of windows, and within ints.
constexpr double farthest = 1e9;

/// A factor as so many pixels that become others.
struct Ratio {
    int from = 1, to = 1;
};

/// The one of the smallest numbers that differs by less than two roundings of a float, as hosts'
/// numbers do too: so 1.1 is 11/10, and positions are those of a result of just this many pixels.
/// Where that takes more than most_to pixels of a result, the nearest of so many; fewer would make
/// an eased zoom stand still next to whole factors, and then jump. By continued fractions.
Ratio ratio_of(double factor) {
    constexpr double largest = 1 << 14, most_to = 1 << 28, near = 0x1p-22;
    factor = std::clamp(factor, 1.0, largest);
    const double most_from = std::floor(most_to / factor);
    double rest = factor;
    double from = 1, to = std::floor(rest), from_before = 0, to_before = 1;
    while (std::abs(to / from - factor) > near * factor) {
        rest = 1 / (rest - std::floor(rest));
        const double a = std::floor(rest);
        const double next = a * from + from_before;
        if (next > most_from) {
            const double fewer = std::floor((most_from - from_before) / from);
            const double last = fewer * from + from_before, of_last = fewer * to + to_before;
            if (std::abs(of_last / last - factor) < std::abs(to / from - factor)) {
                from = last;
                to = of_last;
            }
            break;
        }
        from_before = std::exchange(from, next);
        to_before = std::exchange(to, a * to + to_before);
    }
    return {int(from), int(to)};
}

/// (x, y) stays where it is.
Placing stretched(const Rect& window, const Rect& full, int x, int y, double x_factor,
                  double y_factor) {
    const Ratio along = ratio_of(x_factor), down = ratio_of(y_factor);
    return {window, full, {x, y, x + along.from, y + down.from}, {x, y, x + along.to, y + down.to}};
}

/// Positions of the pixels of a part of the result.
ResizeMapping::Axis x_axis(const Placing& p, const Rect& box) {
    return {p.from.x0,   p.from.width(), p.to.x0, p.to.width(),
            p.window.x0, p.window.x1,    box.x0,  box.x1};
}
ResizeMapping::Axis y_axis(const Placing& p, const Rect& box) {
    return {p.from.y0,   p.from.height(), p.to.y0, p.to.height(),
            p.window.y0, p.window.y1,     box.y0,  box.y1};
}

} // namespace

ResizeMapping Placing::mapping(const Rect& box) const {
    return {x_axis(*this, box), y_axis(*this, box)};
}

Placing onto(const Rect& window, const Rect& full) {
    return {window, full, window, full};
}

int begin_of(double v, double hair) {
    return int(std::floor(std::clamp(v, -farthest, farthest) + hair));
}

int end_of(double v, double hair) {
    return int(std::ceil(std::clamp(v, -farthest, farthest) - hair));
}

Placing by_factors(const Rect& window, double x_factor, double y_factor) {
    const Rect full{begin_of(window.x0 * x_factor), begin_of(window.y0 * y_factor),
                    end_of(window.x1 * x_factor), end_of(window.y1 * y_factor)};
    return stretched(window, full, 0, 0, x_factor, y_factor);
}

Placing about(int x, int y, const Rect& window, double x_factor, double y_factor) {
    return stretched(window, window, x, y, x_factor, y_factor);
}

Rect scaled(const Rect& window, double x_factor, double y_factor) {
    const auto times = [](int n, double factor) {
        return int(std::lround(std::clamp(double(n) * factor, -farthest, farthest)));
    };
    Rect r;
    r.x0 = times(window.x0, x_factor);
    r.y0 = times(window.y0, y_factor);
    r.x1 = r.x0 + std::max(1, times(window.width(), x_factor));
    r.y1 = r.y0 + std::max(1, times(window.height(), y_factor));
    return r;
}

Rect needed(const Placing& place, const Rect& box, Holes holes) {
    const Rect& window = place.window;
    const Rect part = intersection(place.full, box);
    if (window.empty() || part.empty())
        return {};
    if (holes != Holes::keep)
        return window;
    if (place.copies()) {
        const int x = place.from.x0 - place.to.x0, y = place.from.y0 - place.to.y0;
        return {part.x0 + x, part.y0 + y, part.x1 + x, part.y1 + y};
    }
    const Grid tiles = shown_tiles(window, place.mapping(part));
    const Rect first = tiles.tile(0).pixels, last = tiles.tile(tiles.count() - 1).pixels;
    return {first.x0, first.y0, last.x1, last.y1};
}

Rect made_at_once(const Placing& place, const Rect& box, Holes holes) {
    constexpr int little = 1024, most = 2048; // pixels along an axis
    const Rect part = intersection(place.full, box);
    if (part.empty() || (place.copies() && holes == Holes::keep))
        return part;
    if (holes != Holes::keep || place.full.area() <= most_at_once)
        return place.full;
    Rect r = part;
    const auto grow = [](const ResizeMapping::Axis& axis, int& begin, int& end) {
        if (end - begin >= little)
            return;
        const std::vector<int> cuts = cuts_between_tiles(axis, little, most);
        begin = cuts[piece_of(cuts, begin)];
        end = cuts[piece_of(cuts, end - 1) + 1];
    };
    grow(x_axis(place, place.full), r.x0, r.x1);
    grow(y_axis(place, place.full), r.y0, r.y1);
    return r;
}

} // namespace ddt::host
