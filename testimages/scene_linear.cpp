// SPDX-License-Identifier: Apache-2.0
#include "canvas.h"
#include "images.h"
#include "noise.h"
#include "shapes.h"

#include <OpenImageIO/imagebufalgo.h>

namespace testimages {

OIIO::ImageBuf light() {
    auto colour_at = [](double x, double y) {
        Point p{x, y};
        if (in_disc(p, {20, 18}, 6.3))
            return Colour{1000, 900, 700, 1};
        if (on_line(p, {36, 6}, {58, 41}, 1.5))
            return Colour{40, 60, 1000, 1};
        if (x > 40)
            return Colour{0.18, 0.16, 0.12, 1} * (0.5 + cloud(x / 5, y / 5, 7, 3));
        return grey(0);
    };
    return scene_linear(paint(64, 48, colour_at), 3, OIIO::TypeDesc::HALF);
}

OIIO::ImageBuf window() {
    auto colour_at = [](double x, double y) {
        Point p{x, y};
        if (on_circle(p, {24, 20}, 14, 2.2))
            return Colour{0.8, 0.1, 0.05, 1};
        if (in_polygon(p, {{8, 4}, {44, 17}, {20, 37}}))
            return Colour{0.1, 0.4, 0.9, 0.6};
        return Colour{0.3, 0.3, 0.3, 0.25 * y / 40};
    };
    OIIO::ImageBuf image = scene_linear(paint(48, 40, colour_at), 4, OIIO::TypeDesc::HALF);
    image.specmod().x = -9;
    image.specmod().y = 13;
    image.set_full(0, 64, 0, 48, 0, 1);
    return image;
}

namespace {

/// Two objects before nothing. Their numbers are far from what an interpolation would give.
struct Thing {
    uint32_t number;
    float depth;
    Colour colour;
};

Thing thing_at(double x, double y) {
    Point p{x, y};
    if (in_disc(p, {17, 16}, 10.5))
        return {0xdeadbeefu, 2.5f, {0.7, 0.3, 0.1, 1}};
    if (in_polygon(p, {{20, 4}, {45, 10}, {38, 30}, {14, 25}}))
        return {4000000007u, 4, {0.1, 0.2, 0.6, 1}};
    return {0, 1000, {0, 0, 0, 0}};
}

constexpr int things_width = 48, things_height = 32;

} // namespace

OIIO::ImageBuf layers() {
    OIIO::ImageBuf colour =
        scene_linear(paint(things_width, things_height,
                           [](double x, double y) { return thing_at(x, y).colour; }),
                     4, OIIO::TypeDesc::FLOAT);
    OIIO::ImageSpec spec = colour.spec();
    spec.nchannels = 6;
    spec.channelnames = {"R", "G", "B", "A", "Z", "objectid"};
    spec.z_channel = 4;
    OIIO::ImageBuf image(spec);
    OIIO::ImageBufAlgo::paste(image, 0, 0, 0, 0, colour);
    for (OIIO::ImageBuf::Iterator<float> it(image); !it.done(); ++it) {
        Thing thing = thing_at(it.x() + 0.5, it.y() + 0.5);
        it[4] = thing.depth;
        it[5] = float(thing.number >> 8); // a float holds 24 bits
    }
    return image;
}

OIIO::ImageBuf ids() {
    OIIO::ImageSpec spec(things_width, things_height, 1, OIIO::TypeDesc::UINT32);
    spec.channelnames = {"objectid"};
    spec.attribute("oiio:ColorSpace", "Linear");
    std::vector<uint32_t> numbers;
    for (int y = 0; y < things_height; ++y)
        for (int x = 0; x < things_width; ++x)
            numbers.push_back(thing_at(x + 0.5, y + 0.5).number);
    OIIO::ImageBuf image(spec);
    image.set_pixels(image.roi(), OIIO::TypeDesc::UINT32, numbers.data());
    return image;
}

} // namespace testimages
