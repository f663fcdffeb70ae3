// SPDX-License-Identifier: Apache-2.0
#include "plugin/openfx/windows.h"

#include <gtest/gtest.h>

namespace ddt::ofx {
namespace {

/// Region and render scale by which a proxy has half a pixel more than it stands for.
TEST(OpenFxWindows, AProxyIsEnlargedAsMuch) {
    const RectD region{0, 0, 101, 103};
    for (const bool by_width : {false, true}) {
        Settings settings;
        settings.width = by_width ? 202 : 0;
        const host::Placing place = windows_of(region, {0.5, 0.5}, {1, 1}, settings, false).place;
        EXPECT_EQ(place.window, (Rect{0, -52, 51, 0}));
        EXPECT_EQ(place.full, (Rect{0, -103, 101, 0}));
        EXPECT_EQ(place.to.width(), 2 * place.from.width());
        EXPECT_EQ(place.to.height(), 2 * place.from.height());
        EXPECT_EQ(place.from.x0, 0);
        EXPECT_EQ(place.to.x0, 0);
    }
}

} // namespace
} // namespace ddt::ofx
