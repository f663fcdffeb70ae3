// SPDX-License-Identifier: Apache-2.0
// Images in a caller's memory with room between the pixels, by every way that copies them.
#include <cmath>
#include <functional>
#include <limits>

#include <OpenImageIO/Imath.h>

#include "tests/plugin/images.h"

namespace {

using images::bytes;
using images::value;
using images::window;
using OIIO::ImageBuf;

constexpr int columns = 14, rows = 11, numbers = 3, room = 5;

ImageBuf noise(bool holed) {
    ImageBuf image = images::make(columns, rows, numbers);
    images::noise(image);
    const float nan[numbers] = {std::nanf(""), std::nanf(""), std::nanf("")};
    for (int x = 5; holed && x < 8; ++x)
        image.setpixel(x, 4, nan);
    return image;
}

/// The same pixels in `memory`.
ImageBuf with_room(const ImageBuf& image, std::vector<float>& memory) {
    memory.assign(size_t(columns * rows * room), -7.0f);
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x)
            for (int c = 0; c < numbers; ++c)
                memory[size_t((y * columns + x) * room + c)] = value(image, x, y, c);
    return ImageBuf(image.spec(), memory.data(), room * sizeof(float),
                    columns * room * sizeof(float));
}

struct Way {
    const char* name;
    /// dst may be src.
    std::function<bool(ImageBuf& dst, const ImageBuf& src)> make;
};

ddt::Options filling() {
    ddt::Options options;
    options.holes = ddt::Holes::fill;
    return options;
}

const Way ways[] = {
    {"fill", [](ImageBuf& dst, const ImageBuf& src) { return ddt::fill(dst, src); }},
    {"a move",
     [](ImageBuf& dst, const ImageBuf& src) {
         return ddt::warp(dst, src, Imath::M33f(1, 0, 0, 0, 1, 0, 2, -1, 1));
     }},
    {"a turn",
     [](ImageBuf& dst, const ImageBuf& src) {
         return ddt::warp(dst, src, Imath::M33f(0.8f, 0.6f, 0, -0.6f, 0.8f, 0, 0, 0, 1), filling());
     }},
    {"a shrinking turn",
     [](ImageBuf& dst, const ImageBuf& src) {
         return ddt::warp(dst, src, Imath::M33f(0.4f, 0.3f, 0, -0.3f, 0.4f, 0, 0, 0, 1), filling());
     }},
};

TEST(Strides, AnImageMayBeMadeOfItself) {
    for (const bool holed : {false, true})
        for (const Way& way : ways) {
            SCOPED_TRACE(way.name);
            const ImageBuf dense = noise(holed);
            ImageBuf expected = dense;
            ASSERT_TRUE(way.make(expected, expected)) << expected.geterror();
            std::vector<float> memory;
            ImageBuf image = with_room(dense, memory);
            ASSERT_TRUE(way.make(image, image)) << image.geterror();
            EXPECT_EQ(bytes(image), bytes(expected));
        }
}

TEST(Strides, FillingTakesThePixelsAlone) {
    const ImageBuf dense = noise(true);
    std::vector<float> memory;
    const ImageBuf src = with_room(dense, memory);
    for (const Way& way : ways) {
        ImageBuf expected, dst;
        ASSERT_TRUE(way.make(expected, dense)) << way.name << expected.geterror();
        ASSERT_TRUE(way.make(dst, src)) << way.name << dst.geterror();
        EXPECT_EQ(bytes(dst), bytes(expected)) << way.name;
    }
    for (const auto& [w, h] : {std::pair{columns, rows}, {6, 33}, {40, 5}, {9, 7}, {28, 22}}) {
        ImageBuf expected = images::make(w, h, numbers), dst = images::make(w, h, numbers);
        ASSERT_TRUE(ddt::resize(expected, dense, filling())) << expected.geterror();
        ASSERT_TRUE(ddt::resize(dst, src, filling())) << dst.geterror();
        EXPECT_EQ(bytes(dst), bytes(expected)) << w << " x " << h;
    }
}

} // namespace
