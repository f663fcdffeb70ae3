// SPDX-License-Identifier: Apache-2.0
#include "canvas.h"
#include "images.h"
#include "noise.h"
#include "shapes.h"

#include <algorithm>

namespace testimages {

namespace {

constexpr int width = 192, height = 144;
constexpr double shore = 88; ///< the row where the meadow begins

/// Over a colour, lay another where it covers.
void lay(Colour& below, const Colour& above, double cover = 1) {
    below = mix(below, above, cover);
}

Colour sky(Point p) {
    Colour blue = mix({0.06, 0.2, 0.55, 1}, {0.55, 0.66, 0.75, 1}, p.y / 75);
    double white = cloud(p.x / 34, p.y / 15, 11, 5);
    return mix(blue, {0.95, 0.93, 0.9, 1}, std::clamp((white - 0.52) * 5, 0.0, 0.9));
}

double ridge(double x, double base, double high, double wide, uint32_t seed) {
    return base - high * cloud(x / wide, 0.5, seed, 5);
}

Colour mountains(Point p, const Colour& behind) {
    if (p.y > ridge(p.x, 84, 62, 62, 3)) {
        double rock = cloud(p.x / 7, p.y / 9, 21, 4);
        bool snow = p.y < 40 + 14 * rock;
        return snow ? Colour{0.75, 0.8, 0.88, 1} * (0.55 + 0.6 * rock)
                    : mix({0.1, 0.13, 0.2, 1}, {0.3, 0.3, 0.33, 1}, rock);
    }
    return behind;
}

Colour meadow(Point p) {
    double blades = cloud(p.x / 1.6, p.y / 4.5, 31, 3), patches = cloud(p.x / 22, p.y / 9, 37, 3);
    Colour green = mix({0.05, 0.14, 0.02, 1}, {0.28, 0.38, 0.06, 1}, patches);
    return green * (0.45 + 1.1 * blades);
}

void house(Point p, Colour& c) {
    const Point low{26, 66}, high{84, 112};
    if (in_box(p, low, high)) {
        lay(c, Colour{0.8, 0.76, 0.66, 1} * (0.85 + 0.25 * cloud(p.x / 3, p.y / 3, 41, 3)));
        // Timber: uprights, beams and braces at odd angles.
        const Colour timber{0.06, 0.03, 0.015, 1};
        for (double x : {27.0, 45.5, 64.0, 83.0})
            if (std::abs(p.x - x) < 0.9)
                lay(c, timber);
        if (std::abs(p.y - 88) < 0.9 || on_line(p, {28, 88}, {45, 67}, 1.4) ||
            on_line(p, {82, 88}, {65, 67}, 1.4))
            lay(c, timber);
        for (Point corner : {Point{32, 92}, Point{69, 92}, Point{50, 71}}) {
            if (in_box(p, {corner.x - 1, corner.y - 1}, {corner.x + 10, corner.y + 12}))
                lay(c, grey(0.9));
            if (in_box(p, corner, {corner.x + 9, corner.y + 11}))
                lay(c, mix({0.02, 0.03, 0.05, 1}, {0.25, 0.35, 0.5, 1}, (p.x - corner.x) / 14));
            if (std::abs(p.x - corner.x - 4.5) < 0.5 || std::abs(p.y - corner.y - 5) < 0.5)
                if (in_box(p, corner, {corner.x + 9, corner.y + 11}))
                    lay(c, grey(0.9));
        }
        if (in_box(p, {50, 92}, {60, 112}))
            lay(c, std::fmod(p.x, 2.5) < 0.4 ? grey(0.02) : Colour{0.22, 0.03, 0.02, 1});
    }
    if (in_box(p, {66, 34}, {74, 56}))
        lay(c, std::fmod(p.y, 3.0) < 0.5 ? grey(0.3) : Colour{0.35, 0.1, 0.06, 1});
    if (in_polygon(p, {{18, 69}, {47, 36}, {77, 43}, {93, 70}})) {
        // Rows of tiles: shaded from row to row, and each a little different.
        double row = (p.y - 36) / 3.2, column = p.x / 3 + 0.5 * (int(row) % 2);
        double tile = hash01(int(column), int(row), 51);
        lay(c, Colour{0.5, 0.09, 0.04, 1} * ((0.6 + 0.5 * tile) * (1.1 - 0.5 * (row - int(row)))));
    }
    if (on_lines(p, {{17, 70}, {47, 35.5}, {77.5, 42.5}, {94, 70.5}}, 1.2))
        lay(c, grey(0.75));
}

void ball(Point p, Colour& c) {
    const Point centre{128, 114};
    const double radius = 17;
    double dx = (p.x - centre.x) / radius, dy = (p.y - centre.y) / radius;
    double shadow = std::hypot(dx - 0.35, (dy - 0.95) * 3.5);
    if (shadow < 1.1)
        lay(c, Colour{0.01, 0.02, 0.01, 1}, std::clamp((1.1 - shadow) * 2.5, 0.0, 0.7));
    if (dx * dx + dy * dy >= 1)
        return;
    double dz = std::sqrt(1 - dx * dx - dy * dy);
    double along = std::atan2(dx * 0.9 - dy * 0.44, dz) / pi;
    const Colour stripes[] = {
        {0.8, 0.05, 0.04, 1}, {0.9, 0.88, 0.8, 1}, {0.03, 0.12, 0.6, 1}, {0.95, 0.6, 0.02, 1}};
    Colour skin = stripes[int((along + 1) * 6) % 4];
    double lit = std::max(0.0, -0.5 * dx - 0.62 * dy + 0.6 * dz);
    lay(c, skin * (0.12 + 0.95 * lit));
    lay(c, grey(1), std::pow(lit, 40) * 0.9);
}

void tree(Point p, Colour& c) {
    if (in_polygon(p, {{160, 120}, {163, 84}, {167, 84}, {171, 120}}) ||
        on_line(p, {165, 92}, {176, 74}, 1.8) || on_line(p, {165, 88}, {153, 72}, 1.6))
        lay(c, Colour{0.12, 0.07, 0.035, 1} * (0.5 + cloud(p.x, p.y / 6, 61, 3)));
    double edge = 27 + 9 * cloud(p.x / 8, p.y / 8, 65, 3);
    double from = distance(p, {166, 56});
    double leaves = cloud(p.x / 2.6, p.y / 2.6, 67, 3);
    if (from < edge && leaves > 0.36 + 0.3 * std::max(0.0, from / edge - 0.6)) {
        double lit = std::clamp(0.75 - (p.x - 166) / 90 - (p.y - 56) / 60, 0.1, 1.3);
        lay(c, mix({0.015, 0.06, 0.01, 1}, {0.3, 0.42, 0.05, 1}, lit * (leaves - 0.25) * 1.5));
    }
}

void fence(Point p, Colour& c) {
    const Colour wood{0.62, 0.6, 0.55, 1};
    for (int i = 0; i < 15; ++i) {
        double x = 4 + i * 13.4, lean = (hash01(i, 0, 71) - 0.5) * 3;
        if (on_line(p, {x, 143}, {x + lean, 123}, 2))
            lay(c, wood * (0.7 + 0.5 * hash01(i, 1, 71)));
    }
    if (on_line(p, {-5, 128}, {197, 131}, 0.8) || on_line(p, {-5, 136}, {197, 138}, 0.8))
        lay(c, wood * 0.8);
}

Colour colour_at(double x, double y) {
    Point p{x, y};
    Colour c = mountains(p, sky(p));
    if (y > shore - 4 * noise(x / 40, 0, 5))
        c = meadow(p);
    house(p, c);
    tree(p, c);
    ball(p, c);
    fence(p, c);
    return c;
}

} // namespace

OIIO::ImageBuf scene() {
    return eight_bit(paint(width, height, colour_at), 3);
}

} // namespace testimages
