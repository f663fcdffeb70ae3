// SPDX-License-Identifier: Apache-2.0
// fill_holes().
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "ddt/points.h"
#include "tests/core/plain.h"

namespace ddt::test {
namespace {

/// An image of 0 and 1 with a slanting edge, and a hole across it: how much is wrong after filling.
double error_of_filling(const MeshOptions& options) {
    constexpr int width = 40, height = 30;
    std::vector<float> whole, image, guide;
    std::vector<uint8_t> missing;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            whole.push_back(2 * y > x + 9 ? 1.0f : 0.0f);
            missing.push_back(x >= 15 && x < 23 && y >= 8 && y < 18);
            image.push_back(missing.back() ? std::nanf("") : whole.back());
        }
    guide = image;
    std::string error;
    EXPECT_TRUE(fill_holes(image.data(), width, height, 1, nullptr, guide.data(), missing.data(),
                           options, &error))
        << error;
    double wrong = 0;
    for (size_t i = 0; i < image.size(); ++i) {
        EXPECT_TRUE(image[i] >= 0 && image[i] <= 1) << i;
        EXPECT_TRUE(missing[i] || image[i] == whole[i]);
        wrong += std::fabs(image[i] - whole[i]);
    }
    return wrong;
}

TEST(FillHoles, EdgesRunOnAcrossThem) {
    MeshOptions options;
    options.cost = Cost::dp;
    options.scheme = Scheme::look_ahead;
    options.min_gain = -1;
    MeshOptions without = options;
    without.scheme = Scheme::pixel;
    EXPECT_LT(error_of_filling(options), 0.6 * error_of_filling(without));
}

/// Fills an image whose pixels all differ where no triangle reaches, and looks whether every pixel
/// has the value of one of the nearest that are there.
void expect_nearest(const std::vector<uint8_t>& missing) {
    constexpr int width = 8, height = 6;
    std::vector<float> whole, image;
    for (int i = 0; i < width * height; ++i) {
        whole.push_back(float(i + 1) / 64);
        image.push_back(missing[size_t(i)] ? -9 : whole.back());
    }
    ASSERT_TRUE(fill_holes(image.data(), width, height, 1, nullptr, whole.data(), missing.data(),
                           plain_mesh()));
    // Counted in steps along rows and columns: core/fill/fill.cpp.
    const auto steps = [](int i, int k) {
        return std::abs(i % width - k % width) + std::abs(i / width - k / width);
    };
    for (int i = 0; i < width * height; ++i) {
        int least = width + height;
        bool is_one = false;
        for (int k = 0; k < width * height; ++k) {
            if (missing[size_t(k)] || steps(i, k) > least)
                continue;
            is_one = (is_one && steps(i, k) == least) || image[size_t(i)] == whole[size_t(k)];
            least = steps(i, k);
        }
        EXPECT_TRUE(is_one) << i % width << ' ' << i / width << ": " << image[size_t(i)];
    }
}

TEST(FillHoles, AtTheRimTakesTheNearestPixel) {
    std::vector<uint8_t> missing(8 * 6, 0);
    for (size_t i = 0; i < 8; ++i) // the upper row and a corner
        missing[i] = 1;
    missing[47] = 1;
    expect_nearest(missing);
    // One pixel, or one line of them in any direction, that is there.
    constexpr int lines[][3] = {{20, 1, 1}, {24, 1, 8}, {3, 8, 6},
                                {1, 9, 6},  {7, 7, 6},  {2, 10, 3}};
    for (const auto& [first, step, count] : lines) {
        SCOPED_TRACE(step);
        std::fill(missing.begin(), missing.end(), uint8_t(1));
        for (int i = 0; i < count; ++i)
            missing[size_t(first + i * step)] = 0;
        expect_nearest(missing);
    }
}

TEST(FillHoles, SizesThatCannotBe) {
    float pixel = 7;
    const uint8_t missing = 1;
    for (const auto& [width, height, channels] :
         {std::array{-5, 5, 1}, std::array{5, -5, 1}, std::array{1, 1, 0}}) {
        std::string error;
        EXPECT_FALSE(
            fill_holes(&pixel, width, height, channels, nullptr, &pixel, &missing, {}, &error));
        EXPECT_NE(error, "");
    }
    EXPECT_EQ(pixel, 7);
}

TEST(FillHoles, SaysWhatIsWrong) {
    std::vector<float> image(8 * 6, 0.5f), guide(8 * 6, 0.5f);
    const std::vector<uint8_t> missing(8 * 6, 1);
    std::string error;
    EXPECT_FALSE(
        fill_holes(image.data(), 8, 6, 1, nullptr, guide.data(), missing.data(), {}, &error));
    EXPECT_EQ(error, "ddt: no pixel is there to fill the others from");
    const Channel unknown = Channel(9);
    EXPECT_FALSE(
        fill_holes(image.data(), 8, 6, 1, &unknown, guide.data(), missing.data(), {}, &error));
    EXPECT_EQ(error, "ddt: channels must be blend, alpha or nearest");
    // Whether a mesh would be made or not.
    MeshOptions wrong;
    wrong.max_iterations = -5;
    for (const bool some : {false, true}) {
        std::vector<uint8_t> one(8 * 6, 0);
        one[20] = some;
        error.clear();
        EXPECT_FALSE(
            fill_holes(image.data(), 8, 6, 1, nullptr, guide.data(), one.data(), wrong, &error));
        EXPECT_NE(error.find("iterations"), std::string::npos) << error;
    }
}

} // namespace
} // namespace ddt::test
