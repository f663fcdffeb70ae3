// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "plugin/tool/resize/plan_result.h"

namespace ddt::tool {
namespace {

using OIIO::ImageSpec;

TEST(PlanResult, TheNumbersOfWhatIsTooLargeAreRight) {
    ImageSpec from(3000, 3, 1, OIIO::TypeHalf), to;
    from.full_width = from.full_height = 1;
    ResizeSettings settings;
    settings.size = "1000000x1000000";
    Failure failure;
    EXPECT_FALSE(plan_result(from, settings, to, failure));
    EXPECT_EQ(failure.code, exit_failed);
    EXPECT_NE(failure.why.find("3000000000 x 3000000 pixels"), std::string::npos) << failure.why;
    from.x = -1000;
    settings.size = "1000x1000";
    ASSERT_TRUE(plan_result(from, settings, to, failure)) << failure.why;
    EXPECT_EQ(to.x, -1000000);
    EXPECT_EQ(to.width, 3000000);
    from.x = -1000000;
    EXPECT_FALSE(plan_result(from, settings, to, failure));
}

TEST(PlanResult, ATypeThatIsAskedForHasAllItsBits) {
    ImageSpec from(8, 8, 1, OIIO::TypeUInt16), to;
    from.attribute("oiio:BitsPerSample", 10);
    ResizeSettings settings;
    settings.size = "200%";
    Failure failure;
    ASSERT_TRUE(plan_result(from, settings, to, failure));
    EXPECT_EQ(to.get_int_attribute("oiio:BitsPerSample"), 10);
    settings.type = "uint16";
    ASSERT_TRUE(plan_result(from, settings, to, failure));
    EXPECT_EQ(to.get_int_attribute("oiio:BitsPerSample"), 0);
}

TEST(PlanResult, DataWindowsScaleWithoutRounding) {
    ResizeSettings settings;
    Failure failure;
    for (int height = 1; height < 2000; height += 7)
        for (const int percent : {101, 110, 120, 137, 150, 333, 400}) {
            ImageSpec from(16, height, 1, OIIO::TypeHalf), to;
            settings.size = std::to_string(percent) + "%";
            ASSERT_TRUE(plan_result(from, settings, to, failure)) << failure.why;
            ASSERT_EQ(to.height, to.full_height) << height << ' ' << percent;
            from.y = -height;
            from.height = 3 * height;
            ASSERT_TRUE(plan_result(from, settings, to, failure)) << failure.why;
            ASSERT_EQ(to.y, -to.full_height) << height << ' ' << percent;
            ASSERT_EQ(to.height, 3 * to.full_height) << height << ' ' << percent;
        }
}

TEST(PlanResult, DataWindowsBeginRoundedDownAndHaveSizesRoundedUp) {
    ImageSpec from(301, 19, 1, OIIO::TypeHalf), to;
    from.x = -7;
    from.y = 5;
    from.full_x = -3;
    from.full_width = 290;
    from.full_height = 30;
    ResizeSettings settings;
    settings.size = "130%";
    Failure failure;
    ASSERT_TRUE(plan_result(from, settings, to, failure)) << failure.why;
    EXPECT_EQ(to.roi_full(), OIIO::ROI(-3, 374, 0, 39, 0, 1, 0, 1));
    // 5.2 left of the display window's edge, 391.3 wide; 6.5 below it, 24.7 high.
    EXPECT_EQ(to.roi(), OIIO::ROI(-9, 383, 6, 31, 0, 1, 0, 1));
}

TEST(PlanResult, WhatIsSaidOfTheSourcesPixelsGoesAndTheLevelOfCompressionStays) {
    ImageSpec from(8, 8, 1, OIIO::TypeHalf), to;
    from.attribute("oiio:AverageColor", "0.5");
    from.attribute("textureformat", "Plain Texture");
    from.attribute("Exif:PixelXDimension", 8);
    from.attribute("Exif:PixelYDimension", 8);
    from.attribute("compression", "dwab");
    from.attribute("openexr:dwaCompressionLevel", 120.0f);
    ResizeSettings settings;
    settings.size = "200%x100%";
    Failure failure;
    ASSERT_TRUE(plan_result(from, settings, to, failure));
    EXPECT_EQ(to.find_attribute("Exif:PixelXDimension"), nullptr);
    EXPECT_EQ(to.get_int_attribute("Exif:PixelYDimension"), 8);
    EXPECT_EQ(to.find_attribute("oiio:AverageColor"), nullptr);
    EXPECT_EQ(to.find_attribute("textureformat"), nullptr);
    EXPECT_EQ(to.get_string_attribute("compression"), "dwab:120");
    from.attribute("compression", "dwaa");
    ASSERT_TRUE(plan_result(from, settings, to, failure));
    EXPECT_EQ(to.get_string_attribute("compression"), "dwaa:120");
    from.attribute("compression", "zip"); // which has none of that
    ASSERT_TRUE(plan_result(from, settings, to, failure));
    EXPECT_EQ(to.get_string_attribute("compression"), "zip");
    settings.compression = "dwab:45";
    ASSERT_TRUE(plan_result(from, settings, to, failure));
    EXPECT_EQ(to.get_string_attribute("compression"), "dwab:45");
}

} // namespace
} // namespace ddt::tool
