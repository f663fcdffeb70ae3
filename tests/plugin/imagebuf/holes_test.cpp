// SPDX-License-Identifier: Apache-2.0
// The option holes=, wherever an ImageBuf goes in.
#include <cmath>
#include <limits>

#include "ddt/option_table.h"
#include <OpenImageIO/Imath.h>

#include "tests/plugin/images.h"

namespace {

using images::bytes;
using images::enlarged;
using images::value;
using images::window;
using OIIO::ImageBuf;

constexpr int width = 40, height = 30, channels = 4;
const float nan = std::numeric_limits<float>::quiet_NaN();

/// Black and white with a slanting edge; alpha 1.
float plain(int x, int y, int c) {
    return c == 3 ? 1.0f : 2 * y > x + 9 ? 1.0f : 0.0f;
}
bool in_hole(int x, int y) {
    return x >= 15 && x < 23 && y >= 8 && y < 18;
}

/// The edge with a hole across it, of NaNs or of alpha 0.
ImageBuf holed(bool by_alpha, OIIO::TypeDesc type = OIIO::TypeFloat) {
    ImageBuf image = images::make(width, height, channels, type);
    image.specmod().alpha_channel = 3;
    image.specmod().attribute("oiio:ColorSpace", "Linear");
    images::fill(image, [&](int x, int y, int c) {
        return !in_hole(x, y) ? plain(x, y, c) : by_alpha ? 0.0f : nan;
    });
    return image;
}

ddt::Options options_of(const std::string& spec) {
    ddt::Options options;
    std::string error;
    EXPECT_TRUE(ddt::parse_filter(spec, options, error)) << error;
    return options;
}

/// How many of the result's pixels are not what the whole picture gives.
int count_wrong(const ImageBuf& result) {
    ImageBuf whole = images::make(width, height, channels);
    whole.specmod().alpha_channel = 3;
    images::fill(whole, plain);
    const ImageBuf right = enlarged(whole, 4 * width, 4 * height, options_of("ddt,light=encoded"));
    int wrong = 0;
    for (int y = 0; y < 4 * height; ++y)
        for (int x = 0; x < 4 * width; ++x)
            wrong += !(std::fabs(value(result, x, y) - value(right, x, y)) < 0.1f) ||
                     !(std::fabs(value(result, x, y, 3) - 1.0f) < 1e-3f);
    return wrong;
}

// The hole is 32 x 40 of the result's pixels; what is not sure is a strip along the edge.
TEST(HolesOption, EdgesRunOnAcrossWhatIsFilled) {
    for (const bool by_alpha : {false, true}) {
        const std::string holes = by_alpha ? "fill-alpha" : "fill";
        const ImageBuf src = holed(by_alpha);
        const auto filled = enlarged(src, 4 * width, 4 * height, options_of("ddt,holes=" + holes));
        const auto kept = enlarged(src, 4 * width, 4 * height, options_of("ddt"));
        EXPECT_LT(count_wrong(filled), 30) << holes;
        EXPECT_GT(count_wrong(kept), 1000) << holes;
    }
}

TEST(HolesOption, TransparentPixelsAreKeptUnlessChosen) {
    const ImageBuf src = holed(true);
    const auto a = enlarged(src, 80, 60, options_of("ddt,holes=fill"));
    const auto b = enlarged(src, 80, 60, options_of("ddt"));
    EXPECT_EQ(bytes(a), bytes(b));
    // Integers have no NaN, but alpha.
    const ImageBuf integers = holed(true, OIIO::TypeUInt8);
    const auto c = enlarged(integers, 4 * width, 4 * height, options_of("ddt,holes=fill-alpha"));
    EXPECT_LT(count_wrong(c), 30);
}

TEST(HolesOption, APartIsACropOfTheWholeInPixelsAndChannels) {
    ImageBuf src = holed(false);
    const float lacks_blue[] = {0.5f, 0.5f, nan, 1.0f};
    src.setpixel(31, 20, lacks_blue);
    const ddt::Options options = options_of("ddt-sharp,holes=fill");
    const auto whole = enlarged(src, 3 * width, 3 * height, options);
    ImageBuf dst = images::make(3 * width, 3 * height, channels);
    OIIO::ROI part = window(40, 100, 20, 70);
    part.chbegin = 1;
    part.chend = 2;
    ASSERT_TRUE(ddt::resize(dst, src, options, part)) << dst.geterror();
    EXPECT_EQ(bytes(dst, part), bytes(whole, part));
}

TEST(HolesOption, FilledBeforeWhatIsNotEnlargedToo) {
    const ImageBuf src = holed(false);
    const ddt::Options options = options_of("ddt,holes=fill");
    ImageBuf filled;
    ASSERT_TRUE(ddt::fill(filled, src, options_of("ddt"))) << filled.geterror();
    EXPECT_EQ(bytes(enlarged(src, width, height, options)), bytes(filled));
    for (const auto& size : {std::pair{13, 11}, std::pair{60, 11}, std::pair{13, 50}})
        EXPECT_EQ(bytes(enlarged(src, size.first, size.second, options)),
                  bytes(enlarged(filled, size.first, size.second, options_of("ddt"))))
            << size.first;
}

TEST(HolesOption, FillingTellsOfItsMeshIfItMakesOne) {
    ddt::Statistics statistics;
    ddt::Options options = options_of("ddt");
    options.statistics = &statistics;
    ImageBuf filled, again;
    ASSERT_TRUE(ddt::fill(filled, holed(false), options)) << filled.geterror();
    // The hole's surroundings, not the whole image.
    EXPECT_GT(statistics.pixels, 100);
    EXPECT_LT(statistics.pixels, width * height - 8 * 10);
    EXPECT_GT(statistics.flips, 0);
    statistics.pixels = -7;
    ASSERT_TRUE(ddt::fill(again, filled, options)) << again.geterror();
    EXPECT_EQ(statistics.pixels, -7);
}

TEST(HolesOption, NoMoreMemoryIsTakenThanAnImageMayHave) {
    const ImageBuf src = images::make(600, 600, 3, OIIO::TypeHalf); // 2 MB, and floats 4 or more
    int before = 0;
    OIIO::getattribute("limits:imagesize_MB", before);
    OIIO::attribute("limits:imagesize_MB", 3);
    ImageBuf filled, part = images::make(8, 8, 3);
    EXPECT_FALSE(ddt::fill(filled, src));
    EXPECT_NE(filled.geterror().find("limits:imagesize_MB"), std::string::npos);
    const ddt::Options holes = options_of("ddt,holes=fill");
    OIIO::set_roi_full(part.specmod(), window(0, 1200, 0, 1200));
    EXPECT_FALSE(ddt::resize(part, src, holes));
    EXPECT_NE(part.geterror().find("limits:imagesize_MB"), std::string::npos);
    EXPECT_TRUE(ddt::resize(part, src, options_of("ddt"))) << part.geterror();
    OIIO::attribute("limits:imagesize_MB", before);
}

TEST(HolesOption, OtherPixelsKeepTheirBits) {
    ImageBuf src = images::make(9, 9, 2, OIIO::TypeDesc::DOUBLE);
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 9; ++x)
            for (int c = 0; c < 2; ++c)
                static_cast<double*>(src.pixeladdr(x, y))[c] = 16777217.0 + x + c;
    static_cast<double*>(src.pixeladdr(4, 4))[1] = nan;
    ImageBuf dst;
    ASSERT_TRUE(ddt::fill(dst, src)) << dst.geterror();
    const auto at = [&](int x, int c) { return static_cast<double*>(dst.pixeladdr(x, 4))[c]; };
    EXPECT_EQ(dst.spec().format, OIIO::TypeDesc(OIIO::TypeDesc::DOUBLE));
    EXPECT_EQ(at(3, 1), 16777221.0);
    EXPECT_EQ(at(4, 0), 16777221.0);
    EXPECT_NEAR(at(4, 1), 16777222.0, 4);
}

// Filled pixels are rounded once, at the end.
TEST(HolesOption, AHalfImageIsFilledAsItsFloatsAre) {
    const ImageBuf half = holed(false, OIIO::TypeHalf);
    ImageBuf floats;
    ASSERT_TRUE(floats.copy(half, OIIO::TypeFloat));
    const ddt::Options options = options_of("ddt,holes=fill");
    for (const auto& [w, h] : {std::pair{width, height}, {2 * width, height / 2}, {60, 60}}) {
        ImageBuf a = images::make(w, h, channels), b = images::make(w, h, channels);
        ASSERT_TRUE(ddt::resize(a, half, options)) << a.geterror();
        ASSERT_TRUE(ddt::resize(b, floats, options)) << b.geterror();
        EXPECT_EQ(bytes(a), bytes(b)) << w << " x " << h;
    }
}

// By their type integers are known to be encoded.
TEST(HolesOption, IntegersKeepTheirLightWhereOneAxisShrinks) {
    constexpr int wide = 80, high = 40, far = 120;
    ImageBuf whole = images::make(wide, high, channels, OIIO::TypeUInt8);
    whole.specmod().alpha_channel = 3;
    images::noise(whole);
    for (int y = 0; y < high; ++y)
        for (int x = 0; x < wide; ++x) {
            float pixel[channels];
            whole.getpixel(x, y, pixel);
            pixel[3] = 1;
            whole.setpixel(x, y, pixel);
        }
    ImageBuf holed = whole;
    const float nothing[channels] = {};
    holed.setpixel(2, 2, nothing);
    const ddt::Options options = options_of("ddt,holes=fill-alpha");
    const ImageBuf a = enlarged(whole, 2 * wide, high / 2, options),
                   b = enlarged(holed, 2 * wide, high / 2, options);
    for (int y = 0; y < high / 2; ++y)
        for (int x = far; x < 2 * wide; ++x)
            for (int c = 0; c < channels; ++c)
                ASSERT_EQ(value(a, x, y, c), value(b, x, y, c)) << x << " " << y << " " << c;
}

TEST(HolesOption, IdsHaveNone) {
    ImageBuf src = images::make(4, 4, 3, OIIO::TypeUInt32);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x)
            for (int c = 0; c < 3; ++c)
                static_cast<uint32_t*>(src.pixeladdr(x, y))[c] = uint32_t(100 * (c + 1) + x);
    *static_cast<uint32_t*>(src.pixeladdr(1, 1)) = 0xffffffffu; // as a float: NaN
    ImageBuf kept = images::make(8, 8, 1, OIIO::TypeUInt32), filled = kept;
    ASSERT_TRUE(ddt::resize(kept, src)) << kept.geterror();
    ASSERT_TRUE(ddt::resize(filled, src, options_of("ddt,holes=fill"))) << filled.geterror();
    EXPECT_EQ(bytes(filled), bytes(kept));
}

TEST(HolesOption, Warps) {
    const ImageBuf src = holed(false);
    for (const float scale : {1.0f, 2.0f, 0.5f}) {
        const Imath::M33f m(scale, 0, 0, 0, scale, 0, 3, 0, 1);
        ImageBuf dst;
        ASSERT_TRUE(ddt::warp(dst, src, m, options_of("ddt,holes=fill"), true)) << dst.geterror();
        for (int y = dst.ybegin(); y < dst.yend(); ++y)
            for (int x = dst.xbegin(); x < dst.xend(); ++x)
                ASSERT_FALSE(std::isnan(value(dst, x, y))) << scale << ": " << x << " " << y;
    }
}

TEST(Fill, WritesIntoItsCallersMemory) {
    const ImageBuf src = holed(false);
    ImageBuf filled;
    ASSERT_TRUE(ddt::fill(filled, src)) << filled.geterror();
    for (const OIIO::TypeDesc& type : {OIIO::TypeFloat, OIIO::TypeHalf}) {
        const OIIO::ImageSpec spec(width, height, channels, type);
        std::vector<unsigned char> memory(spec.image_bytes(), 9);
        ImageBuf dst(spec, memory.data());
        ASSERT_TRUE(ddt::fill(dst, src)) << dst.geterror();
        EXPECT_EQ(dst.storage(), ImageBuf::APPBUFFER);
        const ImageBuf wanted = filled.copy(type);
        EXPECT_EQ(memory, bytes(wanted));
    }
    // In place.
    std::vector<unsigned char> memory = bytes(src);
    ImageBuf own(OIIO::ImageSpec(width, height, channels, OIIO::TypeFloat), memory.data());
    ASSERT_TRUE(ddt::fill(own, own)) << own.geterror();
    EXPECT_EQ(memory, bytes(filled));
    // Of another size there is no room.
    std::vector<float> small(5 * 5 * channels, 9.0f);
    ImageBuf other(OIIO::ImageSpec(5, 5, channels, OIIO::TypeFloat), small.data());
    EXPECT_FALSE(ddt::fill(other, src));
    EXPECT_NE(other.geterror().find("5 x 5 pixels of 4 channels; needed are 40 x 30 of 4"),
              std::string::npos);
    EXPECT_EQ(small, std::vector<float>(small.size(), 9.0f));
}

TEST(HolesOption, SaysWhatCannotBe) {
    ImageBuf src = images::make(8, 8, 1), dst;
    images::fill(src, [](int, int, int) { return nan; });
    EXPECT_FALSE(
        ddt::resize(dst, src, options_of("ddt,holes=fill"), OIIO::ROI(0, 16, 0, 16, 0, 1)));
    EXPECT_EQ(dst.geterror(), "ddt: no pixel is there to fill the others from");
    EXPECT_FALSE(ddt::fill(dst, holed(false), {}, ddt::Missing(2)));
    EXPECT_EQ(dst.geterror(), "ddt: what is missing must be nan or alpha");
    ddt::Options options;
    std::string error;
    EXPECT_FALSE(ddt::parse_filter("ddt,holes=x", options, error));
    EXPECT_NE(error.find("keep, fill, fill-alpha"), std::string::npos) << error;
}

} // namespace
