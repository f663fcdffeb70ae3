// SPDX-License-Identifier: Apache-2.0
// Alpha of things of any colour: its edges are to be found whatever they cover.
#include <cmath>

#include "ddt/option_table.h"
#include "tests/plugin/images.h"

namespace {

using images::enlarged;
using images::make;
using images::value;

constexpr int side = 40, factor = 5;

/// How much of a pixel a wavy disc covers.
float cover(int x, int y) {
    constexpr int parts = 8;
    int inside = 0;
    for (int j = 0; j < parts; ++j)
        for (int i = 0; i < parts; ++i) {
            const double u = x + (i + 0.5) / parts - side / 2.0,
                         v = y + (j + 0.5) / parts - side / 2.0;
            inside += std::hypot(u, v) < 13 + 1.6 * std::sin(5 * std::atan2(v, u) + 0.3);
        }
    return float(inside) / (parts * parts);
}

/// Root of the mean square by which the alpha of a thing of this luminance differs from the same
/// numbers enlarged by themselves.
double difference(float luminance, const char* space, const ddt::Options& options) {
    auto thing = make(side, side, 4), alone = make(side, side, 1);
    images::fill(thing,
                 [&](int x, int y, int c) { return (c < 3 ? luminance : 1.0f) * cover(x, y); });
    images::fill(alone, [&](int x, int y, int) { return cover(x, y); });
    for (auto* image : {&thing, &alone})
        image->specmod().attribute("oiio:ColorSpace", space);
    const auto with = enlarged(thing, side * factor, side * factor, options),
               without = enlarged(alone, side * factor, side * factor, options);
    double sum = 0;
    for (int y = 0; y < side * factor; ++y)
        for (int x = 0; x < side * factor; ++x)
            sum += std::pow(value(with, x, y, 3) - value(without, x, y, 0), 2);
    return std::sqrt(sum) / (side * factor);
}

// Over a colour of its own in the guide (mid-grey: 0.027 at its own, 0.042 with corrections),
// things of that colour would have no outline, and a saw's teeth.
TEST(Mattes, AreAsCleanWhateverTheColour) {
    for (const char* space : {"Linear", "sRGB"})
        for (const float luminance :
             {0.0f, 0.02f, 0.1f, 0.18f, 0.214f, 0.3f, 0.5f, 0.7f, 1.0f, 4.0f})
            EXPECT_LT(difference(luminance, space, {}), 0.02) << space << " " << luminance;
}

TEST(Mattes, WithCorrectionsToo) {
    ddt::Options sharp;
    std::string error;
    ASSERT_TRUE(ddt::parse_filter("ddt-sharp", sharp, error)) << error;
    for (const float luminance : {0.0f, 0.18f, 0.214f, 1.0f})
        EXPECT_LT(difference(luminance, "Linear", sharp), 0.02) << luminance;
}

// Hosts hand over RGBA what oiiotool reads as RGB.
TEST(Mattes, WhatIsOpaqueHasTheBitsOfThatWithoutAlpha) {
    auto rgb = make(90, 70, 3), rgba = make(90, 70, 4);
    images::noise(rgb);
    images::fill(rgba, [&](int x, int y, int c) { return c < 3 ? value(rgb, x, y, c) : 1.0f; });
    for (const char* filter : {"ddt", "ddt-linear", "ddt-sharp"}) {
        ddt::Options options;
        std::string error;
        ASSERT_TRUE(ddt::parse_filter(filter, options, error)) << error;
        const auto with = enlarged(rgba, 270, 210, options),
                   without = enlarged(rgb, 270, 210, options);
        int differing = 0;
        for (int y = 0; y < 210; ++y)
            for (int x = 0; x < 270; ++x)
                for (int c = 0; c < 3; ++c)
                    differing += value(with, x, y, c) != value(without, x, y, c);
        EXPECT_EQ(differing, 0) << filter;
    }
}

} // namespace
