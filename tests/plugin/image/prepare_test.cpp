// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/prepare.h"

#include "tests/plugin/images.h"

namespace {

using images::make;
using OIIO::ImageBuf;
using OIIO::ROI;

TEST(Prepare, WindowsOfADestinationAreChecked) {
    const auto src = make(10, 10, 1);
    auto dst = make(40, 40, 1);
    dst.specmod().x = dst.specmod().full_x = 2147483600;
    EXPECT_FALSE(ddt::resize(dst, src));
    EXPECT_NE(dst.geterror().find("the destination's data window"), std::string::npos);
}

// Flat images may lie at any z.
TEST(Prepare, AnyZ) {
    auto src = make(10, 10, 1);
    images::noise(src);
    const auto wanted = images::enlarged(src, 40, 40);
    auto moved = src;
    moved.specmod().z = moved.specmod().full_z = 3;
    ImageBuf dst;
    ASSERT_TRUE(ddt::resize(dst, moved, {}, ROI(0, 40, 0, 40, 5, 6))) << dst.geterror();
    EXPECT_EQ(dst.spec().z, 5);
    EXPECT_EQ(images::bytes(dst), images::bytes(wanted));
    auto given = make(40, 40, 1);
    given.specmod().z = given.specmod().full_z = 2;
    ASSERT_TRUE(ddt::resize(given, src)) << given.geterror();
    ASSERT_TRUE(ddt::resize(given, src, {}, ROI(0, 40, 0, 40, 0, 1))); // misses it
}

} // namespace
