// SPDX-License-Identifier: Apache-2.0
#include <fstream>

#include <OpenImageIO/imagebufalgo.h>
#include <gtest/gtest.h>

#include "plugin/tool/commands.h"
#include "tests/plugin/tool/run_command.h"
#include "tests/plugin/tool/several_types.h"
#include "tests/temporary.h"

namespace ddt::tool {
namespace {

using OIIO::ImageBuf;
using OIIO::ImageSpec;

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

} // namespace
} // namespace ddt::tool
