// SPDX-License-Identifier: Apache-2.0
// Each metric on cases whose value is known by hand.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "metrics/gmsd.h"
#include "metrics/overshoot.h"
#include "metrics/psnr.h"
#include "metrics/ssim.h"
#include "metrics/staircase.h"

using metrics::Image;
using metrics::Plane;

namespace {

Image flat(int width, int height, double r, double g, double b) {
    return {{Plane(width, height, r), Plane(width, height, g), Plane(width, height, b)}};
}

Plane transposed(const Plane& plane) {
    Plane other(plane.height, plane.width);
    for (int y = 0; y < plane.height; ++y)
        for (int x = 0; x < plane.width; ++x)
            other.at(y, x) = plane.at(x, y);
    return other;
}

Plane repeated(const Plane& plane, int scale) {
    Plane large(plane.width * scale, plane.height * scale);
    for (int y = 0; y < large.height; ++y)
        for (int x = 0; x < large.width; ++x)
            large.at(x, y) = plane.at(x / scale, y / scale);
    return large;
}

Plane stripes(int size, double even, double odd) {
    Plane plane(size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            plane.at(x, y) = x % 2 ? odd : even;
    return plane;
}

} // namespace

TEST(Image, LumaOfPrimaries) {
    EXPECT_DOUBLE_EQ(luma(flat(1, 1, 255, 0, 0)).at(0, 0), 76.245);
    EXPECT_DOUBLE_EQ(luma(flat(1, 1, 200, 200, 200)).at(0, 0), 200);
}

TEST(Image, BorderIsCutOnAllSides) {
    Plane plane(5, 4);
    plane.at(2, 1) = 7;
    Plane inner = without_border(plane, 1);
    EXPECT_EQ(inner.width, 3);
    EXPECT_EQ(inner.height, 2);
    EXPECT_EQ(inner.at(1, 0), 7);
    EXPECT_TRUE(without_border(plane, 2).empty());
}

TEST(Psnr, OneLevelEverywhere) {
    EXPECT_NEAR(psnr(flat(4, 4, 10, 10, 10), flat(4, 4, 11, 9, 11)), 48.1308, 1e-4);
}

TEST(Psnr, ChannelsCountAlike) {
    // Squared error 9 in one of three channels: mse 3.
    EXPECT_NEAR(psnr(flat(4, 4, 10, 10, 10), flat(4, 4, 10, 13, 10)), 43.3596, 1e-4);
}

TEST(Psnr, EqualImages) {
    EXPECT_TRUE(std::isinf(psnr(flat(2, 2, 1, 2, 3), flat(2, 2, 1, 2, 3))));
}

TEST(Ssim, EqualPlanes) {
    EXPECT_NEAR(ssim(stripes(20, 10, 200), stripes(20, 10, 200)), 1, 1e-12);
}

TEST(Ssim, FlatPlanesDifferInLuminanceAlone) {
    // (2 100 120 + c1) / (100^2 + 120^2 + c1), c1 = 6.5025
    EXPECT_NEAR(ssim(Plane(16, 16, 100), Plane(16, 16, 120)), 0.983611, 1e-6);
}

TEST(Ssim, StripesOnAFlatPlane) {
    // Variances 0 and 100: c2 / (100 + c2), c2 = 58.5225. The window hardly sees single columns.
    EXPECT_NEAR(ssim(Plane(16, 16, 128), stripes(16, 118, 138)), 0.36917, 1e-4);
}

TEST(Ssim, InvertedStripesAreNegative) {
    // Covariance -100: (-200 + c2) / (200 + c2)
    EXPECT_NEAR(ssim(stripes(16, 118, 138), stripes(16, 138, 118)), -0.547277, 1e-4);
}

TEST(Ssim, TheWindowIsNoLargerThanThePlane) {
    for (const int side : {1, 2, 7, 10}) {
        const Plane light = stripes(side, 120, 140), dark = stripes(side, 100, 110);
        EXPECT_NEAR(ssim(light, light), 1, 1e-12) << side;
        EXPECT_NEAR(ms_ssim(light, light), 1, 1e-12) << side;
        EXPECT_LT(ssim(light, dark), 0.99) << side;
        EXPECT_LT(ms_ssim(light, dark), 0.99) << side;
    }
    EXPECT_NEAR(ssim(Plane(3, 30, 100), Plane(3, 30, 120)), 0.983611, 1e-6);
}

TEST(MsSsim, FlatPlanesCountLuminanceOnlyAtTheLastScale) {
    double all_scales = std::pow(0.983611, 0.1333 / 1.0001);
    EXPECT_NEAR(ms_ssim(Plane(176, 176, 100), Plane(176, 176, 120)), all_scales, 1e-6);
    // Two scales fit into 30 pixels; weights 0.0448 and 0.2856.
    double two_scales = std::pow(0.983611, 0.2856 / 0.3304);
    EXPECT_NEAR(ms_ssim(Plane(30, 30, 100), Plane(30, 30, 120)), two_scales, 1e-6);
}

TEST(MsSsim, StripesVanishInTheSecondScale) {
    double first = 0.36917, weights = 1.0001;
    EXPECT_NEAR(ms_ssim(Plane(176, 176, 128), stripes(176, 118, 138)),
                std::pow(first, 0.0448 / weights), 1e-4);
}

TEST(Gmsd, EqualPlanes) {
    EXPECT_EQ(gmsd(stripes(16, 0, 255), stripes(16, 0, 255)), 0);
}

TEST(Gmsd, AStepThatOnlyOneHas) {
    // Halved to 12 columns with a step of 255 in the middle: of 10 inner columns two have the
    // gradient 255, so the similarity is c / (255^2 + c) there and 1 elsewhere.
    Plane step(24, 24);
    for (int y = 0; y < 24; ++y)
        for (int x = 12; x < 24; ++x)
            step.at(x, y) = 255;
    double similarity = 170 / (255.0 * 255.0 + 170);
    const double expected = std::sqrt(0.2 * 0.8) * (1 - similarity);
    EXPECT_NEAR(gmsd(Plane(24, 24, 0), step), expected, 1e-12);
    EXPECT_NEAR(gmsd(Plane(24, 24, 0), transposed(step)), expected, 1e-12);
}

TEST(Overshoot, CountsOnlyWhatLeavesTheRangeNearby) {
    Image small = flat(6, 6, 10, 10, 10);
    for (Plane& plane : small.channels)
        plane.at(1, 1) = 50;
    Image large = flat(12, 12, 10, 10, 10);
    large.channels[0].at(4, 4) = 50;  // beside the bright pixel: allowed
    large.channels[0].at(7, 7) = 16;  // out of its reach: 6 too much
    large.channels[1].at(0, 11) = -2; // 12 too little, and negative
    metrics::Overshoot found = overshoot(small, large, 2);
    EXPECT_DOUBLE_EQ(found.largest, 12);
    EXPECT_DOUBLE_EQ(found.mean, 18.0 / (3 * 144));
    EXPECT_DOUBLE_EQ(found.negative_share, 1.0 / (3 * 144));
}

TEST(Staircase, AStraightRampHasNone) {
    constexpr double angle = 0.4, scale = 3;
    auto paint = [&](const Plane& small) {
        Plane large(small.width * int(scale), small.height * int(scale));
        for (int y = 0; y < large.height; ++y)
            for (int x = 0; x < large.width; ++x)
                large.at(x, y) =
                    128 + (y + 0.5 - 72) * std::cos(angle) - (x + 0.5 - 72) * std::sin(angle);
        return large;
    };
    EXPECT_NEAR(metrics::staircase_at(paint, int(scale), angle), 0, 1e-9);
}

TEST(Staircase, RepeatedPixels) {
    constexpr int scale = 8;
    auto repeat = [](const Plane& small) { return repeated(small, scale); };
    EXPECT_NEAR(metrics::staircase_at(repeat, scale, 0), 0, 1e-9);
    // At 45 degrees the outline is a true staircase with steps of one pixel: its distance from the
    // line is spread evenly over 1 / sqrt 2, so its deviation is that over sqrt 12.
    EXPECT_NEAR(metrics::staircase_at(repeat, scale, std::atan(1)), std::sqrt(0.5 / 12), 0.02);
}

TEST(Staircase, PixelsOfTheEdgeAreMixedByTheShareThatEachSideCovers) {
    const double tilt = std::atan(1) / 2; // neither along the pixels nor at 45 degrees
    for (const double angle : {0.0, tilt, 3 * tilt, 5 * tilt}) {
        auto look = [&](const Plane& small) {
            // Points close together tell on which side of the line through them they lie.
            const double across = 24.137, down = 23.789;
            for (int y = 12; y < 36; ++y)
                for (int x = 12; x < 36; ++x) {
                    double sum = 0;
                    for (int i = 0; i < 64 * 64; ++i) {
                        const double u = x + (i % 64 + 0.5) / 64 - across,
                                     v = y + (double(i / 64) + 0.5) / 64 - down;
                        sum += v * std::cos(angle) < u * std::sin(angle) ? 64 : 192;
                    }
                    EXPECT_NEAR(small.at(x, y), sum / (64 * 64), 2)
                        << angle << ' ' << x << ' ' << y;
                }
            return repeated(small, 2);
        };
        metrics::staircase_at(look, 2, angle);
    }
}

TEST(Staircase, IsTheMeanAndTheWorstOverAHalfTurn) {
    auto repeat = [](const Plane& small) { return repeated(small, 4); };
    double sum = 0, most = 0;
    for (int i = 0; i < 60; ++i) {
        const double one = metrics::staircase_at(repeat, 4, i * std::atan(1) / 15);
        sum += one;
        most = std::max(most, one);
    }
    EXPECT_NEAR(metrics::staircase(repeat, 4).mean, sum / 60, 1e-6);
    EXPECT_NEAR(metrics::staircase(repeat, 4).worst, most, 1e-6);
}
