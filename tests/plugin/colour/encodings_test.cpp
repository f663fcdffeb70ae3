// SPDX-License-Identifier: Apache-2.0
#include "plugin/colour/encodings.h"

#include <cstdlib>
#include <cstring>
#include <random>

#include <gtest/gtest.h>

#include "plugin/colour/space_light.h"

namespace {

/// Numbers of all sizes that pictures have, and a few beyond the tables.
std::vector<float> numbers() {
    std::vector<float> all{0.0f, -0.0f, 1.0f, 0.04045f, 0.0031308f, 3e5f, -3e5f, 1e-30f, 0.5f};
    std::mt19937 random(7);
    for (int i = 0; i < 30000; ++i) {
        const float u = float(random() >> 8) * (1.0f / 16777216.0f);
        all.push_back(i % 3 == 0 ? u : std::ldexp(u - 0.5f, int(random() % 40) - 24));
    }
    return all;
}

TEST(Encodings, TheBitsOfOpenColorIO) {
    if (std::getenv("OCIO"))
        GTEST_SKIP() << "a config of the user's";
    for (const std::string& name : ddt::encoding_names()) {
        std::string error;
        const auto theirs = ddt::find_light(name, "", error);
        const auto ours = ddt::find_encoding(name);
        ASSERT_TRUE(theirs && ours) << name << error;
        EXPECT_EQ(theirs->converts(), ours->converts()) << name;
        EXPECT_EQ(theirs->luma(), ours->luma()) << name;
        EXPECT_EQ(theirs->keeps_unit(), ours->keeps_unit()) << name;
        if (!ours->converts())
            continue;
        auto a = numbers(), b = a;
        theirs->to_light_alike(a.data(), a.size());
        ours->to_light_alike(b.data(), b.size());
        EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(float)), 0) << name;
        a = b = numbers();
        theirs->from_light_alike(a.data(), a.size());
        ours->from_light_alike(b.data(), b.size());
        EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(float)), 0) << name;
    }
}

TEST(Encodings, NamesInAnyCase) {
    EXPECT_EQ(ddt::find_encoding("srgb"), ddt::find_encoding("sRGB"));
    EXPECT_EQ(ddt::find_encoding("sRGBx"), nullptr);
    EXPECT_EQ(ddt::find_encoding(""), nullptr);
}

} // namespace
