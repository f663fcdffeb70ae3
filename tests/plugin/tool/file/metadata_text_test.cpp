// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/metadata_text.h"

#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <OpenImageIO/imageio.h>

namespace ddt::tool {
namespace {

using OIIO::TypeDesc;

/// The same types, and the same bytes, of texts the same texts.
void expect_same(const OIIO::ParamValueList& a, const OIIO::ParamValueList& b) {
    ASSERT_EQ(a.size(), b.size());
    for (int i = 0; i < int(a.size()); ++i) {
        EXPECT_EQ(a[i].name(), b[i].name());
        EXPECT_EQ(a[i].type(), b[i].type()) << a[i].name();
        EXPECT_EQ(a[i].type().vecsemantics, b[i].type().vecsemantics) << a[i].name();
        ASSERT_EQ(a[i].datasize(), b[i].datasize()) << a[i].name();
        // Texts are pointers, equal where the texts are.
        EXPECT_EQ(std::memcmp(a[i].data(), b[i].data(), size_t(a[i].datasize())), 0) << a[i].name();
    }
}

TEST(MetadataText, GivesWhatItWasMadeOf) {
    OIIO::ImageSpec spec;
    spec.attribute("oiio:BitsPerSample", 10);
    spec.attribute("jpeg:subsampling", "4:2:0");
    spec.attribute("empty", "");
    spec.attribute("two lines, \"quoted\"", "a\nb \xc3\xa9");
    spec.attribute("PixelAspectRatio", 0.1f);
    const double large = 1e300;
    spec.attribute("large", TypeDesc::DOUBLE, &large);
    const float matrix[16] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
    spec.attribute("worldToCamera", OIIO::TypeMatrix, matrix);
    const int code[2] = {0x01234567, -5}, ratio[2] = {24000, 1001};
    spec.attribute("smpte:TimeCode", OIIO::TypeTimeCode, code);
    spec.attribute("FramesPerSecond", OIIO::TypeRational, ratio);
    const float whites[3] = {0.5f, -0.f, 65504};
    spec.attribute("white", OIIO::TypeColor, whites);
    const std::vector<unsigned char> profile(3000, 0xa5);
    spec.attribute("ICCProfile", TypeDesc(TypeDesc::UINT8, int(profile.size())), profile.data());
    const char* const views[] = {"left", "", "right"};
    spec.attribute("multiView", TypeDesc(TypeDesc::STRING, 3), views);

    OIIO::ParamValueList back;
    ASSERT_TRUE(metadata_of(text_of(spec.extra_attribs), back));
    expect_same(spec.extra_attribs, back);
}

TEST(MetadataText, OfNothingIsEmpty) {
    OIIO::ParamValueList back;
    EXPECT_EQ(text_of(back), "");
    back.attribute("a", 1);
    EXPECT_TRUE(metadata_of("", back));
    EXPECT_TRUE(back.empty());
}

TEST(MetadataText, PointersAreLeftOut) {
    OIIO::ParamValueList list;
    void* const pointer = &list;
    list.attribute("pointer", OIIO::TypePointer, &pointer);
    EXPECT_EQ(text_of(list), "");
}

TEST(MetadataText, OthersAreRefused) {
    OIIO::ParamValueList list;
    // Name "a", an int of 1: the one that is right.
    ASSERT_TRUE(metadata_of("61 7 1 0 0 1 01000000\n", list));
    EXPECT_EQ(list.get_int("a"), 1);
    for (const char* wrong : {
             "61",
             "61 7 1 0 0 1",
             "61 7 1 0 0 1 ",
             " 7 1 0 0 1 01000000",      // too few
             "61 7 1 0 0 1 01000000 00", // too many
             "6 7 1 0 0 1 01000000",
             "6g 7 1 0 0 1 01000000", // no bytes
             "61 7 1 0 0 1 0100000",
             "61 7 1 0 0 1 010000",
             "61 7 1 0 0 1 0100000000",
             "61 0 1 0 0 1 01000000",
             "61 14 1 0 0 1 0100000000000000", // types that are none
             "61 7 5 0 0 1 01000000",
             "61 7 1 99 0 1 01000000",
             "61 7 1 0 -1 1 01000000",
             "61 7 1 0 0 0 01000000",
             "61 7 1 0 0 2147483647 01000000",
             "61 7 16 0 2147483647 2147483647 01000000", // as many as memory has not
             "61 13 1 0 0 1 78",
             "61 13 1 0 0 2 7800", // texts that do not end, or too few
             "61 13 1 0 0 1 78007900",
             "61 13 1 0 0 1 7800\nx",
         }) {
        list.attribute("left", 1);
        EXPECT_FALSE(metadata_of(wrong, list)) << wrong;
        EXPECT_TRUE(list.empty()) << wrong;
    }
}

} // namespace
} // namespace ddt::tool
