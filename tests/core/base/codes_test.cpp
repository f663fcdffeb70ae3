// SPDX-License-Identifier: Apache-2.0
#include "core/base/codes.h"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/core/helpers.h"

namespace ddt::test {
namespace {

/// By its definition, in double precision.
template <class Code>
int defined(float v) {
    constexpr int most = std::numeric_limits<Code>::max();
    if (!(v > 0))
        return 0;
    // The product is a float.
    return v >= 1 ? most : int(std::floor(double(v * float(most)) + 0.5));
}

/// Of any size, and as many from 0 to 1.
std::vector<float> numbers() {
    std::mt19937 random(5);
    std::vector<float> all{0.0f, -0.0f, 1.0f, INFINITY, -INFINITY, std::nanf(""), -std::nanf("")};
    for (int i = 0; i < 1 << 17; ++i) {
        all.push_back(ddt::float_of(uint32_t(random())));
        all.push_back(float(random() % (1u << 24)) * 0x1p-24f);
    }
    return all;
}

TEST(Codes, TheMiddleGoesUpAndWhatIsJustBelowDoesNot) {
    EXPECT_EQ(code_of<uint8_t>(0.0019607842f), 0); // 0.49999997 of a code
    EXPECT_EQ(code_of<uint8_t>(0.5f), 128);        // 127.5
    EXPECT_EQ(code_of<uint16_t>(0.5f), 32768);
    EXPECT_EQ(code_of<uint8_t>(2.0f), 255);
    EXPECT_EQ(code_of<uint8_t>(-1.0f), 0);
    EXPECT_EQ(code_of<uint8_t>(std::nanf("")), 0);
    EXPECT_EQ(code_of<uint8_t>(-std::nanf("")), 0);
}

template <class Code>
void compare_rows() {
    const std::vector<float> floats = numbers();
    std::vector<Code> all;
    for (int code = 0; code <= std::numeric_limits<Code>::max(); ++code)
        all.push_back(Code(code));
    on_each_target([&] {
        // Of every remainder that vectors leave.
        for (const size_t n : {floats.size(), size_t(0), size_t(1), size_t(7), size_t(67)}) {
            std::vector<Code> codes(n);
            codes_of_floats(floats.data(), n, codes.data());
            for (size_t i = 0; i < n; ++i)
                ASSERT_EQ(codes[i], defined<Code>(floats[i])) << floats[i];
        }
        std::vector<float> back(all.size());
        floats_of_codes(all.data(), all.size(), back.data());
        for (size_t i = 0; i < all.size(); ++i)
            ASSERT_EQ(back[i], float_of_code(all[i]));
        std::vector<Code> again(all.size());
        codes_of_floats(back.data(), back.size(), again.data());
        EXPECT_EQ(again, all);
    });
}

TEST(Codes, RowsAreAsDefinedOnEveryInstructionSet) {
    compare_rows<uint8_t>();
    compare_rows<uint16_t>();
}

} // namespace
} // namespace ddt::test
