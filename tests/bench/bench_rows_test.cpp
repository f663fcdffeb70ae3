// SPDX-License-Identifier: Apache-2.0
// The rows of the table start from the same picture and place it the same way.
#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "metrics/psnr.h"
#include "reference.h"
#include "rows.h"

using bench::Light;

// Pixel centres are at half integers: output pixel i shows the source at (i + 0.5) / scale - 0.5.
// A shift by half an output pixel would drown every difference between filters.
TEST(Rows, Siting) {
    constexpr int width = 32, height = 24;
    constexpr double step_x = 5, step_y = -3;
    metrics::Image ramp;
    for (metrics::Plane& plane : ramp.channels) {
        plane = metrics::Plane(width, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                plane.at(x, y) = 90 + step_x * x + step_y * y;
    }
    OIIO::ImageBuf input = bench::to_light(ramp, Light::encoded);
    for (const bench::Row& row : bench::all_rows(Light::encoded))
        for (int scale : {2, 3, 4}) {
            SCOPED_TRACE(row.name + " " + std::to_string(scale) + "x");
            OIIO::ImageBuf output = row.enlarge(input, scale);
            ASSERT_FALSE(output.has_error()) << output.geterror();
            metrics::Image large = bench::to_display(output, Light::encoded);
            ASSERT_EQ(large.width(), width * scale);
            // Away from the borders, where filters differ in what they do about the outside.
            int margin = 6 * scale;
            double along_x = 0, along_y = 0, count = 0;
            for (int y = margin; y < height * scale - margin; ++y)
                for (int x = margin; x < width * scale - margin; ++x, ++count) {
                    double u = (x + 0.5) / scale - 0.5, v = (y + 0.5) / scale - 0.5;
                    double error = large.channels[0].at(x, y) - (90 + step_x * u + step_y * v);
                    ASSERT_LT(std::abs(error), 1);
                    along_x += error / step_x;
                    along_y += error / step_y;
                }
            EXPECT_LT(std::abs(along_x / count), 0.01);
            EXPECT_LT(std::abs(along_y / count), 0.01);
        }
}

// What the project is for, on its own pictures: reduced and enlarged 4x in linear light, ddt comes
// closer to the original than each of the stock filters.
TEST(Rows, DdtComesClosest) {
    std::map<std::string, double> sums;
    for (const char* name : {"scene", "strokes", "lines"}) {
        metrics::Image original;
        std::string error;
        ASSERT_TRUE(bench::read_original(std::string(TESTIMAGES "/") + name + ".png", 4,
                                         Light::linear, original, error))
            << error;
        metrics::Image small = bench::reduced(original, 4, Light::linear, bench::Reduce::box);
        OIIO::ImageBuf input = bench::to_light(small, Light::linear);
        std::vector<bench::Row> rows = bench::oiio_rows();
        rows.push_back(bench::ddt_row("ddt", Light::linear));
        for (const bench::Row& row : rows)
            sums[row.name] += metrics::psnr(
                original, bench::stored(bench::to_display(row.enlarge(input, 4), Light::linear),
                                        Light::linear));
    }
    for (const auto& [name, sum] : sums)
        EXPECT_LE(sum, sums["ddt"]) << name;
}

TEST(Light, RoundTripBeyondTheUnitRange) {
    for (double v : {-0.5, 0.0, 0.002, 0.04, 0.5, 1.0, 3.0})
        EXPECT_NEAR(bench::encode_srgb(bench::decode_srgb(v)), v, 1e-7);
    for (double v : {-2.0, 0.0, 0.002, 1.0, 64.0, 4096.0})
        EXPECT_NEAR(bench::decode_log(bench::encode_log(v)), v, 1e-9 * (1 + std::abs(v)));
    EXPECT_EQ(bench::encode_log(63.9990234375), 255);
}

TEST(Reference, BoxMeansInEitherLight) {
    metrics::Image board;
    for (metrics::Plane& plane : board.channels) {
        plane = metrics::Plane(4, 4);
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 4; ++x)
                plane.at(x, y) = (x + y) % 2 ? 255 : 0;
    }
    auto centre = [&](Light light) {
        return bench::reduced(board, 2, light, bench::Reduce::box).channels[1].at(0, 0);
    };
    EXPECT_EQ(centre(Light::encoded), 128); // 127.5
    EXPECT_EQ(centre(Light::linear), 188);  // half the light of white
}

TEST(Reference, CubicKeepsAFlatImage) {
    metrics::Image flat{
        {metrics::Plane(20, 16, 77), metrics::Plane(20, 16, 140), metrics::Plane(20, 16, 3)}};
    metrics::Image small = bench::reduced(flat, 4, Light::linear, bench::Reduce::cubic);
    EXPECT_EQ(small.width(), 5);
    EXPECT_EQ(small.height(), 4);
    EXPECT_EQ(small.channels[1].at(2, 2), 140);
}

TEST(Reference, AlphaOverWhiteAndCropped) {
    metrics::Image image;
    std::string error;
    ASSERT_TRUE(bench::read_original(TESTIMAGES "/alpha.png", 5, Light::encoded, image, error))
        << error;
    EXPECT_EQ(image.width(), 110); // of 112
    EXPECT_EQ(image.height(), 95); // of 96
    EXPECT_EQ(image.channels[0].at(0, 0), 255);
    EXPECT_LT(image.channels[2].at(15, 30), image.channels[0].at(15, 30)); // a red disc
}

TEST(Reference, FloatingPointIsRefused) {
    metrics::Image image;
    std::string error;
    EXPECT_FALSE(bench::read_original(TESTIMAGES "/light.exr", 2, Light::linear, image, error));
    EXPECT_NE(error.find("floating point"), std::string::npos);
}

TEST(Reference, FilesOfAFolder) {
    std::vector<std::string> files = bench::image_files(TESTIMAGES);
    EXPECT_TRUE(std::is_sorted(files.begin(), files.end()));
    EXPECT_EQ(std::count(files.begin(), files.end(), std::string(TESTIMAGES "/scene.png")), 1);
    EXPECT_EQ(std::count(files.begin(), files.end(), std::string(TESTIMAGES "/CMakeLists.txt")), 0);
}
