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
        EXPECT_EQ(windows.least, (Rect{0, -51, 50, 0}));
        EXPECT_EQ(place.full, (Rect{0, -103, 101, 0}));
        EXPECT_EQ(place.to.width(), 2 * place.from.width());
        EXPECT_EQ(place.to.height(), 2 * place.from.height());
        EXPECT_EQ(place.from.x0, 0);
        EXPECT_EQ(place.to.x0, 0);
    }
}

/// Whose tiles lie a pixel lower.
TEST(OpenFxWindows, WhatAProxyThatIsRoundedDownNeedsIsAskedFor) {
    const Windows windows = windows_of({0, 0, 601, 2801}, {0.5, 0.5}, {1, 1}, {}, false);
    EXPECT_EQ(windows.window_of({0, -1400, 300, 0}), windows.least);
    host::Placing rounded_down = windows.place;
    rounded_down.window = windows.least;
    int others = 0;
    for (int y = -2801; y < 0; y += 50) {
        const Rect part{20, y, 40, y + 50};
        const Rect wanted = host::needed(rounded_down, part);
        const Rect asked = windows.needed(part, Holes::keep);
        EXPECT_EQ(intersection(asked, wanted), wanted) << y;
        const Rect usual = host::needed(windows.place, part);
        EXPECT_EQ(intersection(asked, usual), usual) << y;
        others += !(intersection(usual, wanted) == wanted);
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
