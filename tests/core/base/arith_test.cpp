// SPDX-License-Identifier: Apache-2.0
#include "core/base/arith.h"
#include "core/base/float_mode.h"

#include <cfloat>
#include <cmath>

#include "tests/core/helpers.h"

namespace ddt::test {
namespace {

TEST(Arith, RsqrtIsAccurateOverTheWholeRange) {
    // All exponents with a spread of mantissas, both parities of the exponent.
    double worst = 0;
    for (uint32_t exponent = 1; exponent <= 254; ++exponent)
        for (uint32_t mantissa = 0; mantissa < 0x800000; mantissa += 26099) {
            const float x = float_of(exponent << 23 | mantissa);
            const double exact = 1.0 / std::sqrt(double(x));
            worst = std::max(worst, std::fabs(double(scalar::rsqrt<3>(x)) / exact - 1.0));
        }
    EXPECT_LT(worst, 2.5e-7);
}

TEST(Arith, RsqrtOfZeroIsFinite) {
    EXPECT_TRUE(std::isfinite(scalar::rsqrt<3>(0.0f)));
    EXPECT_GT(scalar::rsqrt<3>(0.0f), 0.0f);
    EXPECT_EQ(0.0f * scalar::rsqrt<3>(0.0f), 0.0f);
}

TEST(Arith, RsqrtHasTheseBits) {
    // Every device must give these.
    EXPECT_EQ(bits_of(scalar::rsqrt<3>(1.0f)), 0x3f7fffffu);
    EXPECT_EQ(bits_of(scalar::rsqrt<3>(0.04f)), 0x409fffffu);
    EXPECT_EQ(bits_of(scalar::rsqrt<3>(3.0f)), 0x3f13cd3au);
    EXPECT_EQ(bits_of(scalar::rsqrt<3>(0.0f)), 0x601ab3d4u);
}

TEST(Arith, DenormalsAreZeroWhileTheObjectLives) {
    volatile float smallest = FLT_MIN, half = 0.5f, denormal = float_of(1), large = 1e38f;
    EXPECT_NE(smallest * half, 0.0f);
    {
        const DenormalsAreZero zero;
        EXPECT_EQ(smallest * half, 0.0f);  // results
        EXPECT_EQ(denormal * large, 0.0f); // operands
        { const DenormalsAreZero nested; }
        EXPECT_EQ(smallest * half, 0.0f);
    }
    EXPECT_NE(smallest * half, 0.0f);
    EXPECT_NE(denormal * large, 0.0f);
}

} // namespace
} // namespace ddt::test
