// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/sink.h"

#include <cstring>

#include <gtest/gtest.h>

namespace ddt::test {
namespace {

OIIO::ImageBuf image_of(OIIO::TypeDesc type, int channels) {
    return OIIO::ImageBuf(OIIO::ImageSpec(6, 5, channels, type));
}

Writing all_of(int channels) {
    Writing writing;
    writing.channels = writing.chend = channels;
    return writing;
}

TEST(ImageSink, PlacesInFloatsWithoutGapsOnly) {
    const Rect part{2, 1, 5, 4};
    size_t row = 0;
    OIIO::ImageBuf floats = image_of(OIIO::TypeFloat, 3);
    const Writing all = all_of(3);
    EXPECT_EQ(ImageSink(floats, all).place(part, row), floats.pixeladdr(2, 1));
    EXPECT_EQ(row, 6u * 3);
    // Numbers of as many bytes, and others.
    for (const OIIO::TypeDesc& type : {OIIO::TypeUInt32, OIIO::TypeInt32, OIIO::TypeHalf,
                                       OIIO::TypeDesc(OIIO::TypeDesc::DOUBLE)}) {
        OIIO::ImageBuf others = image_of(type, 3);
        EXPECT_EQ(ImageSink(others, all).place(part, row), nullptr) << type;
    }
    // Some of its channels, and bits of something else.
    Writing some = all_of(2);
    EXPECT_EQ(ImageSink(floats, some).place(part, row), nullptr);
    some = all_of(3);
    some.bits = OIIO::TypeUInt32;
    EXPECT_EQ(ImageSink(floats, some).place(part, row), nullptr);
}

TEST(ImageSink, TakesHalfsIntoHalfsThatStayAsTheyAre) {
    Writing all = all_of(3);
    all.chbegin = 1;
    all.chend = 4;
    OIIO::ImageBuf halfs = image_of(OIIO::TypeHalf, 5), floats = image_of(OIIO::TypeFloat, 5);
    ImageSink sink(halfs, all);
    EXPECT_TRUE(sink.takes_halfs());
    EXPECT_FALSE(ImageSink(floats, all).takes_halfs());
    all.channels = 4; // one that is only needed on the way back from linear light
    EXPECT_FALSE(sink.takes_halfs());
    all.channels = 3;
    all.bits = OIIO::TypeUInt32;
    EXPECT_FALSE(sink.takes_halfs());
    all.bits = OIIO::TypeUnknown;

    const uint16_t values[6] = {0x3c00, 0x3800, 0x3400, 0xbc00, 0x7c00, 0x0001};
    ASSERT_TRUE(sink.write_packed({2, 1, 4, 2}, values));
    for (int x = 2; x < 4; ++x)
        EXPECT_EQ(std::memcmp(halfs.pixeladdr(x, 1, 0, 1), values + 3 * (x - 2), 6), 0) << x;
    for (const int c : {0, 4})
        EXPECT_EQ(halfs.getchannel(2, 1, 0, c), 0.0f);
    EXPECT_EQ(halfs.getchannel(1, 1, 0, 1), 0.0f);
    EXPECT_EQ(halfs.getchannel(4, 1, 0, 1), 0.0f);
}

TEST(ImageSink, WritesNumbersOfAnyType) {
    const Rect part{2, 1, 4, 2};
    std::vector<float> values = {0.0f, 0.25f, 1.0f, 0.5f, 0.75f, 1.0f};
    for (const OIIO::TypeDesc& type :
         {OIIO::TypeFloat, OIIO::TypeHalf, OIIO::TypeUInt32, OIIO::TypeUInt16, OIIO::TypeUInt8}) {
        OIIO::ImageBuf image = image_of(type, 3);
        const Writing all = all_of(3);
        ASSERT_TRUE(ImageSink(image, all).write(part, values.data()));
        for (int x = 2; x < 4; ++x)
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(image.getchannel(x, 1, 0, c), values[size_t(3 * (x - 2) + c)],
                            1.0 / 255)
                    << type << ' ' << x << ' ' << c;
        EXPECT_EQ(image.getchannel(1, 1, 0, 0), 0.0f) << type;
        EXPECT_EQ(image.getchannel(4, 1, 0, 0), 0.0f) << type;
    }
}

} // namespace
} // namespace ddt::test
