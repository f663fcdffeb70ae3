// SPDX-License-Identifier: Apache-2.0
// Windows, against the obvious: a plane is reproduced wherever the mesh is read, so an output pixel
// tells which position it shows.
#include "plugin/image/windows.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/plugin/images.h"

namespace {

using images::make;
using images::value;
using images::window;
using OIIO::ImageBuf;
using OIIO::ROI;

constexpr double slope_x = 0.5, slope_y = 0.25;

ImageBuf plane(ROI data, ROI full) {
    auto image = make(data, full, 1);
    images::fill(image, [](int x, int y, int) { return float(slope_x * x + slope_y * y); });
    return image;
}

double shown(int i, int to0, int to_size, int from0, int from_size, int first, int last) {
    const double p = from0 + (i + 0.5 - to0) * from_size / to_size - 0.5;
    return std::clamp(p, double(first), double(last));
}

void expect_plane(const ImageBuf& dst, const ImageBuf& src) {
    const ROI to = dst.roi_full(), from = src.roi_full(), data = src.roi();
    for (int y = dst.ybegin(); y < dst.yend(); ++y)
        for (int x = dst.xbegin(); x < dst.xend(); ++x) {
            const double px = shown(x, to.xbegin, to.width(), from.xbegin, from.width(),
                                    data.xbegin, data.xend - 1);
            const double py = shown(y, to.ybegin, to.height(), from.ybegin, from.height(),
                                    data.ybegin, data.yend - 1);
            ASSERT_NEAR(value(dst, x, y), slope_x * px + slope_y * py, 3e-5) << x << " " << y;
        }
}

TEST(Windows, AnyOffsetsSizesAndFactors) {
    std::mt19937 random(7);
    const auto pick = [&](int low, int high) {
        return low + int(random() % unsigned(high - low + 1));
    };
    for (int i = 0; i < 150; ++i) {
        const int w = pick(1, 20), h = pick(1, 20), fx = pick(-30, 30), fy = pick(-30, 30);
        const int x = fx + pick(-5, 5), y = fy + pick(-5, 5);
        const auto src =
            plane(window(x, x + pick(1, 25), y, y + pick(1, 25)), window(fx, fx + w, fy, fy + h));
        const int tw = w + pick(0, 50), th = h + pick(0, 50), tx = pick(-30, 30),
                  ty = pick(-30, 30);
        const int ox = tx + pick(-8, 8), oy = ty + pick(-8, 8);
        auto dst = make(window(ox, ox + pick(1, 60), oy, oy + pick(1, 60)),
                        window(tx, tx + tw, ty, ty + th), 1);
        ASSERT_TRUE(ddt::resize(dst, src)) << dst.geterror();
        expect_plane(dst, src);
    }
}

TEST(Windows, OnePixelWideOrHigh) {
    for (const auto& [w, h] : {std::pair(1, 1), std::pair(1, 9), std::pair(9, 1)}) {
        const auto src = plane(window(3, 3 + w, 5, 5 + h), window(3, 3 + w, 5, 5 + h));
        auto dst = make(window(0, 4 * w, 0, 7 * h), window(0, 4 * w, 0, 7 * h), 1);
        ASSERT_TRUE(ddt::resize(dst, src)) << dst.geterror();
        expect_plane(dst, src);
    }
}

TEST(Windows, NewDestinationTakesTheRoi) {
    const auto src = plane(window(0, 8, 0, 8), window(0, 8, 0, 8));
    ImageBuf dst;
    ASSERT_TRUE(ddt::resize(dst, src, {}, window(-4, 20, 3, 30)));
    EXPECT_EQ(dst.roi(), ROI(-4, 20, 3, 30, 0, 1, 0, 1));
    EXPECT_EQ(dst.roi_full(), ROI(-4, 20, 3, 30, 0, 1, 0, 1));
    expect_plane(dst, src);
}

TEST(Windows, RoiIsACropOfTheWhole) {
    auto src = make(window(-3, 60, 2, 50), window(0, 50, 0, 60), 3);
    images::noise(src);
    const ROI full = window(5, 205, -7, 233);
    auto whole = make(full, full, 3);
    ASSERT_TRUE(ddt::resize(whole, src));
    for (const ROI part :
         {window(5, 6, -7, -6), window(100, 150, 10, 200), window(180, 205, 0, 5)}) {
        auto dst = make(full, full, 3);
        images::fill(dst, [](int, int, int) { return -9.0f; });
        ASSERT_TRUE(ddt::resize(dst, src, {}, part));
        EXPECT_EQ(images::bytes(dst, part), images::bytes(whole, part));
        for (int y = -7; y < 233; ++y)
            for (int x = 5; x < 205; ++x)
                ASSERT_TRUE(part.contains(x, y) || value(dst, x, y) == -9.0f) << x << " " << y;
    }
}

TEST(Windows, RoiBeyondTheDestinationWritesNothing) {
    const auto src = plane(window(0, 8, 0, 8), window(0, 8, 0, 8));
    auto dst = make(16, 16, 1);
    EXPECT_TRUE(ddt::resize(dst, src, {}, window(100, 120, 0, 16))) << dst.geterror();
    for (int x = 0; x < 16; ++x)
        EXPECT_EQ(value(dst, x, 3), 0.0f);
}

// Fourfold: pixels 10 to 69 of 100 are shown by 40 to 279, and by any that they touch.
TEST(Windows, WhatShowsThePartOfASourceThatIsThere) {
    const auto part = make(window(10, 70, 5, 45), window(0, 100, 0, 80), 1);
    const auto cut = [&](int width, int height) {
        return ddt::cut_to_data(part.spec(), make(width, height, 1).spec(),
                                window(0, width, 0, height));
    };
    EXPECT_EQ(cut(400, 320), window(40, 280, 20, 180));
    EXPECT_EQ(cut(105, 160), window(10, 74, 10, 90)); // 10.5 to 73.5
    EXPECT_EQ(cut(400, 40), window(40, 280, 0, 40));  // an axis that shrinks
    const auto beyond = make(window(-5, 105, 5, 45), window(0, 100, 0, 80), 1);
    const ROI wide = window(-50, 500, 0, 320);
    EXPECT_EQ(ddt::cut_to_data(beyond.spec(), make(400, 320, 1).spec(), wide),
              window(-50, 500, 20, 180));
    // All of it before the display window: 10.5 pixels before, and the pixel that holds them.
    const auto before = make(window(-40, -10, 5, 45), window(0, 100, 0, 80), 1);
    EXPECT_EQ(ddt::cut_to_data(before.spec(), make(105, 320, 1).spec(), wide),
              window(-50, -10, 20, 180));
}

} // namespace
