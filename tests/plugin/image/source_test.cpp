// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/source.h"

#include <cstring>
#include <random>

#include <gtest/gtest.h>

#include "plugin/image/reading.h"

namespace ddt::test {
namespace {

/// All codes there are, and by chance; of halfs none that is not finite, which have no one NaN.
OIIO::ImageBuf image_of_codes(OIIO::TypeDesc type, int channels) {
    OIIO::ImageBuf image(OIIO::ImageSpec(300, 90, channels, type));
    std::mt19937 random(5);
    auto* bytes = static_cast<uint8_t*>(image.localpixels());
    const size_t n = image.spec().image_pixels() * size_t(channels);
    for (size_t i = 0; i < n; ++i) {
        const auto code = uint16_t(i < 65536 ? i : random());
        const uint32_t finite = (code & 0x7c00u) == 0x7c00u ? code & 0x83ffu : code;
        std::memcpy(bytes + i * type.size(), &finite, type.size());
    }
    return image;
}

class SourceCodes : public testing::Test {
protected:
    bool plan(const OIIO::ImageBuf& image, const char* light) {
        Options options;
        options.light = light;
        m_reading = Reading();
        return plan_reading(image, options, image.roi(), m_reading, m_error);
    }
    Reading m_reading;
    std::string m_error;
};

TEST_F(SourceCodes, StandForWhatReadingGives) {
    for (const OIIO::TypeDesc& type : {OIIO::TypeUInt8, OIIO::TypeHalf})
        for (const char* light : {"auto", "encoded", "sRGB"}) {
            const OIIO::ImageBuf image = image_of_codes(type, 3);
            ASSERT_TRUE(plan(image, light)) << m_error;
            ImageSource source(image, m_reading);
            const std::vector<float> table = source.codes();
            ASSERT_EQ(table.size(), type == OIIO::TypeUInt8 ? 256u : 65536u)
                << type << ' ' << light;
            const Rect part{7, 11, 290, 80};
            const size_t n = part.area() * 3;
            std::vector<float> values(n), guide(part.area()), guide_too(part.area());
            std::vector<uint8_t> codes(n * type.size());
            ASSERT_TRUE(source.read(part, values.data(), guide.data()));
            ASSERT_TRUE(source.read_codes(part, codes.data(), guide_too.data()));
            EXPECT_EQ(guide, guide_too);
            size_t differing = 0;
            for (size_t i = 0; i < n; ++i) {
                uint16_t code = 0;
                std::memcpy(&code, &codes[i * type.size()], type.size());
                differing += std::memcmp(&table[code], &values[i], sizeof(float)) != 0;
            }
            EXPECT_EQ(differing, 0u) << type << ' ' << light;
        }
}

// Where a number's meaning is not its own alone, and of more than 65536 there may be.
TEST_F(SourceCodes, AreNotThereWhereTheyWouldNotDo) {
    const auto has_codes = [&](const OIIO::ImageBuf& image, const char* light) {
        EXPECT_TRUE(plan(image, light)) << m_error;
        return !ImageSource(image, m_reading).codes().empty();
    };
    EXPECT_FALSE(has_codes(image_of_codes(OIIO::TypeFloat, 3), "encoded"));
    EXPECT_FALSE(has_codes(image_of_codes(OIIO::TypeUInt32, 3), "encoded"));
    // Colour is divided by alpha on its way to linear light.
    EXPECT_FALSE(has_codes(image_of_codes(OIIO::TypeUInt8, 4), "sRGB"));
    EXPECT_TRUE(has_codes(image_of_codes(OIIO::TypeUInt8, 4), "encoded"));
    // Some of the channels.
    const OIIO::ImageBuf image = image_of_codes(OIIO::TypeUInt8, 3);
    OIIO::ROI some = image.roi();
    some.chend = 2;
    Options options;
    options.light = "encoded";
    m_reading = Reading();
    ASSERT_TRUE(plan_reading(image, options, some, m_reading, m_error));
    EXPECT_TRUE(ImageSource(image, m_reading).codes().empty());
}

} // namespace
} // namespace ddt::test
