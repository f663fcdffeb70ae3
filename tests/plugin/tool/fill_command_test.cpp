// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <fstream>
#include <limits>
#include <thread>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <OpenImageIO/imagebufalgo.h>
#include <gtest/gtest.h>

#include "plugin/tool/commands.h"
#include "tests/plugin/tool/load_image.h"
#include "tests/plugin/tool/run_command.h"
#include "tests/plugin/tool/several_types.h"
#include "tests/temporary.h"

namespace ddt::tool {
namespace {

using OIIO::ImageBuf;
using OIIO::ImageSpec;

TEST(FillCommand, FillsWhatIsMissingAndNothingElse) {
    OIIO::ImageBuf image(OIIO::ImageSpec(12, 9, 4, OIIO::TypeFloat));
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 12; ++x) {
            const float plain[4] = {0.05f * float(x), 0.1f * float(y), 0.5f, 1};
            image.setpixel(x, y, plain);
        }
    const OIIO::ImageBuf whole = image;
    const float hole[4] = {nan, nan, nan, nan}, clear[4] = {0, 0, 0, 0};
    const float lacks_red[4] = {nan, 0.3f, 0.7f, 1};
    for (int x = 4; x < 7; ++x)
        image.setpixel(x, 4, hole);
    image.setpixel(2, 2, lacks_red);
    image.setpixel(9, 6, clear);
    const std::string in = temporary("holes.exr"), out = temporary("filled.exr");
    ASSERT_TRUE(image.write(in));
    for (const bool alpha : {false, true}) {
        const Ran ran = run(make_fill_command(), {in, out, "--missing", alpha ? "alpha" : "nan"});
        ASSERT_EQ(ran.code, exit_done) << ran.err;
        const OIIO::ImageBuf filled = load(out);
        for (int y = 0; y < 9; ++y)
            for (int x = 0; x < 12; ++x)
                for (int c = 0; c < 4; ++c) {
                    const bool was_clear = x == 9 && y == 6, lacked = x == 2 && y == 2;
                    const float wanted = was_clear && !alpha ? 0.0f
                                         : lacked && c > 0   ? lacks_red[c]
                                                             : whole.getchannel(x, y, 0, c);
                    EXPECT_NEAR(filled.getchannel(x, y, 0, c), wanted, 1e-6) << x << " " << y;
                }
    }
}

TEST(FillCommand, ChannelsKeepTheirTypes) {
    const std::string in = file_of_several_types(), out = temporary("several_types_filled.exr");
    const auto formats = OIIO::ImageInput::open(in)->spec().channelformats;
    ASSERT_EQ(make_fill_command()->run({in, out}), exit_done);
    EXPECT_EQ(OIIO::ImageInput::open(out)->spec().channelformats, formats);
    EXPECT_EQ(ids_of(out), std::make_pair(uint32_t(5), uint32_t(70000)));
}

TEST(FillCommand, WithoutAlphaNothingIsMissingByIt) {
    const std::string in = file_of_several_types(), out = temporary("no_alpha_filled.exr");
    testing::internal::CaptureStderr();
    EXPECT_EQ(parse_and_run(*make_fill_command(), {in, out, "--missing", "alpha"}), exit_failed);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "ddt: \"" + in + "\" has no alpha\n");
    EXPECT_FALSE(std::ifstream(out).good());
}

/// The option is `fill` then, since one filter serves all images.
TEST(FillCommand, TheFiltersHolesSayWhatIsMissing) {
    ImageBuf image(ImageSpec(8, 8, 4, OIIO::TypeFloat));
    OIIO::ImageBufAlgo::fill(image, {0.5f, 0.25f, 0.125f, 1.0f});
    image.setpixel(3, 4, {0, 0, 0, 0});
    const std::string in = temporary("clear.exr");
    ASSERT_TRUE(image.write(in)) << image.geterror();
    struct Case {
        std::vector<std::string> flags;
        float alpha;
    };
    const Case cases[] = {{{}, 0},
                          {{"--filter", "ddt,holes=fill"}, 0},
                          {{"--filter", "ddt,holes=fill-alpha"}, 1},
                          {{"--filter", "ddt,holes=fill-alpha", "--missing", "nan"}, 0},
                          {{"--filter", "ddt", "--missing", "alpha"}, 1}};
    for (const Case& c : cases) {
        // Names of their own: OpenImageIO keeps what it read.
        const std::string out = temporary("clear" + std::to_string(&c - cases) + ".exr");
        std::vector<std::string> arguments{in, out};
        arguments.insert(arguments.end(), c.flags.begin(), c.flags.end());
        ASSERT_EQ(parse_and_run(*make_fill_command(), arguments), exit_done);
        EXPECT_EQ(ImageBuf(out).getchannel(3, 4, 0, 3), c.alpha);
    }
    const std::string opaque = file_of_several_types(), out = temporary("opaque.exr");
    EXPECT_EQ(
        parse_and_run(*make_fill_command(), {opaque, out, "--filter", "ddt,holes=fill-alpha"}),
        exit_done);
}

/// It is written into a pipe, which does not hold all of it, so that the change comes after the
/// source was read and before its filled image is done.
TEST(FillCommand, OfASourceThatChangesMeanwhileThereIsNone) {
    const std::string in = temporary("changes.ppm"), out = temporary("pipe.ppm");
    ImageBuf image(ImageSpec(1000, 700, 3, OIIO::TypeUInt8));
    ASSERT_TRUE(image.write(in)) << image.geterror();
    ASSERT_EQ(mkfifo(out.c_str(), 0600), 0);
    size_t arrived = 0;
    std::thread change([&] {
        std::ifstream pipe(out, std::ios::binary); // waits for the writer
        std::ofstream(in, std::ios::app).put('x');
        while (pipe.get() != EOF)
            ++arrived;
    });
    const Ran ran = run(make_fill_command(), {in, out});
    close(open(out.c_str(), O_RDWR)); // where there was no writer
    change.join();
    EXPECT_EQ(ran.code, exit_resources);
    EXPECT_EQ(ran.err, "ddt: \"" + in + "\" was changed while it was read\n");
    EXPECT_GT(arrived, size_t(1) << 19);
}

TEST(FillCommand, FormatsWithoutWindowsGetTheDisplayWindow) {
    ImageSpec spec(10, 6, 1, OIIO::TypeFloat);
    spec.x = -2;
    spec.y = 3;
    spec.full_width = 16;
    spec.full_height = 12;
    ImageBuf image(spec);
    OIIO::ImageBufAlgo::fill(image, {1.0f});
    const std::string in = temporary("windows.exr"), out = temporary("windows.png");
    ASSERT_TRUE(image.write(in));
    ASSERT_EQ(make_fill_command()->run({in, out}), exit_done);
    ImageBuf filled(out);
    EXPECT_EQ(filled.spec().width, 16);
    EXPECT_EQ(filled.spec().height, 12);
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 16; ++x)
            EXPECT_EQ(filled.getchannel(x, y, 0, 0), x < 8 && y >= 3 && y < 9 ? 1.0f : 0.0f)
                << x << " " << y;
}

/// Noise with a hole, as it is filled into a PNG. Its display window is larger than its data window
/// by a margin; it has depth, for which a PNG has no room, or not.
std::string filled_noise(int margin, bool has_depth) {
    ImageSpec spec(12, 9, has_depth ? 5 : 4, OIIO::TypeFloat);
    spec.channelnames = {"R", "G", "B", "A"};
    if (has_depth)
        spec.channelnames.emplace_back("Z");
    spec.alpha_channel = 3;
    spec.z_channel = has_depth ? 4 : -1;
    spec.x = spec.y = margin;
    spec.full_width = spec.width + 2 * margin;
    spec.full_height = spec.height + 2 * margin;
    ImageBuf image(spec);
    OIIO::ImageBufAlgo::noise(image, "uniform", 0.1f, 1.0f);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (int x = 4; x < 7; ++x)
        image.setpixel(margin + x, margin + 4, std::vector<float>(size_t(spec.nchannels), nan));
    const std::string name = "noise" + std::to_string(margin) + (has_depth ? "_depth" : "");
    const std::string in = temporary(name + ".exr"), out = temporary(name + ".png");
    EXPECT_TRUE(image.write(in)) << image.geterror();
    const Ran ran = run(make_fill_command(), {in, out});
    EXPECT_EQ(ran.code, exit_done);
    EXPECT_EQ(ran.err, has_depth ? "ddt: \"" + out + "\" has no room for Z\n" : "");
    return out;
}

TEST(FillCommand, OfMoreChannelsThanAFormatHasTheFirstStayInTheirPlaces) {
    for (const int margin : {0, 3}) {
        const ImageBuf filled = load(filled_noise(margin, true)),
                       wanted = load(filled_noise(margin, false));
        ASSERT_EQ(filled.spec().roi(), wanted.spec().roi());
        EXPECT_EQ(filled.spec().width, 12 + 2 * margin);
        ASSERT_EQ(filled.nchannels(), 4);
        EXPECT_GT(filled.getchannel(margin + 5, margin + 4, 0, 1), 0) << "nothing is filled";
        for (int y = 0; y < filled.spec().height; ++y)
            for (int x = 0; x < filled.spec().width; ++x)
                for (int c = 0; c < 4; ++c)
                    EXPECT_EQ(filled.getchannel(x, y, 0, c), wanted.getchannel(x, y, 0, c))
                        << margin << ": " << x << " " << y << " " << c;
    }
}

TEST(FillCommand, OfADisplayWindowForWhichThereIsNoMemoryThereIsNone) {
    ImageSpec spec(10, 6, 1, OIIO::TypeFloat);
    spec.full_width = spec.full_height = 1 << 20;
    ImageBuf image(spec);
    OIIO::ImageBufAlgo::fill(image, {1.0f});
    const std::string in = temporary("huge_display.exr");
    ASSERT_TRUE(image.write(in)) << image.geterror();
    const Ran ran = run(make_fill_command(), {in, temporary("huge_display.png")});
    EXPECT_EQ(ran.code, exit_resources);
    EXPECT_NE(ran.err.find("1048576 x 1048576 pixels"), std::string::npos) << ran.err;
    EXPECT_NE(ran.err.find("allowed are"), std::string::npos) << ran.err;
    for (const auto& there : std::filesystem::directory_iterator(temporary("")))
        EXPECT_EQ(there.path().filename().string().find(".huge_display"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(temporary("huge_display.png")));
    EXPECT_EQ(make_fill_command()->run({in, temporary("huge_display_filled.exr")}), exit_done);
}

/// Numbers of a file as it has them.
std::vector<uint16_t> numbers_of(const std::string& path) {
    ImageSpec asked;
    asked.attribute("oiio:UnassociatedAlpha", 1);
    const auto in = OIIO::ImageInput::open(path, &asked);
    std::vector<uint16_t> numbers(in->spec().image_pixels() * size_t(in->spec().nchannels));
    EXPECT_TRUE(in->read_image(0, 0, 0, -1, OIIO::TypeUInt16, numbers.data()));
    return numbers;
}

/// Readers multiply by alpha in whole numbers: what is there keeps those of the file.
TEST(FillCommand, WhatIsThereKeepsUnassociatedNumbers) {
    constexpr int side = 24;
    for (const char* name : {"straight.png", "straight.tif", "straight.tga"}) {
        ImageSpec spec(side, side, 4, OIIO::TypeUInt8);
        spec.attribute("oiio:UnassociatedAlpha", 1);
        ImageBuf image(spec);
        OIIO::ImageBufAlgo::noise(image, "uniform", 0.05f, 1.0f);
        const auto is_missing = [](int x, int y) { return x >= 9 && x < 14 && y >= 6 && y < 12; };
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                if (is_missing(x, y))
                    image.setpixel(x, y, {0, 0, 0, 0});
        const std::string in = temporary(name), out = temporary(std::string("filled_") + name);
        ASSERT_TRUE(image.write(in)) << image.geterror();
        ASSERT_EQ(parse_and_run(*make_fill_command(), {in, out, "--missing", "alpha"}), exit_done);
        const std::vector<uint16_t> before = numbers_of(in), after = numbers_of(out);
        ASSERT_EQ(after.size(), before.size());
        for (size_t i = 0; i < before.size(); ++i) {
            const int x = int(i / 4) % side, y = int(i / 4) / side;
            if (is_missing(x, y))
                EXPECT_GT(after[i], 0) << name << " " << x << " " << y;
            else
                ASSERT_EQ(after[i], before[i]) << name << " " << x << " " << y;
        }
        EXPECT_EQ(OIIO::ImageInput::open(out)->spec().get_int_attribute("tiff:UnassociatedAlpha"),
                  OIIO::ImageInput::open(in)->spec().get_int_attribute("tiff:UnassociatedAlpha"));
    }
}

TEST(FillCommand, SaysWhichObjectNumbersAreLost) {
    ImageSpec spec(8, 8, 1, OIIO::TypeUInt32);
    spec.channelnames = {"id"};
    ImageBuf image(spec);
    OIIO::ImageBufAlgo::zero(image);
    const std::string in = temporary("ids.exr"), out = temporary("ids.png");
    ASSERT_TRUE(image.write(in)) << image.geterror();
    testing::internal::CaptureStderr();
    EXPECT_EQ(parse_and_run(*make_fill_command(), {in, out}), exit_done);
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "ddt: \"" + out + "\" is written as uint8, which object IDs do not survive: id\n");
}

} // namespace
} // namespace ddt::tool
