// SPDX-License-Identifier: Apache-2.0
#include "canvas.h"
#include "images.h"
#include "shapes.h"

namespace testimages {

namespace {

/// A few glyph-like shapes in a box 1 wide and 1 high, moved and scaled: d, e, x, k, S.
bool on_glyph(int glyph, Point p, Point corner, double height, double width) {
    Point q{(p.x - corner.x) / height, (p.y - corner.y) / height};
    double w = width / height;
    switch (glyph) {
    case 0:
        return on_circle(q, {0.3, 0.7}, 0.24, w) || on_line(q, {0.56, 0.05}, {0.56, 0.95}, w);
    case 1:
        return on_line(q, {0.08, 0.7}, {0.54, 0.7}, w) ||
               (on_circle(q, {0.3, 0.7}, 0.24, w) && !in_box(q, {0.34, 0.74}, {0.9, 0.85}));
    case 2:
        return on_line(q, {0.08, 0.45}, {0.5, 0.95}, w) || on_line(q, {0.5, 0.45}, {0.08, 0.95}, w);
    case 3:
        return on_line(q, {0.1, 0.05}, {0.1, 0.95}, w) ||
               on_line(q, {0.1, 0.72}, {0.48, 0.42}, w) ||
               on_line(q, {0.22, 0.64}, {0.52, 0.95}, w);
    default:
        return on_lines(q,
                        {{0.5, 0.16},
                         {0.36, 0.06},
                         {0.16, 0.1},
                         {0.1, 0.28},
                         {0.2, 0.42},
                         {0.42, 0.52},
                         {0.52, 0.7},
                         {0.44, 0.9},
                         {0.22, 0.94},
                         {0.08, 0.82}},
                        w);
    }
}

bool on_text(Point p, Point corner, double height, double width, int first) {
    for (int i = 0; i < 9; ++i)
        if (on_glyph((first + i * 3) % 5, p, {corner.x + i * height * 0.72, corner.y}, height,
                     width))
            return true;
    return false;
}

} // namespace

OIIO::ImageBuf strokes() {
    const Colour paper{0.92, 0.9, 0.82, 1}, ink{0.01, 0.01, 0.03, 1}, red{0.6, 0.02, 0.02, 1};
    auto colour_at = [&](double x, double y) {
        Point p{x, y};
        if (on_text(p, {4, 3}, 10, 1, 0) || on_text(p, {72, 3}, 8, 0.8, 2))
            return ink;
        if (on_text(p, {4, 17}, 18, 2, 1))
            return ink;
        if (on_text(p, {4, 40}, 28, 4, 3))
            return red;
        if (in_box(p, {0, 74}, {144, 96}))
            return on_text(p, {5, 76}, 17, 1.6, 4) ? paper : ink;
        return paper;
    };
    return eight_bit(paint(144, 96, colour_at), 3);
}

OIIO::ImageBuf lines() {
    constexpr int size = 160;
    auto colour_at = [](double x, double y) {
        Point p{x, y};
        // A fan of lines a pixel wide, every 7.5 degrees, and one of half a pixel.
        for (int i = 0; i < 13; ++i) {
            double angle = i * pi / 24;
            Point direction{std::cos(angle), std::sin(angle)};
            if (on_line(p, {4, 4}, {4 + 68 * direction.x, 4 + 68 * direction.y}, 1))
                return grey(0);
            if (on_line(p, {size - 4.0, 4}, {size - 4 - 68 * direction.x, 4 + 68 * direction.y},
                        0.5))
                return Colour{0.1, 0.1, 0.5, 1};
        }
        for (int i = 1; i <= 6; ++i)
            if (on_circle(p, {42, 118}, i * 5.7, 0.4 * i))
                return Colour{0.5, 0.05, 0.02, 1};
        for (int i = 0; i < 4; ++i)
            if (in_disc(p, {92.0 + 19 * i, 92 + 0.25 * i}, 2.0 + 1.5 * i))
                return Colour{0.02, 0.3, 0.1, 1};
        if (in_polygon(p, {{86, 106}, {156, 120.5}, {140, 152}, {97, 147.3}}))
            return Colour{0.95, 0.7, 0.1, 1};
        return grey(1);
    };
    return eight_bit(paint(size, size, colour_at), 3);
}

OIIO::ImageBuf alpha() {
    const Colour nothing{0, 0, 0, 0};
    auto colour_at = [&](double x, double y) {
        Point p{x, y};
        if (on_text(p, {4, 70}, 20, 2.5, 1))
            return Colour{0, 0, 0, 1};
        if (in_disc(p, {30, 30}, 22))
            return mix({0.9, 0.2, 0.05, 1}, {0.1, 0.5, 0.9, 1}, x / 60);
        // Fades out over 30 pixels; the colour below goes on unchanged.
        double left = distance(p, {74, 32});
        if (left < 30)
            return Colour{0.05, 0.6, 0.2, 1 - left / 30};
        return nothing;
    };
    return eight_bit(paint(112, 96, colour_at), 4);
}

} // namespace testimages
