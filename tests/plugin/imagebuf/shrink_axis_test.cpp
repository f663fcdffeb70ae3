// SPDX-License-Identifier: Apache-2.0
#include "plugin/imagebuf/shrink_axis.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/plugin/images.h"

namespace {

using images::bytes;
using images::make;
using images::value;
using images::window;
using OIIO::ImageBuf;
using OIIO::ROI;

ROI turned(bool turn, int x0, int x1, int y0, int y1) {
    return turn ? window(y0, y1, x0, x1) : window(x0, x1, y0, y1);
}

TEST(ShrinkAxis, IsOpenImageIOsFilterUpToRounding) {
    for (const bool along_x : {true, false})
        for (const int size : {1, 7, 20, 39})
            for (const int channels : {1, 2, 3, 4, 5, 9}) {
                SCOPED_TRACE(::testing::Message() << along_x << ' ' << size << ' ' << channels);
                // Pixels that end within the display window, and beyond it.
                auto src =
                    make(turned(!along_x, -5, 34, 2, 30), turned(!along_x, 0, 40, 2, 30), channels);
                images::noise(src);
                const ROI full = turned(!along_x, 3, 3 + size, 2, 30);
                auto dst = make(full, full, channels), expected = make(full, full, channels);
                ddt::shrink_axis(dst, src, along_x, dst.roi(), 2);
                ASSERT_TRUE(OIIO::ImageBufAlgo::resize(expected, src, "", 0.0f));
                for (int y = full.ybegin; y < full.yend; ++y)
                    for (int x = full.xbegin; x < full.xend; ++x)
                        for (int c = 0; c < channels; ++c)
                            ASSERT_NEAR(value(dst, x, y, c), value(expected, x, y, c), 2e-5f)
                                << x << ' ' << y << ' ' << c;
            }
}

TEST(ShrinkAxis, WritesTheChannelsAskedForInEveryType) {
    auto src = make(40, 10, 6);
    images::noise(src);
    for (const auto base : {OIIO::TypeDesc::UINT8, OIIO::TypeDesc::UINT16, OIIO::TypeDesc::INT16,
                            OIIO::TypeDesc::HALF, OIIO::TypeDesc::FLOAT, OIIO::TypeDesc::DOUBLE}) {
        const OIIO::TypeDesc type(base);
        auto dst = make(15, 10, 6, type), expected = make(15, 10, 6);
        ROI part = window(2, 14, 1, 9);
        part.chbegin = 2, part.chend = 5;
        ddt::shrink_axis(dst, src, true, part, 1);
        ASSERT_TRUE(OIIO::ImageBufAlgo::resize(expected, src, "", 0.0f));
        for (int y = 0; y < 10; ++y)
            for (int x = 0; x < 15; ++x)
                for (int c = 0; c < 6; ++c) {
                    const bool in = part.contains(x, y, 0, c);
                    const float should = in ? std::clamp(value(expected, x, y, c), 0.0f, 1.0f) : 0;
                    const float is = std::clamp(value(dst, x, y, c), 0.0f, 1.0f);
                    ASSERT_NEAR(is, should, 0.51f / 255)
                        << type.c_str() << ' ' << x << ' ' << y << ' ' << c;
                }
    }
}

TEST(ShrinkAxis, LinesAreApart) {
    for (const bool along_x : {true, false}) {
        auto src = make(20, 20, 1);
        images::noise(src);
        const float infinite = std::numeric_limits<float>::infinity();
        src.setpixel(10, 10, &infinite);
        auto dst = make(along_x ? 7 : 20, along_x ? 20 : 7, 1);
        ddt::shrink_axis(dst, src, along_x, dst.roi(), 1);
        for (int y = 0; y < dst.spec().height; ++y)
            for (int x = 0; x < dst.spec().width; ++x)
                if ((along_x ? y : x) != 10) {
                    ASSERT_TRUE(std::isfinite(value(dst, x, y))) << x << ' ' << y;
                }
    }
}

TEST(ShrinkAxis, IsTheSameWhereverTheWindowsLie) {
    for (const bool along_x : {true, false}) {
        ImageBuf near_origin;
        for (const int far : {0, 1 << 25}) {
            const ROI from = turned(!along_x, far, far + 36, 0, 20);
            const ROI to = turned(!along_x, far, far + 12, 0, 20);
            auto src = make(from, from, 1), dst = make(to, to, 1);
            images::noise(src);
            ddt::shrink_axis(dst, src, along_x, dst.roi(), 3);
            if (far)
                EXPECT_EQ(bytes(dst), bytes(near_origin));
            else
                near_origin = dst;
        }
    }
}

} // namespace
