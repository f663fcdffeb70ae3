// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

#include "core/base/float_bits.h"
#include "core/guide/guide.h"
#include "tests/core/helpers.h"

namespace {

using ddt::bits_of;
using ddt::float_of;

double exact(double light) {
    return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

// Every mantissa the curve tells apart (it drops the low 7 bits) in every octave from 2^-30 up,
// with both neighbours of each step.
TEST(Guide, CurveIsCloseAndNeverFalls) {
    float before = -1;
    double worst = 0;
    for (uint32_t u = bits_of(0x1p-30f); u < bits_of(0x1p24f); u += 64) {
        const float x = float_of(u), v = ddt::srgb_curve(x);
        const double e = exact(double(x));
        worst = std::max(worst, std::fabs(v - e) / std::max(1.0, e));
        const float step = ddt::guide_step(v);
        ASSERT_GE(step, before) << x;
        before = step;
    }
    EXPECT_LT(worst, 1.0 / 65536);
}

TEST(Guide, CurveNeverFallsAtOctavesAndAtItsJoin) {
    std::vector<uint32_t> places{bits_of(0.0031308f)};
    for (uint32_t e = 100; e < 160; ++e)
        places.push_back(e << 23);
    for (const uint32_t place : places) {
        float before = 0;
        for (uint32_t u = place - 1000; u < place + 1000; ++u) {
            const float step = ddt::guide_step(ddt::srgb_curve(float_of(u)));
            ASSERT_GE(step, before) << float_of(u);
            before = step;
        }
    }
}

TEST(Guide, CurveIsOddAndFixesItsEnds) {
    for (const float x : {0.0f, 1e-6f, 0.003f, 0.2f, 1.0f, 7.5f, 3e38f})
        EXPECT_EQ(bits_of(ddt::srgb_curve(-x)), bits_of(-ddt::srgb_curve(x)));
    EXPECT_EQ(ddt::srgb_curve(0.0f), 0.0f);
    EXPECT_EQ(ddt::guide_step(ddt::srgb_curve(1.0f)), 1.0f);
}

TEST(Guide, StepsAreMultiplesWithinRange) {
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(ddt::guide_step(1.4f / 4096), 1.0f / 4096);
    EXPECT_EQ(ddt::guide_step(1.6f / 4096), 2.0f / 4096);
    EXPECT_EQ(ddt::guide_step(-1.6f / 4096), -2.0f / 4096);
    EXPECT_EQ(ddt::guide_step(1e30f), 1024.0f);
    EXPECT_EQ(ddt::guide_step(-1e30f), -1024.0f);
    EXPECT_EQ(ddt::guide_step(infinity), 0.0f);
    EXPECT_EQ(ddt::guide_step(-infinity), 0.0f);
    EXPECT_EQ(ddt::guide_step(std::nanf("")), 0.0f);
}

ddt::GuideRecipe rgba(bool linear) {
    ddt::GuideRecipe recipe;
    for (int c = 0; c < 3; ++c)
        recipe.channel[c] = c;
    recipe.weight[0] = 0.25f;
    recipe.weight[1] = 0.5f;
    recipe.weight[2] = 0.25f;
    recipe.alpha = 3;
    recipe.linear = linear;
    return recipe;
}

TEST(Guide, WhatIsCoveredDiffersFromNothingWhateverItsColour) {
    for (const bool linear : {true, false}) {
        const float nothing[4] = {};
        float none;
        ddt::make_guide(rgba(linear), nothing, 1, 4, &none);
        float before = none;
        for (int i = 0; i <= 800; ++i) {
            const float v = float(i) / 200; // to four times white
            const float whole[4] = {v, v, v, 1}, half[4] = {v / 2, v / 2, v / 2, 0.5f};
            float guide, between;
            ddt::make_guide(rgba(linear), whole, 1, 4, &guide);
            ddt::make_guide(rgba(linear), half, 1, 4, &between);
            EXPECT_GE(guide - none, 0.5f) << v;
            EXPECT_GE(between - none, 0.25f) << v;
            EXPECT_GE(guide - between, 0.25f) << v;
            EXPECT_GE(guide, before);
            before = guide;
        }
    }
}

TEST(Guide, OfWhatIsOpaqueIsThatWithoutAlpha) {
    ddt::test::Random random(6);
    for (const bool linear : {true, false}) {
        ddt::GuideRecipe rgb = rgba(linear);
        rgb.alpha = -1;
        for (int i = 0; i < 1000; ++i) {
            float pixel[4] = {0, 0, 0, i % 3 ? 1.0f : 7.0f};
            for (int c = 0; c < 3; ++c)
                pixel[c] = random.unit() * 3 - 1;
            if (i % 50 == 0)
                pixel[i % 3] = i % 100 ? std::nanf("") : std::numeric_limits<float>::infinity();
            float with, without;
            ddt::make_guide(rgba(linear), pixel, 1, 4, &with);
            ddt::make_guide(rgb, pixel, 1, 4, &without);
            EXPECT_EQ(with, without);
        }
    }
}

TEST(Guide, ValueThatIsNotFiniteCountsAsZero) {
    const float infinity = std::numeric_limits<float>::infinity();
    const float pixels[] = {infinity, 0, 0, 1, 0, std::nanf(""), 0, 1, 1, 1, 1, std::nanf("")};
    float guide[3];
    ddt::make_guide(rgba(true), pixels, 3, 4, guide);
    EXPECT_EQ(guide[0], 0.0f);
    EXPECT_EQ(guide[1], 0.0f);
    EXPECT_EQ(guide[2], 1.0f); // an alpha that is none hides nothing
}

TEST(Guide, NoChannelsGiveNothing) {
    const float pixels[] = {5, 6};
    float guide[2];
    ddt::make_guide({}, pixels, 2, 1, guide);
    EXPECT_EQ(guide[0], 0.0f);
    EXPECT_EQ(guide[1], 0.0f);
}

TEST(Guide, IsTheSameWhereverAPixelHasItsChannels) {
    constexpr size_t n = 700;
    ddt::test::Random random(5);
    std::vector<float> rgb;
    for (size_t i = 0; i < 3 * n; ++i)
        rgb.push_back(i % 97 ? random.unit() * 3 - 1 : -0.0f);
    const auto guide_of = [&](int first, int step, int stride) {
        std::vector<float> pixels(n * size_t(stride), 0.5f), guide(n);
        ddt::GuideRecipe recipe = rgba(true);
        recipe.alpha = -1;
        recipe.weight[2] = 0.125f;
        for (int c = 0; c < 3; ++c) {
            recipe.channel[c] = first + c * step;
            for (size_t i = 0; i < n; ++i)
                pixels[i * size_t(stride) + size_t(recipe.channel[c])] = rgb[3 * i + size_t(c)];
        }
        ddt::make_guide(recipe, pixels.data(), n, stride, guide.data());
        return guide;
    };
    const std::vector<float> any = guide_of(6, -2, 7);
    EXPECT_EQ(ddt::test::differing(guide_of(0, 1, 3), any), 0u);
    EXPECT_EQ(ddt::test::differing(guide_of(0, 1, 4), any), 0u);
    EXPECT_EQ(ddt::test::differing(guide_of(2, -1, 3), any), 0u);
}

// The curve's bits, fixed: another machine or compiler that finds others breaks the promise.
TEST(Guide, BitsOfTheCurve) {
    uint32_t hash = 2166136261u;
    for (uint32_t u = bits_of(0x1p-24f); u < bits_of(0x1p16f); u += 9973)
        hash = (hash ^ bits_of(ddt::srgb_curve(float_of(u)))) * 16777619u;
    EXPECT_EQ(hash, 765102593u);
}

} // namespace
