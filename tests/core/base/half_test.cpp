// SPDX-License-Identifier: Apache-2.0
#include "core/base/half.h"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/float_mode.h"
#include "tests/core/helpers.h"

namespace ddt::test {
namespace {

/// By its definition.
float float_of(int sign, int exponent, int mantissa) {
    const double size =
        exponent == 0 ? std::ldexp(mantissa, -24) : std::ldexp(1024 + mantissa, exponent - 25);
    return float(sign ? -size : size);
}

std::vector<uint16_t> all_halfs() {
    std::vector<uint16_t> halfs(65536);
    for (size_t i = 0; i < halfs.size(); ++i)
        halfs[i] = uint16_t(i);
    return halfs;
}

TEST(Half, FloatsAreWhatTheBitsSay) {
    for (int h = 0; h < 65536; ++h) {
        const int exponent = h >> 10 & 31, mantissa = h & 1023;
        const float f = float_of_half(uint16_t(h));
        EXPECT_EQ(std::signbit(f), h >> 15 != 0) << h;
        if (exponent < 31)
            EXPECT_EQ(f, float_of(h >> 15, exponent, mantissa)) << h;
        else if (mantissa == 0)
            EXPECT_TRUE(std::isinf(f)) << h;
        else
            EXPECT_TRUE(std::isnan(f)) << h;
        EXPECT_EQ(half_of_float(f), h);
    }
}

TEST(Half, TheNearestOfTwoTheEvenOne) {
    for (int h = 0; h < 0x7bff; ++h) {
        const float low = float_of_half(uint16_t(h)), high = float_of_half(uint16_t(h + 1));
        const float middle = 0.5f * (low + high); // exact
        const int even = h + (h & 1);
        EXPECT_EQ(half_of_float(middle), even);
        EXPECT_EQ(half_of_float(-middle), even | 0x8000);
        EXPECT_EQ(half_of_float(std::nextafter(middle, low)), h);
        EXPECT_EQ(half_of_float(std::nextafter(middle, high)), h + 1);
    }
    EXPECT_EQ(half_of_float(65519.996f), 0x7bff);
    EXPECT_EQ(half_of_float(65520.0f), 0x7c00);
    EXPECT_EQ(half_of_float(-INFINITY), 0xfc00);
    EXPECT_EQ(half_of_float(0x1p-149f), 0);
    EXPECT_EQ(half_of_float(-0x1p-149f), 0x8000);
}

TEST(Half, NanStaysNanWithWhatFitsOfItsPayload) {
    EXPECT_EQ(half_of_float(ddt::float_of(0x7fc00000u)), 0x7e00);
    EXPECT_EQ(half_of_float(ddt::float_of(0xffffe000u)), 0xffff);
    EXPECT_EQ(half_of_float(ddt::float_of(0x7f800001u)), 0x7c01) << "which must not be infinity";
}

TEST(Half, RowsAreTheSameOnEveryInstructionSet) {
    const std::vector<uint16_t> halfs = all_halfs();
    std::vector<float> floats;
    std::vector<uint16_t> back;
    std::mt19937 random(16);
    for (size_t i = 0; i < 1 << 18; ++i) {
        floats.push_back(ddt::float_of(uint32_t(random())));
        back.push_back(half_of_float(floats.back()));
    }
    on_each_target([&] {
        // Of every remainder that vectors leave.
        for (const size_t n : {halfs.size(), size_t(0), size_t(1), size_t(7), size_t(33)}) {
            std::vector<float> made(n);
            floats_of_halfs(halfs.data(), n, made.data());
            for (size_t i = 0; i < n; ++i)
                ASSERT_EQ(bits_of(made[i]), bits_of(float_of_half(halfs[i]))) << i;
            std::vector<uint16_t> rounded(n);
            halfs_of_floats(floats.data(), n, rounded.data());
            for (size_t i = 0; i < n; ++i)
                ASSERT_EQ(rounded[i], back[i]) << i;
        }
    });
}

TEST(Half, ProcessorsThatTakeDenormalFloatsForZeroMakeTheSame) {
    const DenormalsAreZero as_on_gpus;
    const std::vector<uint16_t> halfs = all_halfs();
    std::vector<float> floats(halfs.size());
    floats_of_halfs(halfs.data(), halfs.size(), floats.data());
    std::vector<uint16_t> back(halfs.size());
    halfs_of_floats(floats.data(), floats.size(), back.data());
    EXPECT_EQ(back, halfs);
}

} // namespace
} // namespace ddt::test
