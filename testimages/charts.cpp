// SPDX-License-Identifier: Apache-2.0
#include "canvas.h"
#include "images.h"
#include "shapes.h"

namespace testimages {

OIIO::ImageBuf siemens_star() {
    constexpr int size = 128, wedges = 36;
    auto colour_at = [](double x, double y) {
        Point p{x, y}, centre{size / 2.0, size / 2.0};
        if (!in_disc(p, centre, size * 0.47))
            return grey(1);
        double turn = std::atan2(y - centre.y, x - centre.x) / (2 * pi) + 1;
        return grey(std::fmod(turn * wedges, 1.0) < 0.5 ? 0 : 1);
    };
    return eight_bit(paint(size, size, colour_at, 16), 1);
}

OIIO::ImageBuf zone_plate() {
    constexpr int size = 128;
    auto colour_at = [](double x, double y) {
        double dx = x - size / 2.0, dy = y - size / 2.0;
        return grey(0.5 + 0.5 * std::cos(pi * (dx * dx + dy * dy) / size));
    };
    return eight_bit(paint(size, size, colour_at, 4), 1);
}

OIIO::ImageBuf checkerboards() {
    constexpr int size = 64;
    auto colour_at = [](double x, double y) {
        int quarter = (x >= size / 2) + 2 * (y >= size / 2);
        const int sides[] = {1, 2, 3, 8};
        int side = sides[quarter];
        bool odd = (int(x) / side + int(y) / side) % 2 != 0;
        const Colour dark[] = {grey(0), {0.5, 0, 0, 1}, grey(0.2), {0, 0.05, 0.4, 1}};
        const Colour bright[] = {grey(1), {0.1, 0.6, 0.1, 1}, grey(0.25), {1, 0.9, 0.2, 1}};
        return odd ? dark[quarter] : bright[quarter];
    };
    return eight_bit(paint(size, size, colour_at, 1), 3);
}

OIIO::ImageBuf ramps() {
    constexpr int width = 48, height = 32;
    // One sample in the pixel's centre and steps of powers of two: every value is exact.
    auto colour_at = [](double x, double y) {
        return Colour{(x - 0.5) / 32, (y - 0.5) / 16, 1 + (x - 0.5) / 64 - (y - 0.5) / 32, 1};
    };
    return scene_linear(paint(width, height, colour_at, 1), 3, OIIO::TypeDesc::FLOAT);
}

} // namespace testimages
