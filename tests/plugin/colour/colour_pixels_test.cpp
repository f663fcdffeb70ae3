// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "plugin/colour/colour_pixels.h"
#include "plugin/colour/space_light.h"
#include "tests/core/plain.h"
#include "tests/plugin/images.h"

namespace {

using images::value;

ddt::ColourLayout rgba() {
    ddt::ColourLayout layout;
    layout.count = 3;
    for (int c = 0; c < 3; ++c)
        layout.channel[c] = c;
    layout.alpha = 3;
    return layout;
}

std::shared_ptr<const ddt::Light> srgb() {
    std::string error;
    return ddt::find_light("auto", "sRGB", error);
}

OIIO::ImageBuf srgb_image(int size, OIIO::TypeDesc type = OIIO::TypeFloat) {
    auto image = images::make(size, size, 4, type);
    image.specmod().attribute("oiio:ColorSpace", "sRGB");
    return image;
}

TEST(Alpha, ColourIsDividedForTheConversion) {
    float pixel[4] = {0.25f, 0.1f, 0, 0.5f};
    ddt::to_light(*srgb(), rgba(), pixel, 1, 4);
    EXPECT_NEAR(pixel[0], 0.5f * 0.2140411f, 1e-6f);
    EXPECT_NEAR(pixel[1], 0.5f * 0.0331048f, 1e-6f);
    EXPECT_EQ(pixel[2], 0.0f);
    EXPECT_EQ(pixel[3], 0.5f);
}

TEST(Alpha, EverythingComesBack) {
    for (const float alpha : {0.0f, 1e-30f, 1e-3f, 0.5f, 1.0f, 2.0f, -0.5f, INFINITY})
        for (const float scale : {0.0f, 1e-6f, 0.2f, 0.9f, 1.0f, 3.0f}) {
            const float before[4] = {scale, 0.7f * scale, 0.1f * scale, alpha};
            float pixel[4];
            std::copy(before, before + 4, pixel);
            ddt::to_light(*srgb(), rgba(), pixel, 1, 4);
            ddt::from_light(*srgb(), rgba(), pixel, 1, 4);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(pixel[c], before[c], 3e-6f * scale) << alpha << " " << scale;
        }
}

// As a filter that rings leaves it round a matte.
TEST(Alpha, NegativeColourStaysWhatItWas) {
    auto src = srgb_image(8);
    const float beside[][4] = {{-0.01f, -0.01f, -0.01f, 1e-3f},
                               {-0.01f, -0.01f, -0.01f, 1e-4f},
                               {6e-8f, -0.1f, 0, 0},
                               {-0.1f, -0.1f, -0.1f, 1e-25f}};
    for (const auto& right : beside) {
        images::fill(src, [&](int x, int, int c) { return x < 4 ? c == 3 ? 1 : 0.5f : right[c]; });
        const auto dst = images::enlarged(src, 64, 64);
        for (int x = 0; x < 64; ++x)
            for (int c = 0; c < 3; ++c) {
                EXPECT_GE(value(dst, x, 30, c), -0.1f - 1e-5f) << x;
                EXPECT_LE(value(dst, x, 30, c), 0.5f + 1e-5f) << x;
            }
    }
}

/// 0 and 1 are not 0 and 1 in the light of a logarithmic encoding.
ddt::Light logarithmic() {
    const auto each = [](auto f) {
        return [f](float* rgb, size_t count) {
            for (size_t i = 0; i < 3 * count; ++i)
                rgb[i] = f(rgb[i]);
        };
    };
    return ddt::Light::whole(each([](float v) { return std::exp2(16 * v - 9); }),
                             each([](float v) { return (std::log2(std::max(v, 1e-9f)) + 9) / 16; }),
                             {0.2f, 0.7f, 0.1f});
}

TEST(Alpha, LogarithmicColourIsNotDividedByIt) {
    const ddt::Light light = logarithmic();
    ASSERT_FALSE(light.keeps_unit());
    // Colour 0.4 at alpha 0.01 would be 40, far beyond all numbers.
    float pixel[4] = {0.4f, 0.07f, 0.3f, 0.01f};
    ddt::to_light(light, rgba(), pixel, 1, 4);
    EXPECT_NEAR(pixel[0], std::exp2(16 * 0.4f - 9), 1e-5f);
    ddt::from_light(light, rgba(), pixel, 1, 4);
    EXPECT_NEAR(pixel[0], 0.4f, 1e-5f);
    EXPECT_NEAR(pixel[1], 0.07f, 1e-5f);
}

TEST(Alpha, GlowSurvivesEnlarging) {
    auto src = srgb_image(8);
    images::fill(src, [](int x, int y, int c) {
        return c == 3 ? 0.0f : (x >= 2 && x < 6 && y >= 2 && y < 6 ? 0.5f : 0.0f);
    });
    const auto dst = images::enlarged(src, 32, 32);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(value(dst, 15, 15, c), 0.5f, 1e-5f);
    EXPECT_EQ(value(dst, 15, 15, 3), 0.0f);
    EXPECT_EQ(value(dst, 0, 0, 0), 0.0f);
}

TEST(Alpha, ABadNumberSpoilsNoOtherChannel) {
    for (const float bad : {std::nanf(""), INFINITY, -INFINITY})
        for (int spoilt = 0; spoilt < 3; ++spoilt) {
            auto src = srgb_image(8);
            images::fill(src, [&](int x, int y, int c) {
                return c == 3 ? 0.01f : c == spoilt && x == 4 && y == 4 ? bad : 0.5f;
            });
            const auto dst = images::enlarged(src, 16, 16);
            for (int i = 0; i < 256; ++i)
                for (const int c : {(spoilt + 1) % 3, (spoilt + 2) % 3})
                    ASSERT_NEAR(value(dst, i % 16, i / 16, c), 0.5f, 1e-5f)
                        << bad << " in " << spoilt << " at " << i;
        }
}

TEST(Alpha, OneColourKeepsItUnderAnyAlpha) {
    auto src = srgb_image(16);
    const float colour[3] = {0.8f, 0.4f, 0.1f};
    images::fill(src, [&](int x, int y, int c) {
        const float alpha = images::disc(x, y, 16);
        return c == 3 ? alpha : alpha * colour[c];
    });
    // On planes: a patch's slopes are no linear function of the values.
    ddt::Options options;
    options.surface = ddt::test::plain_surface(ddt::Surface::linear);
    const auto dst = images::enlarged(src, 61, 61, options);
    for (int y = 0; y < 61; ++y)
        for (int x = 0; x < 61; ++x)
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(value(dst, x, y, c), value(dst, x, y, 3) * colour[c], 2e-6f);
}

TEST(Alpha, FullAlphaIsLikeNone) {
    auto with = srgb_image(16);
    auto without = images::make(16, 16, 3);
    without.specmod().attribute("oiio:ColorSpace", "sRGB");
    const auto picture = [](int x, int y, int c) {
        return c == 3 ? 1.0f : images::disc(x + c, y, 16);
    };
    images::fill(with, picture);
    images::fill(without, picture);
    const auto a = images::enlarged(with, 50, 50), b = images::enlarged(without, 50, 50);
    for (int y = 0; y < 50; ++y)
        for (int x = 0; x < 50; ++x)
            for (int c = 0; c < 3; ++c)
                ASSERT_EQ(value(a, x, y, c), value(b, x, y, c));
}

// Black on nothing has no edge in its colour; the mesh must follow the one in its alpha. Along a
// slope of 1/3 a mesh that does not know it makes steps.
TEST(Alpha, MeshSeesItsEdges) {
    auto alone = srgb_image(24), beside = srgb_image(24);
    const auto shape = [](int x, int y) { return 3 * y > x + 20 ? 1.0f : 0.0f; };
    images::fill(alone, [&](int x, int y, int c) { return c == 3 ? shape(x, y) : 0.0f; });
    images::fill(beside, [&](int x, int y, int c) { return c == 3 ? 1.0f : shape(x, y); });
    ddt::Options options;
    options.surface.soft = 0; // how nearly an edge flipped depends on the guide's contrast
    const auto a = images::enlarged(alone, 96, 96, options);
    options.light = "encoded";
    const auto reference = images::enlarged(beside, 96, 96, options);
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 96; ++x)
            ASSERT_NEAR(value(a, x, y, 3), value(reference, x, y, 0), 1e-5f) << x << " " << y;
}

} // namespace
