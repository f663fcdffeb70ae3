// SPDX-License-Identifier: Apache-2.0
// What ddt mesh --height lifts vertices by, in the files that it writes.
#include <algorithm>
#include <cmath>
#include <vector>

#include <OpenImageIO/imagebufalgo.h>
#include <gtest/gtest.h>

#include "plugin/tool/commands.h"
#include "plugin/tool/points/point_file.h"
#include "tests/plugin/tool/run_command.h"
#include "tests/temporary.h"

namespace ddt::tool {
namespace {

using OIIO::ImageBuf;
using OIIO::ImageSpec;

/// Two rows of an image with these numbers, `channels` a pixel, in a file.
std::string write_rows(const char* name, ImageSpec spec, const std::vector<float>& numbers) {
    spec.width = spec.full_width = int(numbers.size()) / spec.nchannels;
    spec.height = spec.full_height = 2;
    std::vector<float> both = numbers;
    both.insert(both.end(), numbers.begin(), numbers.end());
    const std::string path = temporary(name);
    const auto file = OIIO::ImageOutput::create(path);
    EXPECT_TRUE(file && file->open(path, spec) && file->write_image(OIIO::TypeFloat, both.data()) &&
                file->close())
        << name;
    return path;
}

/// The z of the upper row's vertices in the mesh of an image.
std::vector<double> lifted(const std::string& in, const char* height,
                           const std::string& filter = "ddt") {
    const std::string out = temporary("lifted.ply");
    const Ran ran = run(make_mesh_command(), {in, out, "--height", height, "--filter", filter});
    EXPECT_EQ(ran.code, exit_done) << ran.err;
    PointFile mesh;
    Failure failure;
    EXPECT_TRUE(read_points(out, mesh, failure)) << failure.why;
    std::vector<double> z = mesh.find("z")->values;
    z.resize(z.size() / 2);
    return z;
}

TEST(Heights, OfOneChannelAreItsOwnNumbers) {
    for (const char* name : {"Y", "Z", "height", "A"}) {
        ImageSpec spec(1, 1, 1, OIIO::TypeFloat);
        spec.channelnames = {name};
        const std::vector<float> metres{-120, 0, 300.125f, 2500, 8848.86f, NAN};
        const std::vector<double> z = lifted(write_rows("terrain.exr", spec, metres), "1");
        for (size_t i = 0; i < 5; ++i)
            EXPECT_EQ(z[i], double(metres[i])) << name;
        EXPECT_EQ(z[5], 0) << name;
    }
}

TEST(Heights, OfSixteenBitsKeepEveryLevel) {
    std::vector<float> levels;
    for (int v = 20000; v <= 20200; v += 2)
        levels.push_back(float(v) / 65535);
    const std::string in = write_rows("levels.png", ImageSpec(1, 1, 1, OIIO::TypeUInt16), levels);
    for (const char* filter : {"ddt", "ddt,light=encoded", "ddt,light=sRGB"}) {
        const std::vector<double> z = lifted(in, "65535", filter);
        for (size_t i = 0; i < levels.size(); ++i)
            EXPECT_NEAR(z[i], 20000 + 2 * double(i), 2e-3) << filter;
    }
}

TEST(Heights, OfColourAreItsLuminance) {
    const std::string in = write_rows("colours.exr", ImageSpec(1, 1, 3, OIIO::TypeFloat),
                                      {1, 1, 1, 1, 0, 0, 0, 1, 0, 0, 0, 2});
    const std::vector<double> z = lifted(in, "10"), wanted{10, 2.126, 7.152, 1.444};
    EXPECT_EQ(z[0], 10);
    for (size_t i = 1; i < 4; ++i)
        EXPECT_NEAR(z[i], wanted[i], 1e-5);
}

TEST(Heights, DoNotHangOnAlpha) {
    for (const char* name : {"clear.png", "clear.tif", "clear.tga"}) {
        ImageSpec spec(1, 1, 4, OIIO::TypeUInt8);
        spec.attribute("oiio:UnassociatedAlpha", 1);
        std::vector<float> white;
        for (const float alpha : {0.0f, 85.0f / 255, 170.0f / 255, 1.0f})
            white.insert(white.end(), {1, 1, 1, alpha});
        for (const double z : lifted(write_rows(name, spec, white), "100"))
            EXPECT_EQ(z, 100) << name;
    }
    // Associated colour is what the file has.
    const std::string in = write_rows("associated.exr", ImageSpec(1, 1, 4, OIIO::TypeFloat),
                                      {0.5f, 0.5f, 0.5f, 0.5f, 0.25f, 0.25f, 0.25f, 1});
    const std::vector<double> z = lifted(in, "4");
    EXPECT_NEAR(z[0], 2, 1e-6);
    EXPECT_NEAR(z[1], 1, 1e-6);
}

TEST(Heights, AreThoseOfFilledPixels) {
    const std::string in =
        write_rows("holed.exr", ImageSpec(1, 1, 1, OIIO::TypeFloat), {100, 100, NAN, 100, 100});
    EXPECT_EQ(lifted(in, "2")[2], 0);
    EXPECT_NEAR(lifted(in, "2", "ddt,holes=fill")[2], 200, 1e-3);
    ImageSpec spec(1, 1, 4, OIIO::TypeUInt8);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    std::vector<float> grey;
    for (int i = 0; i < 5; ++i)
        grey.insert(grey.end(), {0.2f, 0.2f, 0.2f, i == 2 ? 0.0f : 1.0f});
    std::fill_n(grey.begin() + 8, 3, 0.0f);
    const std::string clear = write_rows("holed.png", spec, grey);
    EXPECT_EQ(lifted(clear, "255")[2], 0);
    for (const double z : lifted(clear, "255", "ddt,holes=fill-alpha"))
        EXPECT_NEAR(z, 51, 0.51);
}

} // namespace
} // namespace ddt::tool
