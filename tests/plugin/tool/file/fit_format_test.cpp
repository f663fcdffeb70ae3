// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/fit_format.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <OpenImageIO/imageio.h>

namespace ddt::tool {
namespace {

using OIIO::ImageSpec;

TEST(FitFormat, LeavesOutWhatLiesBeforeZero) {
    ImageSpec window(20, 15, 3, OIIO::TypeUInt8);
    window.x = -7;
    window.y = -5;
    window.full_x = -2;
    window.full_y = -3;
    window.full_width = 12;
    window.full_height = 9;
    const auto fitted = [&](const char* file, Failure& failure) {
        ImageSpec spec = window;
        const auto output = OIIO::ImageOutput::create(file);
        const bool fits = fit_format(*output, file, spec, failure);
        return fits ? spec.roi() : OIIO::ROI();
    };
    Failure failure;
    EXPECT_EQ(fitted("a.exr", failure), OIIO::ROI(-7, 13, -5, 10, 0, 1, 0, 3));
    // Without windows: of the display window.
    EXPECT_EQ(fitted("a.png", failure), OIIO::ROI(0, 10, 0, 6, 0, 1, 0, 3));
    EXPECT_EQ(failure.why, "");
    for (const auto& [x, y] : {std::pair(-12, 0), {0, -9}}) {
        window.full_x = x;
        window.full_y = y;
        EXPECT_FALSE(fitted("a.png", failure).defined());
        EXPECT_NE(failure.why.find("\"a.png\": no pixel has coordinates of 0 and more"),
                  std::string::npos)
            << failure.why;
        EXPECT_EQ(failure.code, exit_failed);
        EXPECT_TRUE(fitted("a.exr", failure).defined());
    }
}

TEST(FitFormat, LeavesTilesWhereTheFormatMayHaveThem) {
    const auto fitted = [](const char* name, int width, int height, const char* compression) {
        ImageSpec spec(100, 80, 3, OIIO::TypeUInt8);
        spec.tile_width = width;
        spec.tile_height = height;
        spec.attribute("compression", compression);
        Failure failure;
        EXPECT_TRUE(fit_format(*OIIO::ImageOutput::create(name), name, spec, failure));
        return std::pair(spec.tile_width, spec.tile_height);
    };
    const auto none = std::pair(0, 0);
    EXPECT_EQ(fitted("a.exr", 50, 30, "zip"), std::pair(50, 30));
    EXPECT_EQ(fitted("a.tif", 48, 16, "zip"), std::pair(48, 16));
    EXPECT_EQ(fitted("a.tif", 50, 32, "zip"), none);
    EXPECT_EQ(fitted("a.tif", 48, 16, "jpeg:90"), none);
    EXPECT_EQ(fitted("a.exr", 0, 0, "zip"), none);
    EXPECT_EQ(fitted("a.iff", 64, 64, "rle"), none);
    EXPECT_EQ(fitted("a.png", 64, 64, "zip"), none);
    // Of 64 MiB, and of a row of pixels more.
    EXPECT_EQ(fitted("a.exr", 4096, 5461, "zip"), std::pair(4096, 5461));
    EXPECT_EQ(fitted("a.exr", 4096, 5462, "zip"), none);
    EXPECT_EQ(fitted("a.exr", 1 << 24, 1 << 24, "zip"), none);
}

/// Of an image that says how many bits its numbers have.
ImageSpec fitted_spec(const char* name, OIIO::TypeDesc type, int bits,
                      const std::vector<OIIO::TypeDesc>& types = {}) {
    ImageSpec spec(8, 6, 3, type);
    spec.channelformats = types;
    spec.attribute("oiio:BitsPerSample", bits);
    Failure failure;
    EXPECT_TRUE(fit_format(*OIIO::ImageOutput::create(name), name, spec, failure));
    return spec;
}

TEST(FitFormat, HasFloatsForWhatFitsAndRlaSpoil) {
    const auto fitted = [](const char* name, OIIO::TypeDesc type) {
        return fitted_spec(name, type, int(type.size()) * 8).format;
    };
    const OIIO::TypeDesc real(OIIO::TypeDesc::DOUBLE);
    EXPECT_EQ(fitted("a.fits", OIIO::TypeHalf), OIIO::TypeFloat);
    EXPECT_EQ(fitted("a.fits", real), real);
    EXPECT_EQ(fitted("a.fits", OIIO::TypeUInt16), OIIO::TypeUInt16);
    EXPECT_EQ(fitted("a.rla", OIIO::TypeHalf), OIIO::TypeFloat);
    EXPECT_EQ(fitted("a.rla", real), OIIO::TypeFloat);
    EXPECT_EQ(fitted("a.rla", OIIO::TypeUInt16), OIIO::TypeUInt16);
    EXPECT_EQ(fitted("a.exr", OIIO::TypeHalf), OIIO::TypeHalf);
    const std::vector<OIIO::TypeDesc> types = {OIIO::TypeHalf, OIIO::TypeHalf, OIIO::TypeUInt32};
    const ImageSpec rla = fitted_spec("a.rla", OIIO::TypeFloat, 32, types);
    EXPECT_TRUE(rla.channelformats.empty());
    EXPECT_EQ(rla.format, OIIO::TypeFloat);
    EXPECT_EQ(fitted_spec("a.exr", OIIO::TypeFloat, 32, types).channelformats, types);
}

TEST(FitFormat, TellsOfBitsWhereTheWriterWritesThem) {
    const auto bits = [](const char* name, OIIO::TypeDesc type, int of_image) {
        return fitted_spec(name, type, of_image).get_int_attribute("oiio:BitsPerSample");
    };
    EXPECT_EQ(bits("a.dpx", OIIO::TypeUInt16, 10), 10);
    EXPECT_EQ(bits("a.rla", OIIO::TypeUInt16, 10), 10);
    EXPECT_EQ(bits("a.rla", OIIO::TypeDesc(OIIO::TypeDesc::DOUBLE), 64), 0);
    for (const char* name : {"a.ppm", "a.pgm", "a.pbm", "a.pnm"})
        for (const int of_image : {1, 6, 10, 12, 16, 64})
            EXPECT_EQ(bits(name, OIIO::TypeUInt16, of_image), 0) << name << " " << of_image;
}

TEST(FitChannels, TakesWhatOiiotoolTakes) {
    const auto left_out = [](const char* file, const std::vector<std::string>& names, int alpha) {
        ImageSpec spec(8, 6, int(names.size()), OIIO::TypeHalf);
        spec.channelnames = names;
        spec.alpha_channel = alpha;
        const auto output = OIIO::ImageOutput::create(file);
        const std::string told = fit_channels(*output, spec);
        EXPECT_EQ(spec.channelnames.size(), size_t(spec.nchannels));
        EXPECT_TRUE(std::equal(spec.channelnames.begin(), spec.channelnames.end(), names.begin()));
        return told;
    };
    EXPECT_EQ(left_out("a.png", {"u", "v", "w", "A", "Z", "mask"}, 3), "Z, mask");
    EXPECT_EQ(left_out("a.png", {"u", "v", "w", "x", "y"}, -1), "x, y");
    EXPECT_EQ(left_out("a.png", {"u", "v", "w", "x"}, -1), "");
    EXPECT_EQ(left_out("a.png", {"R", "G", "B", "Z"}, -1), "Z");
    EXPECT_EQ(left_out("a.png", {"Y", "A"}, 1), "");
    EXPECT_EQ(left_out("a.png", {"u", "v", "A"}, 2), "A as alpha");
    EXPECT_EQ(left_out("a.jpg", {"u", "A", "v", "w"}, 1), "A as alpha, w");
    EXPECT_EQ(left_out("a.exr", {"u", "v", "A"}, 2), "");
    EXPECT_EQ(left_out("a.jpg", {"u", "v", "w", "x"}, -1), "x");
    EXPECT_EQ(left_out("a.jpg", {"Y", "A"}, 1), "A");
    EXPECT_EQ(left_out("a.bmp", {"Y", "A"}, 1), "A");
    EXPECT_EQ(left_out("a.bmp", {"R", "G", "B", "A"}, 3), "");
    EXPECT_EQ(left_out("a.tif", {"u", "v", "w", "x", "y"}, -1), "");
    EXPECT_EQ(left_out("a.exr", {"Y", "A"}, 1), "");
}

} // namespace
} // namespace ddt::tool
