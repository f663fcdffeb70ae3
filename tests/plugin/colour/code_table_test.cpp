// SPDX-License-Identifier: Apache-2.0
#include "plugin/colour/code_table.h"

#include <cmath>

#include "core/base/codes.h"
#include "plugin/colour/config.h"
#include "plugin/colour/space_light.h"
#include "tests/core/helpers.h"
#include "tests/plugin/images.h"

namespace {

namespace OCIO = OCIO_NAMESPACE;

std::shared_ptr<const ddt::Light> light(const std::string& space) {
    std::string error;
    auto found = ddt::find_light("auto", space, error);
    EXPECT_TRUE(found && found->alike()) << space << ": " << error;
    return found ? found : std::make_shared<ddt::Light>();
}

/// What OpenColorIO itself makes of numbers; the space has the primaries of scene_linear.
std::vector<float> exactly(const std::string& space, std::vector<float> x, bool to_linear) {
    ddt::Space found;
    std::string error;
    if (!ddt::find_space(space, ddt::NamedBy::image, found, error) || !found.space) {
        ADD_FAILURE() << space << ": " << error;
        return {};
    }
    const char* linear = OCIO::ROLE_SCENE_LINEAR;
    const char* name = found.space->getName();
    const auto processor =
        found.config->getProcessor(to_linear ? name : linear, to_linear ? linear : name)
            ->getOptimizedCPUProcessor(OCIO::BIT_DEPTH_F32, OCIO::BIT_DEPTH_F32,
                                       OCIO::OPTIMIZATION_LOSSLESS);
    x.resize((x.size() + 2) / 3 * 3);
    OCIO::PackedImageDesc pixels(x.data(), long(x.size() / 3), 1, 3);
    processor->apply(pixels);
    return x;
}

/// Numbers all over 0 to 1, as densely near 0 as near 1, and some past it.
std::vector<float> sweep() {
    std::vector<float> x{0.0f};
    for (uint32_t u = ddt::bits_of(0x1p-20f); u < ddt::bits_of(1.25f); u += 97)
        x.push_back(ddt::float_of(u));
    return x;
}

const char* const spaces[] = {"sRGB", "Rec709", "Gamma1.8", "Gamma2.2", "Gamma2.4", "Gamma2.6"};

TEST(CodeTable, EncodesToWithinHalfACodeOfOpenColorIO) {
    const std::vector<float> x = sweep();
    for (const char* space : spaces) {
        const auto l = light(space);
        ASSERT_TRUE(l->codes()) << space;
        const auto exact = exactly(space, x, false);
        std::vector<uint8_t> codes(x.size());
        l->codes()->encode(x.data(), codes.data(), x.size());
        auto values = x;
        l->from_light_alike(values.data(), values.size());
        for (size_t i = 0; i < x.size(); ++i) {
            const double wanted = std::min(double(exact[i]), 1.0);
            // The curve's own table is good for 2^-20; an exact half may go either way.
            ASSERT_LE(std::fabs(codes[i] - wanted * 255), 0.5 + 1e-3) << space << " " << x[i];
            ASSERT_LE(std::fabs(ddt::code_of<uint16_t>(values[i]) - wanted * 65535), 0.5 + 0.07)
                << space << " " << x[i];
        }
    }
}

TEST(CodeTable, EveryCodeComesBackFromOpenColorIOsLight) {
    for (const char* space : spaces) {
        const auto l = light(space);
        for (const int top : {255, 65535}) {
            std::vector<float> x;
            for (int code = 0; code <= top; ++code)
                x.push_back(float(code) / float(top));
            auto mine = x;
            l->to_light_alike(mine.data(), mine.size());
            for (auto values : {exactly(space, x, true), mine}) {
                std::vector<uint8_t> codes(values.size());
                l->codes()->encode(values.data(), codes.data(), values.size());
                l->from_light_alike(values.data(), values.size());
                for (int code = 0; code <= top; ++code) {
                    const float v = values[size_t(code)];
                    if (top == 255)
                        ASSERT_EQ(codes[size_t(code)], code) << space;
                    else
                        ASSERT_EQ(ddt::code_of<uint16_t>(v), code) << space;
                }
            }
        }
    }
}

TEST(CodeTable, IsTheCurveRoundedOnEveryInstructionSet) {
    std::vector<float> x = sweep();
    const float infinity = std::numeric_limits<float>::infinity();
    for (const float v : {-0.0f, -1e-30f, -0.5f, -1e10f, 1e-42f, 1e-12f, 3.0f, 1e5f, 1e10f,
                          infinity, -infinity, std::nanf("")})
        x.insert(x.begin(), v);
    for (const char* space : spaces) {
        const auto l = light(space);
        std::vector<uint8_t> wanted;
        std::vector<float> values;
        for (const float v : x) {
            float rgb[3] = {v, v, v};
            l->from_light(rgb, 1); // too few for vectors
            values.push_back(rgb[1]);
            wanted.push_back(ddt::code_of<uint8_t>(rgb[0]));
        }
        ddt::test::on_each_target([&] {
            std::vector<uint8_t> codes(x.size(), 77);
            l->codes()->encode(x.data(), codes.data(), x.size());
            EXPECT_EQ(codes, wanted) << space;
            auto together = x;
            l->from_light_alike(together.data(), together.size());
            EXPECT_EQ(ddt::test::differing(together, values), 0u) << space;
        });
    }
}

TEST(CodeTable, RefusesCurvesItCannotHold) {
    const auto table = [](const std::function<float(float)>& f) {
        std::vector<float> values;
        for (const float x : ddt::Curve::arguments())
            values.push_back(f(x));
        ddt::Curve curve;
        curve.fill(values.data());
        ddt::CodeTable codes;
        return ddt::fill_codes(curve, codes);
    };
    EXPECT_TRUE(table([](float x) { return x; }));
    EXPECT_FALSE(table([](float x) { return 1 - x; }));
    EXPECT_FALSE(table([](float x) { return std::fabs(x); }));
    EXPECT_FALSE(table([](float x) { return 0.1f + x; }));
    EXPECT_FALSE(table([](float x) { return 0.5f * x / (1 + std::fabs(x)); }));
    EXPECT_FALSE(table([](float x) { return x < 0.5f ? 0.0f : 1.0f; }));
}

// Where conversion and rounding are one step and where they are two: a part is a crop of the whole.
TEST(CodeTable, OneChannelOfManyHasTheBitsOfAll) {
    for (const auto& type : {OIIO::TypeUInt8, OIIO::TypeUInt16}) {
        auto src = images::make(40, 30, 3, type);
        images::noise(src);
        src.specmod().attribute("oiio:ColorSpace", "sRGB");
        const auto all = images::enlarged(src, 160, 120);
        OIIO::ROI roi(0, 160, 0, 120, 0, 1, 1, 2);
        auto dst = images::make(160, 120, 3, type);
        ASSERT_TRUE(ddt::resize(dst, src, {}, roi)) << dst.geterror();
        for (int y = 0; y < 120; ++y)
            for (int x = 0; x < 160; ++x)
                for (int c = 0; c < 3; ++c)
                    ASSERT_EQ(images::value(dst, x, y, c),
                              c == 1 ? images::value(all, x, y, 1) : 0.0f)
                        << x << " " << y << " " << c;
    }
}

} // namespace
