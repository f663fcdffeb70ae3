// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <set>

#include "tests/core/host_floats.h"
#include "tests/core/plain.h"
#include "tests/many_threads.h"
#include "tests/plugin/images.h"
#include "tests/temporary.h"

namespace {

using images::bytes;
using images::enlarged;
using images::make;
using images::value;
using images::window;
using OIIO::ImageBuf;
using OIIO::ROI;
using OIIO::TypeDesc;

const TypeDesc::BASETYPE blended[] = {TypeDesc::UINT8, TypeDesc::INT8, TypeDesc::UINT16,
                                      TypeDesc::INT16, TypeDesc::HALF, TypeDesc::FLOAT,
                                      TypeDesc::DOUBLE};

void disc(ImageBuf& image) {
    images::fill(image, [&](int x, int y, int c) {
        return 0.9f * images::disc(x + c % 3, y, image.spec().width);
    });
}

// Every type shows the picture that float shows, to within its own step.
TEST(Resize, EveryType) {
    auto reference = make(20, 20, 3);
    disc(reference);
    reference.specmod().attribute("oiio:ColorSpace", "Linear");
    const auto expected = enlarged(reference, 77, 50);
    for (const auto type : blended) {
        auto src = make(20, 20, 3, type);
        disc(src);
        src.specmod().attribute("oiio:ColorSpace", "Linear");
        const auto dst = enlarged(src, 77, 50);
        EXPECT_EQ(dst.spec().format, TypeDesc(type));
        const double step = type == TypeDesc::INT8    ? 1.0 / 127
                            : type == TypeDesc::UINT8 ? 1.0 / 255
                                                      : 1.0 / 1024;
        double difference = 0;
        for (int y = 0; y < 50; ++y)
            for (int x = 0; x < 77; ++x)
                for (int c = 0; c < 3; ++c)
                    difference += std::fabs(value(dst, x, y, c) - value(expected, x, y, c));
        // The mean: a coarse type may flip an edge the other way here and there.
        EXPECT_LT(difference / (50 * 77 * 3), step) << TypeDesc(type).c_str();
    }
}

TEST(Resize, SourceAndDestinationOfDifferentTypes) {
    auto src = make(12, 12, 3, OIIO::TypeUInt8);
    disc(src);
    src.specmod().attribute("oiio:ColorSpace", "sRGB");
    auto fine = make(48, 48, 3), coarse = make(48, 48, 3, OIIO::TypeUInt8);
    ASSERT_TRUE(ddt::resize(fine, src));
    ASSERT_TRUE(ddt::resize(coarse, src));
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 48; ++x)
            ASSERT_NEAR(value(fine, x, y, 1), value(coarse, x, y, 1), 0.5 / 255 + 1e-5);
}

// Hosts hold a file's integers as floats.
TEST(Resize, IntegersOfNoKnownSpaceAreThoseOfTheFileWhateverHoldsThem) {
    auto painted = make(24, 24, 3, OIIO::TypeUInt8);
    images::noise(painted);
    const std::string path = ddt::temporary("integers.sgi");
    ASSERT_TRUE(painted.write(path)) << painted.geterror();
    ImageBuf integers(path), floats(path);
    ASSERT_TRUE(integers.read(0, 0, true, OIIO::TypeUInt8)) << integers.geterror();
    ASSERT_TRUE(floats.read(0, 0, true, OIIO::TypeFloat)) << floats.geterror();
    auto expected = make(72, 72, 3), result = make(72, 72, 3);
    ASSERT_TRUE(ddt::resize(expected, integers)) << expected.geterror();
    ASSERT_TRUE(ddt::resize(result, floats)) << result.geterror();
    EXPECT_EQ(bytes(result), bytes(expected));
}

// Positions on vertices: 3 times, the middle pixel of each nine is the source's.
TEST(Resize, VerticesComeBackThroughLinearLight) {
    for (const auto type : {TypeDesc::UINT8, TypeDesc::UINT16})
        for (const char* space :
             {"sRGB", "Rec709", "Gamma2.2", "AdobeRGB", "ACEScg", "Linear", ""}) {
            auto src = make(64, 64, 3, type);
            images::noise(src, 0, 1, 3);
            src.specmod().attribute("oiio:ColorSpace", space);
            const auto dst = enlarged(src, 192, 192);
            for (int y = 0; y < 64; ++y)
                for (int x = 0; x < 64; ++x)
                    ASSERT_EQ(bytes(dst, window(3 * x + 1, 3 * x + 2, 3 * y + 1, 3 * y + 2)),
                              bytes(src, window(x, x + 1, y, y + 1)))
                        << space;
        }
}

TEST(Resize, IdentityKeepsEveryBit) {
    for (int type = TypeDesc::UINT8; type <= TypeDesc::DOUBLE; ++type) {
        if (type == TypeDesc::UINT64 || type == TypeDesc::INT64)
            continue;
        auto src = make(window(-2, 30, 5, 22), window(0, 25, 0, 25), 5,
                        TypeDesc(TypeDesc::BASETYPE(type)));
        // Any bits at all; the bytes of NaNs too.
        auto* p = static_cast<unsigned char*>(src.localpixels());
        for (size_t i = 0; i < src.spec().image_bytes(); ++i)
            p[i] = static_cast<unsigned char>((i * 2654435761u) >> 13);
        src.specmod().attribute("oiio:ColorSpace", "sRGB");
        ImageBuf same, moved;
        ASSERT_TRUE(ddt::resize(same, src)) << same.geterror();
        EXPECT_EQ(bytes(same), bytes(src)) << TypeDesc(TypeDesc::BASETYPE(type)).c_str();
        // Into a display window elsewhere, a part of it.
        moved = make(window(110, 120, 210, 220), window(100, 125, 200, 225), 5, src.spec().format);
        ASSERT_TRUE(ddt::resize(moved, src)) << moved.geterror();
        EXPECT_EQ(bytes(moved), bytes(src, window(10, 20, 10, 20)));
    }
}

TEST(Resize, IdentityBeyondTheDataRepeatsItsEdge) {
    auto src = make(window(2, 6, 2, 6), window(0, 8, 0, 8), 1);
    images::fill(src, [](int x, int y, int) { return float(10 * x + y); });
    auto dst = make(8, 8, 1);
    ASSERT_TRUE(ddt::resize(dst, src));
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            ASSERT_EQ(value(dst, x, y), float(10 * std::clamp(x, 2, 5) + std::clamp(y, 2, 5)));
}

TEST(Resize, ManyChannelsAreEachAsAlone) {
    for (const int channels : {1, 2, 3, 4, 5, 17, 64}) {
        auto src = make(16, 16, channels);
        // One guide for all: the first three channels are the same picture.
        images::fill(src, [](int x, int y, int c) {
            return images::disc(x, y, 16) * (c < 3 ? 1.0f : 1.0f + 0.1f * float(c));
        });
        src.specmod().alpha_channel = -1;
        // On planes: a patch's slopes are no linear function of the values.
        ddt::Options options;
        options.surface = ddt::test::plain_surface(ddt::Surface::linear);
        const auto dst = enlarged(src, 40, 40, options);
        ASSERT_EQ(dst.nchannels(), channels);
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 40; ++x)
                for (int c = 3; c < channels; ++c)
                    ASSERT_NEAR(value(dst, x, y, c), value(dst, x, y, 0) * (1.0f + 0.1f * float(c)),
                                2e-5f);
    }
}

TEST(Resize, RangeOfChannelsIsThatOfTheWhole) {
    auto src = make(20, 20, 6);
    disc(src);
    src.specmod().attribute("oiio:ColorSpace", "sRGB");
    const auto whole = enlarged(src, 60, 60);
    for (const auto& [begin, end] :
         {std::pair(0, 1), std::pair(1, 3), std::pair(2, 5), std::pair(3, 4), std::pair(4, 6)}) {
        auto dst = make(60, 60, 6);
        images::fill(dst, [](int, int, int) { return -5.0f; });
        ROI roi = window(0, 60, 0, 60);
        roi.chbegin = begin;
        roi.chend = end;
        ASSERT_TRUE(ddt::resize(dst, src, {}, roi));
        EXPECT_EQ(bytes(dst, roi), bytes(whole, roi));
        for (int c = 0; c < 6; ++c)
            ASSERT_EQ(value(dst, 30, 30, c) == -5.0f, c < begin || c >= end) << c;
    }
}

TEST(Resize, SameBitsForAnyNumberOfThreads) {
    const ddt::test::ManyThreads allowed;
    auto src = make(700, 300, 4, OIIO::TypeUInt16);
    images::noise(src);
    src.specmod().attribute("oiio:ColorSpace", "sRGB");
    const auto one = bytes(enlarged(src, 1000, 900, {}, 1));
    EXPECT_EQ(bytes(enlarged(src, 1000, 900, {}, 2)), one);
    EXPECT_EQ(bytes(enlarged(src, 1000, 900, {}, 7)), one);
    EXPECT_EQ(bytes(enlarged(src, 1000, 900, {}, 0)), one);
}

TEST(Resize, OptionsMatter) {
    auto src = make(24, 24, 3);
    images::noise(src);
    const auto patch = bytes(enlarged(src, 96, 96));
    for (const char* spec :
         {"ddt-linear", "ddt,cost=scf", "ddt,scheme=pixel", "ddt,iterations=0", "ddt,light=sRGB"}) {
        ddt::Options options;
        std::string error;
        ASSERT_TRUE(ddt::parse_filter(spec, options, error)) << error;
        EXPECT_NE(bytes(enlarged(src, 96, 96, options)), patch) << spec;
    }
}

TEST(Resize, UnsignedIntegersOf8And16BitsWillBeClipped) {
    ddt::Options sharp;
    std::string error;
    ASSERT_TRUE(ddt::parse_filter("ddt-sharp", sharp, error)) << error;
    ddt::Options clipped = sharp;
    clipped.surface.clipped = true;
    for (const auto type : blended) {
        auto src = make(24, 24, 1, type);
        images::noise(src);
        for (const int height : {96, 12}) { // an axis may shrink
            const bool same = bytes(enlarged(src, 96, height, sharp)) ==
                              bytes(enlarged(src, 96, height, clipped));
            EXPECT_EQ(same, type == TypeDesc::UINT8 || type == TypeDesc::UINT16)
                << TypeDesc(type).c_str() << ", " << height;
        }
    }
}

// IDs are copied: of the bits of NaNs, denormals and signed zeros, none is touched.
TEST(Resize, IntegersAreCopiedBitForBit) {
    for (const auto type : {TypeDesc::UINT32, TypeDesc::INT32}) {
        auto src = make(16, 16, 2, type);
        auto* p = static_cast<uint32_t*>(src.localpixels());
        std::set<uint64_t> pixels;
        const uint32_t odd[] = {0,          1,          0x7f800001, 0x7fc00000,
                                0xffffffff, 0x80000000, 0x007fffff, 0x00000100};
        for (size_t i = 0; i < 256; ++i) {
            p[2 * i] = odd[i % 8] ^ uint32_t(i << 8);
            p[2 * i + 1] = uint32_t(i);
            pixels.insert(uint64_t(p[2 * i]) << 32 | p[2 * i + 1]);
        }
        const auto dst = enlarged(src, 48, 48);
        const auto* q = static_cast<const uint32_t*>(dst.localpixels());
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 48; ++x) {
                const uint32_t* v = q + 2 * (y * 48 + x);
                // Both channels from the same pixel, and that one no further than a cell away.
                ASSERT_TRUE(pixels.count(uint64_t(v[0]) << 32 | v[1])) << x << " " << y;
                ASSERT_LE(std::abs(int(v[1] % 16) * 3 + 1 - x), 3);
                ASSERT_LE(std::abs(int(v[1] / 16) * 3 + 1 - y), 3);
            }
    }
}

TEST(Resize, ChannelsOfIdsAreCopied) {
    for (const auto type : {TypeDesc::FLOAT, TypeDesc::HALF, TypeDesc::UINT16, TypeDesc::UINT8}) {
        auto src = make(16, 16, 4, type);
        src.specmod().channelnames = {"R", "G", "B", "objectId"};
        src.specmod().alpha_channel = -1;
        images::fill(src, [](int x, int y, int c) {
            return c == 3 ? float((x / 5 + 3 * (y / 5)) % 7) / 8 : images::disc(x, y, 16);
        });
        std::set<float> ids;
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 16; ++x)
                ids.insert(value(src, x, y, 3));
        for (const auto& [width, height] :
             {std::pair{61, 61}, std::pair{7, 61}, std::pair{61, 7}, std::pair{7, 5}}) {
            const auto dst = enlarged(src, width, height);
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x)
                    ASSERT_TRUE(ids.count(value(dst, x, y, 3))) << width << ' ' << height;
        }
    }
}

TEST(Resize, IntegersShrinkToTheNearestPixel) {
    OIIO::ImageSpec spec(24, 20, 1, OIIO::TypeUInt32);
    ImageBuf src(spec);
    auto* const p = static_cast<uint32_t*>(src.localpixels());
    for (uint32_t i = 0; i < 24 * 20; ++i)
        p[i] = 4000000000u - i;
    for (const auto& [width, height] : {std::pair{8, 4}, std::pair{8, 100}, std::pair{72, 4}}) {
        ImageBuf dst;
        ASSERT_TRUE(ddt::resize(dst, src, {}, window(0, width, 0, height))) << dst.geterror();
        ASSERT_EQ(dst.spec().format, OIIO::TypeUInt32);
        const auto* const q = static_cast<const uint32_t*>(dst.localpixels());
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                ASSERT_EQ(q[y * width + x],
                          p[(2 * y + 1) * 20 / (2 * height) * 24 + (2 * x + 1) * 24 / (2 * width)])
                    << x << ' ' << y;
    }
}

// A bad number shows only near its pixel, in its channel, and nothing hangs.
TEST(Resize, BadNumbersAreContained) {
    const float infinity = std::numeric_limits<float>::infinity();
    for (const char* space : {"Linear", "sRGB"})
        for (const float bad : {std::nanf(""), infinity, -infinity, 1e38f, -1e38f}) {
            auto clean = make(40, 40, 4);
            images::fill(
                clean, [](int x, int y, int c) { return c == 3 ? 1.0f : images::disc(x, y, 40); });
            clean.specmod().attribute("oiio:ColorSpace", space);
            ImageBuf src = clean;
            float pixel[4] = {bad, 0.25f, 0.25f, 1.0f};
            src.setpixel(20, 20, pixel);
            const auto dst = enlarged(src, 160, 160), expected = enlarged(clean, 160, 160);
            for (int y = 0; y < 160; ++y)
                for (int x = 0; x < 160; ++x)
                    for (int c = 0; c < 4; ++c) {
                        const float v = value(dst, x, y, c);
                        const bool far = std::abs(x - 82) > 60 || std::abs(y - 82) > 60;
                        ASSERT_TRUE(!far || v == value(expected, x, y, c))
                            << bad << " " << x << " " << y;
                        ASSERT_TRUE(c == 0 || (v >= 0 && v <= 1.01f)) << v;
                    }
        }
}

TEST(Resize, NanIsZeroInIntegers) {
    auto src = make(4, 4, 1);
    images::fill(src, [](int, int, int) { return std::nanf(""); });
    for (const auto type : {TypeDesc::UINT8, TypeDesc::UINT16, TypeDesc::INT16}) {
        auto dst = make(9, 9, 1, type);
        ASSERT_TRUE(ddt::resize(dst, src));
        EXPECT_EQ(value(dst, 4, 4), 0.0f);
    }
}

TEST(Resize, NanIsZeroInIntegersOfTheSameSizeToo) {
    auto src = make(4, 4, 1);
    images::fill(src, [](int x, int, int) { return x ? std::nanf("") : 0.5f; });
    for (const auto type : {TypeDesc::INT8, TypeDesc::INT16, TypeDesc::INT32}) {
        auto dst = make(4, 4, 1, type);
        ASSERT_TRUE(ddt::resize(dst, src));
        EXPECT_EQ(value(dst, 2, 2), 0.0f);
        EXPECT_NEAR(value(dst, 0, 2), 0.5f, 0.01f);
    }
}

TEST(Resize, ADestinationKeepsItsTypeAndMemory) {
    auto src = make(20, 20, 1);
    disc(src);
    for (const auto type : {TypeDesc::INT8, TypeDesc::INT16, TypeDesc::INT32, TypeDesc::DOUBLE})
        for (const auto& [w, h] : {std::pair(10, 10), std::pair(10, 40), std::pair(40, 10)}) {
            std::vector<double> memory(size_t(w * h), -1.0);
            OIIO::ImageSpec spec(w, h, 1, TypeDesc(type));
            ImageBuf dst(spec, memory.data());
            ASSERT_TRUE(ddt::resize(dst, src)) << dst.geterror();
            EXPECT_EQ(dst.spec().format, TypeDesc(type));
            EXPECT_EQ(dst.localpixels(), memory.data());
            EXPECT_GT(value(dst, w / 2, h / 2), 0.5f);
        }
}

TEST(Resize, StatisticsAreOfAllBands) {
    auto src = make(3000, 300, 4);
    disc(src);
    ddt::Statistics statistics;
    ddt::Options options;
    options.statistics = &statistics;
    options.mesh.scheme = ddt::Scheme::pixel; // soon done
    ImageBuf dst;
    std::vector<float> shares;
    options.progress = [&](float share) {
        shares.push_back(share);
        return true;
    };
    ASSERT_TRUE(ddt::resize(dst, src, options, window(0, 300, 0, 1200))) << dst.geterror();
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_EQ(shares.back(), 1.0f);
    // Two bands, or what is between them would have 58 MB: tiles where they meet are done twice.
    const int64_t in_bands = statistics.pixels;
    enlarged(src, 3000, 1200, options);
    EXPECT_GT(in_bands, statistics.pixels);
    EXPECT_GE(statistics.pixels, int64_t(3000) * 300);
}

// Neither axis grows: OpenImageIO's own result.
TEST(Resize, ShrinkingIsOpenImageIOs) {
    auto src = make(40, 40, 3);
    images::noise(src);
    for (const auto& [w, h] : {std::pair(13, 17), std::pair(40, 17), std::pair(13, 40)}) {
        ImageBuf dst, expected;
        ASSERT_TRUE(ddt::resize(dst, src, {}, window(0, w, 0, h))) << dst.geterror();
        ASSERT_TRUE(OIIO::ImageBufAlgo::resize(expected, src, "", 0.0f, window(0, w, 0, h)));
        EXPECT_EQ(bytes(dst), bytes(expected));
    }
}

// One grows, one shrinks: first the mesh, then OpenImageIO.
TEST(Resize, OneAxisGrowsTheOtherShrinks) {
    auto src = make(40, 40, 3);
    disc(src);
    for (const bool wide : {true, false}) {
        const int w = wide ? 100 : 11, h = wide ? 11 : 100;
        ImageBuf dst, expected;
        ASSERT_TRUE(ddt::resize(dst, src, {}, window(0, w, 0, h))) << dst.geterror();
        const auto between = enlarged(src, wide ? w : 40, wide ? 40 : h);
        ASSERT_TRUE(OIIO::ImageBufAlgo::resize(expected, between, "", 0.0f, window(0, w, 0, h)));
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x)
                ASSERT_NEAR(value(dst, x, y), value(expected, x, y), 1e-5f) << x << " " << y;
        // A part of it is a crop.
        const ROI part = window(3, 9, 2, 10);
        auto partial = make(w, h, 3);
        ASSERT_TRUE(ddt::resize(partial, src, {}, part));
        EXPECT_EQ(bytes(partial, part), bytes(dst, part));
    }
}

// Beyond its display window too, which OpenImageIO goes on from there beside the source.
TEST(Resize, OneAxisGrowsTheOtherShrinksInParts) {
    for (const bool turned : {false, true}) {
        const auto box = [&](int x0, int x1, int y0, int y1) {
            return turned ? window(y0, y1, x0, x1) : window(x0, x1, y0, y1);
        };
        auto src = make(box(0, 36, 0, 6), box(0, 36, 0, 6), 1);
        images::noise(src, 0.2f, 1);
        auto whole = make(box(-5, 23, -9, 37), box(0, 18, 0, 28), 1);
        ASSERT_TRUE(ddt::resize(whole, src)) << whole.geterror();
        for (const ROI& part : {box(-5, 3, 32, 33), box(17, 23, -9, -6), box(2, 20, 26, 30)}) {
            auto dst = make(box(-5, 23, -9, 37), box(0, 18, 0, 28), 1);
            ASSERT_TRUE(ddt::resize(dst, src, {}, part)) << dst.geterror();
            for (int y = part.ybegin; y < part.yend; ++y)
                for (int x = part.xbegin; x < part.xend; ++x)
                    EXPECT_EQ(value(dst, x, y, 0), value(whole, x, y, 0)) << x << ' ' << y;
        }
    }
}

TEST(Resize, SameBitsHoweverTheHostComputes) {
    // The first call finds out what a colour space is, for all that follow: the other has a name of
    // its own for it.
    for (const TypeDesc& type : {OIIO::TypeFloat, OIIO::TypeHalf, OIIO::TypeUInt8}) {
        auto src = make(40, 30, 4, type);
        images::noise(src);
        src.specmod().alpha_channel = 3;
        if (type == OIIO::TypeFloat) // quotients by such an alpha are denormals
            for (int c = 0; c < 4; ++c) {
                float pixel[4] = {0.25f, 0.5f, 0.75f, 1.0f};
                pixel[c] = 3e38f;
                src.setpixel(9 + 3 * c, 11, pixel);
            }
        for (const ddt::test::HostMode& mode : ddt::test::host_modes()) {
            src.specmod().attribute("oiio:ColorSpace", "sRGB");
            ImageBuf other;
            bool unchanged = false;
            {
                const ddt::test::HostFloats host(mode);
                other = enlarged(src, 90, 70);
                unchanged = host.unchanged();
            }
            EXPECT_TRUE(unchanged);
            src.specmod().attribute("oiio:ColorSpace", "srgb_tx");
            EXPECT_EQ(bytes(other), bytes(enlarged(src, 90, 70)))
                << mode.rounding << ' ' << mode.control;
        }
    }
}

TEST(Resize, ShrinkingKeepsToItsChannels) {
    auto src = make(20, 20, 4), dst = make(10, 10, 4);
    images::noise(src);
    images::fill(dst, [](int, int, int) { return -5.0f; });
    ROI roi = window(0, 10, 0, 10);
    roi.chbegin = 1;
    roi.chend = 3;
    ASSERT_TRUE(ddt::resize(dst, src, {}, roi)) << dst.geterror();
    EXPECT_EQ(value(dst, 5, 5, 0), -5.0f);
    EXPECT_NE(value(dst, 5, 5, 1), -5.0f);
    EXPECT_NE(value(dst, 5, 5, 2), -5.0f);
    EXPECT_EQ(value(dst, 5, 5, 3), -5.0f);
}

TEST(Resize, PixelsOfTheCallerWithStrides) {
    auto src = make(12, 12, 3);
    disc(src);
    const auto expected = enlarged(src, 48, 48);
    std::vector<float> padded(12 * 80, -1.0f), out(48 * 400, -1.0f);
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 12; ++x)
            for (int c = 0; c < 3; ++c)
                padded[size_t(80 * y + 5 * x + c)] = value(src, x, y, c);
    const ImageBuf from(src.spec(), padded.data(), 20, 320);
    ImageBuf to(expected.spec(), out.data(), 28, 1600);
    ASSERT_TRUE(ddt::resize(to, from)) << to.geterror();
    EXPECT_EQ(bytes(to), bytes(expected));
    EXPECT_EQ(out[3], -1.0f); // between the pixels
}

// Codes that are made at once.
TEST(Resize, BytesOfTheCallerWithStrides) {
    auto src = make(12, 12, 3, OIIO::TypeUInt8);
    disc(src);
    src.specmod().attribute("oiio:ColorSpace", "sRGB");
    const auto expected = enlarged(src, 48, 48);
    std::vector<unsigned char> out(48 * 200, 77);
    ImageBuf to(expected.spec(), out.data(), 4, 200);
    ASSERT_TRUE(ddt::resize(to, src)) << to.geterror();
    EXPECT_EQ(bytes(to), bytes(expected));
    for (size_t i = 0; i < out.size(); ++i)
        if (i % 200 >= 192 || i % 4 == 3) {
            ASSERT_EQ(out[i], 77) << i;
        }
}

// Of an image that is made for them the other channels are black, whatever was in its memory.
TEST(Resize, ChannelsThatAreNotAskedForAreBlack) {
    auto src = make(10, 10, 3);
    images::fill(src, [](int, int, int) { return 1.0f; });
    ROI roi = window(0, 20, 0, 20);
    roi.chbegin = 2;
    roi.chend = 3;
    for (int i = 0; i < 8; ++i) {
        {
            std::vector<ImageBuf> before;
            for (int k = 0; k < 4; ++k) {
                before.push_back(make(20, 20, 3));
                images::fill(before.back(), [](int, int, int) { return -7.0f; });
            }
        }
        ImageBuf dst;
        ASSERT_TRUE(ddt::resize(dst, src, {}, roi)) << dst.geterror();
        ASSERT_EQ(dst.nchannels(), 3);
        for (int y = 0; y < 20; ++y)
            for (int x = 0; x < 20; ++x)
                for (int c = 0; c < 3; ++c)
                    ASSERT_EQ(value(dst, x, y, c), c == 2 ? 1.0f : 0.0f) << x << " " << y;
    }
}

TEST(Resize, IntoItself) {
    auto image = make(16, 16, 3);
    disc(image);
    ImageBuf expected = make(16, 16, 3);
    ASSERT_TRUE(ddt::resize(expected, image));
    ASSERT_TRUE(ddt::resize(image, image)) << image.geterror();
    EXPECT_EQ(bytes(image), bytes(expected));
}

TEST(Resize, FromAFile) {
    const std::string path = ddt::temporary("resize_test.tif");
    auto src = make(50, 50, 3, OIIO::TypeUInt8);
    images::noise(src);
    ASSERT_TRUE(src.write(path));
    const ImageBuf file(path);
    EXPECT_EQ(bytes(enlarged(file, 120, 120)), bytes(enlarged(src, 120, 120)));
}

// OpenImageIO's cache would make them floats.
TEST(Resize, IntegersFromAFileAreCopiedBitForBit) {
    const std::string path = ddt::temporary("ids.tif");
    auto src = make(10, 10, 1, TypeDesc::UINT32);
    auto* p = static_cast<uint32_t*>(src.localpixels());
    for (uint32_t i = 0; i < 100; ++i)
        p[i] = 0xdeadbe00u + i;
    ASSERT_TRUE(src.write(path));
    const ImageBuf file(path);
    const auto dst = enlarged(file, 30, 30);
    EXPECT_EQ(dst.spec().format, TypeDesc(TypeDesc::UINT32));
    EXPECT_EQ(bytes(dst), bytes(enlarged(src, 30, 30)));
    // Wherever the host has moved it.
    for (ImageBuf moved : {ImageBuf(path), src}) {
        moved.set_origin(3, -2);
        const auto large = enlarged(moved, 30, 30);
        EXPECT_EQ(bytes(large, window(20, 21, 10, 11)), bytes(src, window(3, 4, 5, 6)));
    }
    // A host that made floats of them: rounded, but not blended.
    ImageBuf floats(path);
    ASSERT_TRUE(floats.read(0, 0, true, OIIO::TypeFloat));
    const auto blurred = enlarged(floats, 40, 40);
    std::set<float> ids;
    for (int i = 0; i < 100; ++i)
        ids.insert(value(floats, i % 10, i / 10));
    for (int i = 0; i < 1600; ++i)
        ASSERT_TRUE(ids.count(value(blurred, i % 40, i / 40)));
}

TEST(Resize, ProgressIsTold) {
    auto src = make(600, 300, 1);
    images::noise(src);
    float last = 0;
    ddt::Options options;
    options.progress = [&](float share) {
        EXPECT_GE(share, last);
        last = share;
        return true;
    };
    enlarged(src, 700, 400, options, 2);
    EXPECT_EQ(last, 1.0f);
}

} // namespace
