// SPDX-License-Identifier: Apache-2.0
// A host's numbers become floats and come back as OpenImageIO converts them.
#include "plugin/host/buffer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <OpenImageIO/imageio.h>

#include "core/base/half.h"

namespace {

using namespace ddt::host;
using ddt::float_of_half, ddt::half_of_float;
using OIIO::TypeDesc;

Buffer row_of(Sample sample, void* data, int width) {
    const auto size = ptrdiff_t(size_of(sample));
    return {data, size * width, size, size, {0, 0, width, 1}, sample};
}

template <class Code>
void all_codes(Sample sample, TypeDesc type) {
    std::vector<Code> codes;
    for (int c = std::numeric_limits<Code>::min(); c <= std::numeric_limits<Code>::max(); ++c)
        codes.push_back(Code(c));
    const int n = int(codes.size());
    std::vector<float> theirs(codes.size()), ours(codes.size());
    OIIO::convert_pixel_values(type, codes.data(), OIIO::TypeFloat, theirs.data(), n);
    load(row_of(sample, codes.data(), n), 0, 0, codes.size(), 1, ours.data());
    for (int i = 0; i < n; ++i)
        ASSERT_EQ(theirs[size_t(i)], ours[size_t(i)]) << int(codes[size_t(i)]);
    std::vector<Code> back(codes.size());
    store(row_of(sample, back.data(), n), 0, 0, codes.size(), 1, ours.data());
    if (is_unsigned(sample)) {
        EXPECT_EQ(back, codes);
    }
    std::vector<float> wild{-2, -1, -0.3f, 0, 0.2999f, 0.5f, 1, 7, 1e30f};
    std::vector<Code> a(wild.size()), b(wild.size());
    OIIO::convert_pixel_values(OIIO::TypeFloat, wild.data(), type, a.data(), int(wild.size()));
    store(row_of(sample, b.data(), int(wild.size())), 0, 0, wild.size(), 1, wild.data());
    EXPECT_EQ(a, b);
    const float nan = std::nanf("");
    store(row_of(sample, b.data(), 1), 0, 0, 1, 1, &nan);
    EXPECT_EQ(b[0], 0);
}

TEST(Buffer, NumbersConvertAsOpenImageIODoes) {
    all_codes<uint8_t>(Sample::uint8, TypeDesc::UINT8);
    all_codes<uint16_t>(Sample::uint16, TypeDesc::UINT16);
    all_codes<int8_t>(Sample::int8, TypeDesc::INT8);
    all_codes<int16_t>(Sample::int16, TypeDesc::INT16);
}

TEST(Buffer, EveryHalfComesBack) {
    for (uint32_t h = 0; h < 65536; ++h) {
        const float f = float_of_half(uint16_t(h));
        float theirs;
        const auto bits = uint16_t(h);
        OIIO::convert_pixel_values(TypeDesc::HALF, &bits, OIIO::TypeFloat, &theirs, 1);
        if (std::isnan(theirs)) {
            EXPECT_TRUE(std::isnan(f));
            EXPECT_TRUE(std::isnan(float_of_half(half_of_float(f))));
            continue;
        }
        ASSERT_EQ(std::memcmp(&f, &theirs, sizeof f), 0) << h;
        ASSERT_EQ(half_of_float(f), h);
        // Between this one and the next: to the nearest, of two to the even one.
        const float next = float_of_half(uint16_t(h + 1));
        if ((h & 0x7fffu) < 0x7bffu) {
            const float middle = 0.5f * (f + next);
            for (const float v :
                 {middle, std::nextafter(middle, f), std::nextafter(middle, next)}) {
                uint16_t nearest;
                OIIO::convert_pixel_values(OIIO::TypeFloat, &v, TypeDesc::HALF, &nearest, 1);
                ASSERT_EQ(half_of_float(v), nearest) << v;
            }
        }
    }
    EXPECT_EQ(half_of_float(1e6f), 0x7c00);
    EXPECT_EQ(half_of_float(-1e-9f), 0x8000);
}

TEST(Buffer, NumbersAsTheyAreSkipTheGaps) {
    std::vector<uint16_t> memory(4 * 6 * 5, 0xeeee), numbers(3 * 2), back(3 * 2);
    for (size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = uint16_t(0x7c01 + i); // that are no number
    // Rows upwards, four numbers a pixel, channels backwards from the third.
    const Buffer buffer{&memory[90], -60, 8, -2, {0, 0, 6, 4}, Sample::half};
    Buffer third = buffer;
    third.data = static_cast<char*>(buffer.data) + 4;
    store_numbers(third, 1, 1, 3, 2, numbers.data());
    load_numbers(third, 1, 1, 3, 2, back.data());
    EXPECT_EQ(back, numbers);
    EXPECT_EQ(size_t(std::count(memory.begin(), memory.end(), 0xeeee)), memory.size() - 6);
}

TEST(Buffer, RowsUpwardsAndGapsBetweenNumbers) {
    std::vector<uint8_t> memory(4 * 3 * 6);
    for (size_t i = 0; i < memory.size(); ++i)
        memory[i] = uint8_t(i);
    // Pixels of 4 bytes and 2 channels, the second 2 bytes after the first, rows upwards.
    const Buffer b{memory.data() + 2 * 24, -24, 4, 2, {10, 5, 16, 8}, Sample::uint8};
    float v[4];
    load(b, 11, 7, 2, 2, v);
    const uint8_t wanted[] = {4, 6, 8, 10};
    for (int i = 0; i < 4; ++i)
        EXPECT_EQ(v[i], float(wanted[i]) * (1.0f / 255));
    const float ones[] = {1, 1};
    store(b, 10, 5, 1, 2, ones);
    EXPECT_EQ(memory[48], 255);
    EXPECT_EQ(memory[49], 49);
    EXPECT_EQ(memory[50], 255);
}

} // namespace
