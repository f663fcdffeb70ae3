// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/compression.h"

#include <gtest/gtest.h>

namespace ddt::tool {
namespace {

bool allowed(const char* given, const char* format) {
    std::string error;
    const bool is = check_compression(given, format, error);
    EXPECT_EQ(is, error.empty()) << error;
    return is;
}

TEST(Compression, IsOneOfTheFormats) {
    EXPECT_TRUE(allowed("none", "openexr"));
    EXPECT_TRUE(allowed("piz", "openexr"));
    EXPECT_FALSE(allowed("lzw", "openexr"));
    EXPECT_TRUE(allowed("lzw", "tiff"));
    EXPECT_FALSE(allowed("piz", "tiff"));
    EXPECT_FALSE(allowed("", "tiff"));
    EXPECT_FALSE(allowed("zippy", "openexr"));
    EXPECT_FALSE(allowed("zip", "png"));
    EXPECT_TRUE(allowed("rle", "png"));
    EXPECT_TRUE(allowed("none", "targa"));
    EXPECT_TRUE(allowed("lossless", "webp"));
}

TEST(Compression, MayBeOfAnyFormatWhereThatIsNotKnown) {
    EXPECT_TRUE(allowed("lzw", ""));
    EXPECT_TRUE(allowed("piz", ""));
    EXPECT_FALSE(allowed("best", ""));
}

TEST(Compression, HasALevelWhereTheFormatHas) {
    EXPECT_TRUE(allowed("dwaa:45", "openexr"));
    EXPECT_TRUE(allowed("zip:9", "tiff"));
    EXPECT_FALSE(allowed("zip:10", "tiff"));
    EXPECT_FALSE(allowed("zip:0", "openexr"));
    EXPECT_FALSE(allowed("piz:3", "openexr"));
    EXPECT_TRUE(allowed("jpeg:85", "jpeg"));
    EXPECT_TRUE(allowed("webp:50", "webp"));
    for (const char* no_level : {"zip:", "zip:x", "zip:3x", "zip:-1", "zip: 3", "zip:3:4"})
        EXPECT_FALSE(allowed(no_level, "openexr")) << no_level;
}

TEST(Compression, SaysWhatIsAllowed) {
    std::string error;
    EXPECT_FALSE(check_compression("dwaa", "tiff", error));
    EXPECT_EQ(error, "compression \"dwaa\" is not allowed in tiff; allowed are none, lzw, "
                     "zip[:1-9], packbits, jpeg[:1-100]");
    EXPECT_FALSE(check_compression("dwaa:0", "openexr", error));
    EXPECT_NE(error.find(" piz, pxr24, b44, b44a, dwaa[:1-100000], dwab["), std::string::npos)
        << error;
    // Once, where several formats have it.
    EXPECT_FALSE(check_compression("best", "", error));
    EXPECT_EQ(error.find("zip[:1-9]"), error.rfind("zip[:1-9]")) << error;
    EXPECT_FALSE(check_compression("zip", "sgi", error));
    EXPECT_EQ(error, "no compression can be chosen for files of the format sgi");
}

} // namespace
} // namespace ddt::tool
