// SPDX-License-Identifier: Apache-2.0
#include "plugin/openfx/windows.h"

#include <cmath>

#include <gtest/gtest.h>

#include "plugin/host/buffer.h"

namespace ddt::ofx {
namespace {

/// Region and render scale by which a proxy has half a pixel more than it stands for.
TEST(OpenFxWindows, AProxyIsEnlargedAsMuch) {
    const RectD region{0, 0, 101, 103};
    for (const bool by_width : {false, true}) {
        Settings settings;
        settings.width = by_width ? 202 : 0;
        const Windows windows = windows_of(region, {0.5, 0.5}, {1, 1}, settings, false);
        const host::Placing& place = windows.place;
        EXPECT_EQ(place.window, (Rect{0, -52, 51, 0}));
        const Rect rounded_down{0, -51, 50, 0};
        EXPECT_EQ(windows.window_of(rounded_down), rounded_down);
        EXPECT_EQ(place.full, (Rect{0, -103, 101, 0}));
        EXPECT_EQ(place.to.width(), 2 * place.from.width());
        EXPECT_EQ(place.to.height(), 2 * place.from.height());
        EXPECT_EQ(place.from.x0, 0);
        EXPECT_EQ(place.to.x0, 0);
    }
}

/// In each of a side's two ways; and what is no such rounding, or next to nothing.
TEST(OpenFxWindows, AnImageSaysHowItsSidesWereRounded) {
    const Windows windows = windows_of({-3, -5, 101, 81.01}, {0.5, 0.5}, {1, 1}, {}, false);
    const Rect window{-2, -41, 51, 3};
    EXPECT_EQ(windows.place.window, window);
    for (const int x0 : {-3, -2, -1, 0})
        for (const int y0 : {-42, -41, -40, -39})
            for (const int x1 : {49, 50, 51, 52})
                for (const int y1 : {1, 2, 3, 4}) {
                    const Rect said{x0, y0, x1, y1};
                    const bool rounded = (x0 == -2 || x0 == -1) && (y0 == -41 || y0 == -40) &&
                                         (x1 == 50 || x1 == 51) && (y1 == 2 || y1 == 3);
                    EXPECT_EQ(windows.window_of(said), rounded ? said : window)
                        << x0 << " " << y0 << " " << x1 << " " << y1;
                }
    const Windows whole = windows_of({0, -0.005, 100, 80.5}, {1, 1}, {1, 1}, {}, false);
    EXPECT_EQ(whole.place.window, (Rect{0, -81, 100, 0}));
    EXPECT_EQ(whole.window_of({0, -80, 100, 1}), (Rect{0, -80, 100, 0}));
    EXPECT_EQ(whole.window_of({0, -80, 99, 0}), whole.place.window);
    const Windows small = windows_of({0, 0, 1, 1}, {0.5, 0.5}, {1, 1}, {}, false);
    EXPECT_EQ(small.window_of({0, 0, 0, 0}), (Rect{0, -1, 1, 0}));
}

/// Its tiles lie a pixel lower, or further to the right.
TEST(OpenFxWindows, WhatAProxyNeedsThatIsRoundedOtherwiseIsAskedFor) {
    const Windows windows = windows_of({-3, -5, 2801, 2801}, {0.5, 0.5}, {1, 1}, {}, false);
    int others = 0;
    for (const int x0 : {-2, -1})
        for (const int y0 : {-1401, -1400})
            for (const int x1 : {1400, 1401})
                for (const int y1 : {2, 3}) {
                    host::Placing there = windows.place;
                    there.window = {x0, y0, x1, y1};
                    ASSERT_EQ(windows.window_of(there.window), there.window);
                    for (int at = -2801; at < 0; at += 50) {
                        const Rect part{-at - 60, at, -at - 40, at + 50};
                        const Rect wanted = host::needed(there, part);
                        EXPECT_TRUE(windows.needed(part, Holes::keep).contains(wanted)) << at;
                        others += !host::needed(windows.place, part).contains(wanted);
                    }
                }
    EXPECT_GT(others, 0);
}

/// As Natron finds the pixels that a canonical region touches.
Rect pixels_of_host(const RectD& r, double scale, double aspect) {
    return host::flipped({int(std::floor(r.x1 * scale / aspect)), int(std::floor(r.y1 * scale)),
                          int(std::ceil(r.x2 * scale / aspect)), int(std::ceil(r.y2 * scale))});
}

/// It would be black in what the host asks for beyond the result.
TEST(OpenFxWindows, HostsFindThePixelsOfTheResultAndNoOthers) {
    for (const double aspect : {0.91, 1.0, 1.09, 1.21, 1.333, 4.0 / 3, 1.42, 1.46, 2.0})
        for (const double factor : {1.5, 2.0, 2.5, 3.0, 3.3, 5.0})
            for (const int width : {720, 719, 1440, 1920, 37})
                for (const int x0 : {0, -3, 17}) {
                    const RectD region{x0 * aspect, -2, (x0 + width) * aspect, 574};
                    const PixelScale at_full{1 / aspect, 1};
                    Settings settings;
                    settings.scale_x = settings.scale_y = factor;
                    const Rect full =
                        windows_of(region, at_full, at_full, settings, false).place.full;
                    const RectD defined = to_region(full, at_full);
                    for (const double scale :
                         {1.0, 0.5, 0.25, 0.125, 1.0 / 3, 0.7, 0.123, 0.871, 0.999}) {
                        const PixelScale here{scale * at_full.x, scale * at_full.y};
                        const Rect rendered =
                            windows_of(region, here, at_full, settings, false).place.full;
                        ASSERT_EQ(pixels_of_host(defined, scale, aspect), rendered)
                            << aspect << " " << factor << " " << width << " " << x0 << " " << scale;
                    }
                }
}

/// Of a picture that ends within pixels, in a host of one resolution.
TEST(OpenFxWindows, AZoomIsAllThatItsHostRenders) {
    Settings settings;
    for (const double x0 : {0.0, 1.5, -2.7, 0.002, 0.995})
        for (const double x1 : {101.0, 100.5, 100.015, 100.008, 101.3})
            for (const double scale : {1.0, 0.75, 0.5, 1.0 / 3, 0.123, 0.999}) {
                const RectD region{x0, x0, x1, x1};
                const Rect full = windows_of(region, {1, 1}, {1, 1}, settings, true).place.full;
                const host::Placing here =
                    windows_of(region, {scale, scale}, {1, 1}, settings, true).place;
                ASSERT_EQ(pixels_of_host(to_region(full, {1, 1}), scale, 1), here.full)
                    << x0 << " " << x1 << " " << scale;
                ASSERT_TRUE(here.full.contains(here.window)) << x0 << " " << x1 << " " << scale;
            }
    const host::Placing place =
        windows_of({1.5, 0, 101, 80}, {0.75, 0.75}, {1, 1}, settings, true).place;
    EXPECT_EQ(place.window, (Rect{1, -60, 76, 0}));
    EXPECT_EQ(place.full, (Rect{0, -60, 76, 0}));
}

} // namespace
} // namespace ddt::ofx
