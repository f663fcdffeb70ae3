// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/pixels.h"

#include <cstring>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/float_bits.h"

namespace ddt::test {
namespace {

constexpr int width = 300, height = 90, channels = 3;
constexpr size_t numbers = size_t(width) * height * channels;

/// Memory of an image of halfs, with so many bytes between pixels.
struct Halfs {
    explicit Halfs(size_t gap)
        : bytes(numbers / channels * pixel(gap)),
          image(OIIO::ImageSpec(width, height, channels, OIIO::TypeHalf), bytes.data(),
                OIIO::stride_t(pixel(gap))) {}
    static size_t pixel(size_t gap) { return channels * sizeof(uint16_t) + gap; }

    std::vector<char> bytes;
    OIIO::ImageBuf image;
};

/// Gaps, and channels that are read or written.
struct Case {
    size_t gap;
    int chbegin, chend;
};
constexpr Case cases[] = {{0, 0, channels}, {0, 1, channels}, {4, 0, channels}, {2, 0, 1}};

TEST(Pixels, HalfsAreReadAsOpenImageIODoes) {
    for (const Case& c : cases) {
        Halfs halfs(c.gap);
        for (size_t i = 0; i + 1 < halfs.bytes.size(); i += 2) {
            const auto code = uint16_t(i / 2); // all there are
            std::memcpy(&halfs.bytes[i], &code, sizeof code);
        }
        const Rect part{7, 11, 290, 80};
        const int n = c.chend - c.chbegin;
        std::vector<float> read(part.area() * size_t(n)), expected(read.size());
        std::string error;
        ASSERT_TRUE(read_pixels(halfs.image, part, c.chbegin, c.chend, OIIO::TypeFloat, read.data(),
                                error));
        ASSERT_TRUE(
            halfs.image.get_pixels({part.x0, part.x1, part.y0, part.y1, 0, 1, c.chbegin, c.chend},
                                   OIIO::TypeFloat, expected.data()));
        EXPECT_EQ(std::memcmp(read.data(), expected.data(), read.size() * sizeof(float)), 0)
            << c.gap << ' ' << n;
    }
}

TEST(Pixels, HalfsAreWrittenAsOpenImageIODoes) {
    std::mt19937 random(3);
    for (const Case& c : cases) {
        Halfs halfs(c.gap), expected(c.gap);
        const Rect part{7, 11, 290, 80};
        const int n = c.chend - c.chbegin;
        std::vector<float> values(part.area() * size_t(n));
        for (float& v : values)
            v = float_of(uint32_t(random())); // of any size, and none
        ASSERT_TRUE(expected.image.set_pixels(
            {part.x0, part.x1, part.y0, part.y1, 0, 1, c.chbegin, c.chend}, OIIO::TypeFloat,
            values.data()));
        write_floats(halfs.image, part, c.chbegin, c.chend, values.data(), n);
        EXPECT_EQ(halfs.bytes, expected.bytes) << c.gap << ' ' << n;
    }
}

} // namespace
} // namespace ddt::test
