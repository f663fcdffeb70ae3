// SPDX-License-Identifier: Apache-2.0
// What fails, fails with one line, and leaves nothing half done.
#include <fstream>

#include "tests/environment.h"
#include "tests/plugin/images.h"
#include "tests/resource_limit.h"
#include "tests/temporary.h"

namespace {

using images::make;
using images::value;
using images::window;
using OIIO::ImageBuf;
using OIIO::ImageSpec;
using OIIO::ROI;

void expect_error(ImageBuf& dst, const char* what) {
    ASSERT_TRUE(dst.has_error());
    const std::string error = dst.geterror();
    EXPECT_EQ(error.compare(0, 5, "ddt: "), 0) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    EXPECT_NE(error.find(what), std::string::npos) << error;
}

void expect_failure(const ImageBuf& src, const char* what, ROI roi = window(0, 64, 0, 64),
                    const ddt::Options& options = {}) {
    ImageBuf dst;
    EXPECT_FALSE(ddt::resize(dst, src, options, roi));
    EXPECT_FALSE(dst.initialized());
    expect_error(dst, what);
    ImageBuf warped;
    const float M[3][3] = {{2, 0, 0}, {0, 2, 0}, {0, 0, 1}};
    EXPECT_FALSE(ddt::warp(warped, src, M, options, false, ImageBuf::WrapDefault, roi));
    EXPECT_FALSE(warped.initialized());
    expect_error(warped, what);
}

TEST(Errors, UninitialisedSource) {
    expect_failure(ImageBuf(), "uninitialised");
}

TEST(Errors, ADestinationOfAnotherTypeStaysAsItIs) {
    const auto src = make(8, 8, 1);
    std::vector<uint64_t> memory(16 * 16, 7);
    ImageBuf dst(ImageSpec(16, 16, 1, OIIO::TypeDesc::UINT64), memory.data());
    EXPECT_FALSE(ddt::resize(dst, src));
    expect_error(dst, "the destination's pixels are uint64");
    EXPECT_EQ(memory, std::vector<uint64_t>(16 * 16, 7));
}

TEST(Errors, FileThatIsNotThere) {
    expect_failure(ImageBuf("/nowhere/picture.png"), "/nowhere/picture.png");
}

TEST(Errors, FileThatIsCutShort) {
    const std::string path = ddt::temporary("cut.tif");
    auto whole = make(200, 200, 3, OIIO::TypeUInt8);
    images::noise(whole);
    ASSERT_TRUE(whole.write(path));
    std::ifstream in(path, std::ios::binary);
    std::string content((std::istreambuf_iterator<char>(in)), {});
    std::ofstream(path, std::ios::binary | std::ios::trunc) << content.substr(0, 30000);
    ImageBuf dst;
    EXPECT_FALSE(ddt::resize(dst, ImageBuf(path), {}, window(0, 400, 0, 400)));
    EXPECT_FALSE(dst.initialized());
    expect_error(dst, "TIFF");
    // In memory the pixels that were not read are there, black.
    ImageBuf local(path);
    EXPECT_FALSE(local.read(0, 0, true));
    EXPECT_FALSE(ddt::resize(dst, local, {}, window(0, 400, 0, 400)));
    EXPECT_FALSE(dst.initialized());
    expect_error(dst, "cannot be read");
}

TEST(Errors, WhatIsBetweenIsNoLargerThanAnImageMayBe) {
    const ImageBuf src = make(600, 600, 3, OIIO::TypeHalf); // 2 MB
    ImageBuf high = make(10, 1200, 3), doubles = make(599, 599, 3, OIIO::TypeDesc::DOUBLE);
    int before = 0;
    OIIO::getattribute("limits:imagesize_MB", before);
    OIIO::attribute("limits:imagesize_MB", 3);
    // Enlarged first, that has 600 x 1200 floats; and OpenImageIO's result is of floats.
    EXPECT_FALSE(ddt::resize(high, src));
    expect_error(high, "limits:imagesize_MB");
    EXPECT_FALSE(ddt::resize(doubles, src));
    expect_error(doubles, "limits:imagesize_MB");
    OIIO::attribute("limits:imagesize_MB", before);
    EXPECT_TRUE(ddt::resize(high, src)) << high.geterror();
    EXPECT_TRUE(ddt::resize(doubles, src)) << doubles.geterror();
}

TEST(Errors, DeepImage) {
    ImageSpec spec(8, 8, 3, OIIO::TypeFloat);
    spec.deep = true;
    expect_failure(ImageBuf(spec), "deep");
    const auto src = make(8, 8, 3);
    ImageBuf dst(spec);
    EXPECT_FALSE(ddt::resize(dst, src));
    expect_error(dst, "deep");
}

TEST(Errors, Volume) {
    ImageSpec spec(8, 8, 3, OIIO::TypeFloat);
    spec.depth = spec.full_depth = 4;
    expect_failure(ImageBuf(spec), "volume");
    expect_failure(make(8, 8, 3), "region is of depth 5, [0, 5)", {0, 16, 0, 16, 0, 5});
}

TEST(Errors, EmptyDisplayWindow) {
    auto src = make(8, 8, 3);
    src.specmod().full_width = 0;
    expect_failure(src, "display window");
    src.specmod().full_width = -5;
    expect_failure(src, "display window");
}

TEST(Errors, AbsurdSize) {
    const auto src = make(8, 8, 3);
    expect_failure(src, "2000000 x 2000000", window(0, 2000000, 0, 2000000));
    expect_failure(src, "coordinates", window(0, 2147483647, 0, 1));
    ImageBuf dst;
    const float M[3][3] = {{1e9f, 0, 0}, {0, 1e9f, 0}, {0, 0, 1}};
    EXPECT_FALSE(ddt::warp(dst, src, M, {}, true));
    expect_error(dst, "coordinates");
}

TEST(Errors, ChannelsThatTheImageHasNot) {
    const auto src = make(8, 8, 4);
    for (const auto& [begin, end] : {std::pair(7, 9), {4, 5}, {2, 2}, {3, 1}, {-2, 0}}) {
        ROI roi = window(0, 64, 0, 64);
        roi.chbegin = begin;
        roi.chend = end;
        const std::string range = "[" + std::to_string(begin) + ", " + std::to_string(end) + ")";
        expect_failure(src, (range + " has none of the image's 4; allowed").c_str(), roi);
    }
    // Both images must have them, and one that is there stays as it is.
    ImageBuf dst = make(16, 16, 2);
    images::fill(dst, [](int, int, int) { return 0.5f; });
    ROI roi = dst.roi();
    roi.chbegin = 2;
    roi.chend = 4;
    EXPECT_FALSE(ddt::resize(dst, src, {}, roi));
    expect_error(dst, "none of the image's 2");
    EXPECT_EQ(value(dst, 3, 3, 1), 0.5f);
    // What is beside the pixels writes none.
    EXPECT_TRUE(ddt::resize(dst, src, {}, window(20, 30, 0, 16))) << dst.geterror();
    EXPECT_EQ(value(dst, 3, 3, 1), 0.5f);
    // Some are enough.
    roi.chbegin = 1;
    roi.chend = 9;
    EXPECT_TRUE(ddt::resize(dst, src, {}, roi)) << dst.geterror();
    EXPECT_EQ(value(dst, 3, 3, 0), 0.5f);
    EXPECT_EQ(value(dst, 3, 3, 1), 0.0f);
}

TEST(Errors, MatrixWithoutInverse) {
    const auto src = make(8, 8, 3);
    const float nan = std::nanf("");
    const float flat[3][3] = {{1, 1, 0}, {1, 1, 0}, {0, 0, 1}};
    const float none[3][3] = {{nan, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (const auto& M : {flat, none}) {
        ImageBuf dst;
        EXPECT_FALSE(ddt::warp(dst, src, *reinterpret_cast<const float(*)[3][3]>(M)));
        expect_error(dst, "inverse");
    }
}

TEST(Errors, UnknownColourSpace) {
    ddt::Options options;
    options.light = "nosuch";
    expect_failure(make(8, 8, 3), "nosuch", window(0, 64, 0, 64), options);
}

TEST(Errors, OptionsAreCheckedWhetherOrNotTheyAreUsed) {
    ddt::Options light, blur;
    light.light = "nosuch";
    blur.mesh.blur = 99;
    const auto src = make(8, 8, 3);
    for (const int size : {4, 8, 16}) {
        expect_failure(src, "nosuch", window(0, size, 0, size), light);
        expect_failure(src, "blur", window(0, size, 0, size), blur);
    }
    ImageBuf dst;
    EXPECT_FALSE(ddt::fill(dst, src, blur));
    expect_error(dst, "blur");
}

TEST(Errors, MissingConfig) {
    auto src = make(8, 8, 3);
    src.specmod().attribute("oiio:ColorSpace", "sRGB");
    const ddt::Environment config("OCIO", "/nowhere/config.ocio");
    expect_failure(src, "/nowhere/config.ocio");
    ddt::Options encoded;
    encoded.light = "encoded";
    ImageBuf dst;
    EXPECT_TRUE(ddt::resize(dst, src, encoded, window(0, 64, 0, 64))) << dst.geterror();
}

TEST(Errors, CancelledLeavesNothing) {
    auto src = make(600, 300, 3);
    images::fill(src, [](int, int, int) { return 0.5f; });
    ddt::Options options;
    options.progress = [](float) { return false; };
    expect_failure(src, "cancelled", window(0, 700, 0, 400), options);
    auto dst = make(700, 400, 3);
    images::fill(dst, [](int, int, int) { return 0.25f; });
    EXPECT_FALSE(ddt::resize(dst, src, options, window(0, 700, 0, 200)));
    expect_error(dst, "cancelled");
    for (int y = 0; y < 400; ++y)
        for (int x = 0; x < 700; ++x)
            ASSERT_EQ(value(dst, x, y), y < 200 ? 0.0f : 0.25f);
}

TEST(Errors, CallbackThatThrows) {
    auto src = make(16, 16, 1);
    ddt::Options options;
    options.progress = [](float) -> bool { throw std::runtime_error("from the callback"); };
    expect_failure(src, "from the callback", window(0, 64, 0, 64), options);
}

/// OpenImageIO's own filter would end the process: it has 2^20 weights and more.
TEST(Errors, ShrinkingByTooMuch) {
    for (const ROI& to : {window(0, 1, 0, 1), window(0, 2, 0, 1)})
        for (const bool turned : {false, true}) {
            const ImageBuf src =
                turned ? make(200000, 1, 1, OIIO::TypeUInt8) : make(1, 200000, 1, OIIO::TypeUInt8);
            const ROI roi = turned ? window(0, to.yend, 0, to.xend) : to;
            ImageBuf dst;
            EXPECT_FALSE(ddt::resize(dst, src, {}, roi));
            EXPECT_FALSE(dst.initialized());
            expect_error(dst, turned ? "200000 x 1 pixels" : "1 x 200000 pixels");
        }
}

TEST(Errors, DestinationWithoutADisplayWindow) {
    ImageSpec spec(8, 8, 1, OIIO::TypeFloat);
    spec.full_width = spec.full_height = 0;
    ImageBuf dst(spec);
    EXPECT_FALSE(ddt::resize(dst, make(4, 4, 1)));
    expect_error(dst, "display window has 0 x 0 pixels");
}

TEST(Errors, AnotherThatIsPendingOnTheDestinationStays) {
    ImageBuf dst = make(8, 8, 1);
    dst.error("left by somebody");
    EXPECT_FALSE(ddt::resize(dst, ImageBuf()));
    const std::string error = dst.geterror();
    EXPECT_EQ(error.find("left by somebody"), 0u) << error;
    EXPECT_NE(error.find("ddt: the source image is uninitialised"), std::string::npos) << error;
}

TEST(Errors, AreOneLineWhateverIsEchoed) {
    ddt::Options options;
    options.light = "no\nspace";
    expect_failure(make(4, 4, 3), "no space", window(0, 8, 0, 8), options);
}

/// Not under sanitizers, whose own memory is more than any limit.
TEST(Errors, MemoryThatRunsOutIsCalledSo) {
    const ImageBuf src = make(64, 64, 4);
    ImageBuf warm, dst;
    ASSERT_TRUE(ddt::resize(warm, src, {}, window(0, 128, 0, 128))); // threads take address space
    const ddt::test::ResourceLimit limit(RLIMIT_AS, rlim_t(4) << 30);
    EXPECT_FALSE(ddt::resize(dst, src, {}, window(0, 32768, 0, 16384))); // 8 GiB
    EXPECT_FALSE(dst.initialized());
    expect_error(dst, "out of memory");
}

} // namespace
