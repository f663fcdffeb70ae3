// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/pixels.h"

#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/float_bits.h"

namespace ddt::test {
namespace {

constexpr int width = 300, height = 90, channels = 3;
constexpr size_t numbers = size_t(width) * height * channels;

const OIIO::TypeDesc types[] = {OIIO::TypeUInt8, OIIO::TypeUInt16, OIIO::TypeHalf};

/// Memory of an image, with so many numbers between pixels.
struct SpacedPixels {
    SpacedPixels(OIIO::TypeDesc type, size_t gap)
        : bytes(numbers / channels * (channels + gap) * type.size()),
          image(OIIO::ImageSpec(width, height, channels, type), bytes.data(),
                OIIO::stride_t((channels + gap) * type.size())) {}

    std::vector<char> bytes;
    OIIO::ImageBuf image;
};

/// Gaps, and channels that are read or written.
struct Case {
    size_t gap;
    int chbegin, chend;
    OIIO::ROI roi() const { return {7, 290, 11, 80, 0, 1, chbegin, chend}; }
    size_t count() const { return size_t(roi().npixels()) * size_t(chend - chbegin); }
};
constexpr Rect part{7, 11, 290, 80};
constexpr Case cases[] = {{0, 0, channels}, {0, 1, channels}, {2, 0, channels}, {1, 0, 1}};

TEST(Pixels, AreReadAsOpenImageIODoes) {
    for (const OIIO::TypeDesc& type : types)
        for (const Case& c : cases) {
            SpacedPixels of(type, c.gap);
            for (size_t i = 0; i + 1 < of.bytes.size(); i += 2) {
                const auto code = uint16_t(i / 2); // all there are
                std::memcpy(&of.bytes[i], &code, sizeof code);
            }
            std::vector<float> read(c.count()), expected(c.count());
            std::string error;
            ASSERT_TRUE(read_pixels(of.image, part, c.chbegin, c.chend, OIIO::TypeFloat,
                                    read.data(), error));
            ASSERT_TRUE(of.image.get_pixels(c.roi(), OIIO::TypeFloat, expected.data()));
            EXPECT_EQ(std::memcmp(read.data(), expected.data(), read.size() * sizeof(float)), 0)
                << type << ' ' << c.gap << ' ' << c.chbegin;
        }
}

TEST(Pixels, AreWrittenAsOpenImageIODoes) {
    std::mt19937 random(3);
    for (const OIIO::TypeDesc& type : types)
        for (const Case& c : cases) {
            SpacedPixels written(type, c.gap), expected(type, c.gap);
            std::vector<float> values(c.count());
            for (float& v : values) {
                // Of any size, and of halfs none; integers of NaN are not defined there.
                v = float_of(uint32_t(random()));
                if (type != OIIO::TypeHalf)
                    v = random() % 2 || std::isnan(v) ? float(random() % 65537) / 65536 : v;
            }
            ASSERT_TRUE(expected.image.set_pixels(c.roi(), OIIO::TypeFloat, values.data()));
            write_floats(written.image, part, c.chbegin, c.chend, values.data(),
                         c.chend - c.chbegin);
            EXPECT_EQ(written.bytes, expected.bytes) << type << ' ' << c.gap << ' ' << c.chbegin;
        }
}

} // namespace
} // namespace ddt::test
