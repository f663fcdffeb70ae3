// SPDX-License-Identifier: Apache-2.0
#include "plugin/colour/config.h"
#include "plugin/colour/space_light.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <locale>
#include <optional>

#include "tests/core/plain.h"
#include "tests/environment.h"
#include "tests/plugin/images.h"
#include "tests/temporary.h"

namespace {

class LightTest : public testing::Test {
protected:
    static std::shared_ptr<const ddt::Light> light(const std::string& space,
                                                   const std::string& option = "auto") {
        std::string error;
        auto found = ddt::find_light(option, space, error);
        EXPECT_TRUE(found) << error;
        return found ? found : std::make_shared<ddt::Light>();
    }

    static std::string error_of(const std::string& space, const std::string& option = "auto") {
        std::string error;
        EXPECT_FALSE(ddt::find_light(option, space, error));
        EXPECT_EQ(error.find('\n'), std::string::npos);
        return error;
    }

    static std::array<float, 3> to(const ddt::Light& l, float r, float g, float b) {
        std::array<float, 3> v{r, g, b};
        l.to_light(v.data(), 1);
        return v;
    }

    /// A config of a user: its reference is ACEScg-like, "curvy" mixes channels round a curve.
    static std::string write_config() {
        const std::string path = ddt::temporary("light_test.ocio");
        std::ofstream(path) << R"(ocio_profile_version: 2
luma: [0.5, 0.25, 0.25]
roles: {default: raw, scene_linear: studio linear}
displays:
  none:
    - !<View> {name: raw, colorspace: raw}
colorspaces:
  - !<ColorSpace>
    name: studio linear
  - !<ColorSpace>
    name: raw
    isdata: true
  - !<ColorSpace>
    name: sRGB
    to_scene_reference: !<GroupTransform>
      children:
        - !<ExponentWithLinearTransform> {gamma: 2.4, offset: 0.055, style: mirror}
        - !<MatrixTransform> {matrix: [0.6, 0.3, 0.1, 0, 0.1, 0.8, 0.1, 0, 0.1, 0.1, 0.8, 0, 0, 0, 0, 1]}
  - !<ColorSpace>
    name: curvy
    to_scene_reference: !<GroupTransform>
      children:
        - !<MatrixTransform> {matrix: [0.6, 0.3, 0.1, 0, 0.1, 0.8, 0.1, 0, 0.1, 0.1, 0.8, 0, 0, 0, 0, 1]}
        - !<ExponentTransform> {value: 2.2, style: mirror}
  - !<ColorSpace>
    name: log
    to_scene_reference: !<LogAffineTransform> {base: 2, log_side_slope: 0.1, log_side_offset: 0.5, lin_side_slope: 1, lin_side_offset: 0.01, direction: inverse}
)";
        return path;
    }

    /// A config with displays, whose view transforms, the first of which counts, are given. Its
    /// luma is none of CIE's, which tells whose light a display's is.
    static std::string write_displays(const std::string& view_transforms) {
        static int count = 0;
        const std::string path = ddt::temporary("displays" + std::to_string(++count) + ".ocio");
        std::ofstream(path) << R"(ocio_profile_version: 2
luma: [0.5, 0.25, 0.25]
roles: {default: raw, scene_linear: ACES2065-1}
displays:
  none:
    - !<View> {name: raw, colorspace: raw}
)" + view_transforms + R"(
display_colorspaces:
  - !<ColorSpace>
    name: XYZ
  - !<ColorSpace>
    name: sRGB - Display
    from_display_reference: !<BuiltinTransform> {style: DISPLAY - CIE-XYZ-D65_to_sRGB}
  - !<ColorSpace>
    name: PQ - Display
    from_display_reference: !<BuiltinTransform> {style: DISPLAY - CIE-XYZ-D65_to_REC.2100-PQ}
colorspaces:
  - !<ColorSpace>
    name: ACES2065-1
  - !<ColorSpace>
    name: raw
    isdata: true
  - !<ColorSpace>
    name: ACEScc
    to_scene_reference: !<BuiltinTransform> {style: ACEScc_to_ACES2065-1}
)";
        return path;
    }

    /// The widest that colours of 0 to 1 come back from.
    static float lost(const ddt::Light& l) {
        float worst = 0;
        for (int i = 0; i < 17 * 17 * 17; ++i) {
            const float colour[3] = {float(i % 17) / 16, float(i / 17 % 17) / 16,
                                     float(i / 289) / 16};
            float v[3] = {colour[0], colour[1], colour[2]};
            l.to_light(v, 1);
            l.from_light(v, 1);
            for (int c = 0; c < 3; ++c)
                worst = std::max(worst, std::fabs(v[c] - colour[c]));
        }
        return worst;
    }

    static constexpr const char* tone_mapping = R"(view_transforms:
  - !<ViewTransform>
    name: tone mapping
    from_scene_reference: !<BuiltinTransform> {style: ACES-OUTPUT - ACES2065-1_to_CIE-XYZ-D65 - SDR-VIDEO_1.0}
  - !<ViewTransform>
    name: plain
    from_scene_reference: !<BuiltinTransform> {style: UTILITY - ACES-AP0_to_CIE-XYZ-D65_BFD})";

private:
    const ddt::Environment m_none_named{"OCIO", std::nullopt};
};

// On a farm of unlike configs a picture would else be blended in another light on some machines.
TEST_F(LightTest, AConfigWithoutSceneLinearHasNoneForAnImage) {
    const float expected = to(*light("sRGB"), 0.5f, 0.5f, 0.5f)[0];
    const std::string path = ddt::temporary("no_roles.ocio");
    std::ofstream(path) << R"(ocio_profile_version: 2
roles: {default: raw}
displays:
  none:
    - !<View> {name: raw, colorspace: raw}
colorspaces:
  - !<ColorSpace>
    name: raw
    isdata: true
  - !<ColorSpace>
    name: sRGB
    to_scene_reference: !<ExponentTransform> {value: 3}
)";
    const ddt::Environment ocio("OCIO", path);
    EXPECT_EQ(to(*light("sRGB"), 0.5f, 0.5f, 0.5f)[0], expected);
    EXPECT_FALSE(light("raw")->converts());
    EXPECT_NE(error_of("", "sRGB").find("no role scene_linear"), std::string::npos);
}

TEST_F(LightTest, NamesOfGammas) {
    const float expected = std::pow(0.5f, 2.0f);
    EXPECT_NEAR(to(*light("Gamma2.0"), 0.5f, 0.5f, 0.5f)[1], expected, 1e-5f);
    EXPECT_NEAR(to(*light("g20_rec709_scene"), 0.5f, 0.5f, 0.5f)[1], expected, 1e-5f);
    EXPECT_NEAR(to(*light("g22_rec709_scene"), 0.5f, 0.5f, 0.5f)[1], std::pow(0.5f, 2.2f), 1e-5f);
    for (const char* unknown : {"g2.0_rec709_scene", "g_rec709_scene", "g0_rec709_scene",
                                "g101_rec709_scene", "g20_rec2020_scene", "g-2_rec709_scene"})
        EXPECT_FALSE(light(unknown)->known()) << unknown;
    // The config that is carried has aliases of these names.
    const ddt::Environment another("OCIO", write_config());
    for (const char* name : {"g18_rec709_scene", "g22_rec709_scene", "g24_rec709_scene"})
        EXPECT_TRUE(light("", name)->converts()) << name;
}

TEST_F(LightTest, KnownValues) {
    EXPECT_NEAR(to(*light("sRGB"), 0.5f, 0, 1)[0], 0.2140411f, 1e-6f);
    EXPECT_EQ(to(*light("sRGB"), 0.5f, 0, 1)[1], 0.0f);
    EXPECT_NEAR(to(*light("sRGB"), 0.5f, 0, 1)[2], 1.0f, 1e-6f);
    EXPECT_NEAR(to(*light("Rec709"), 0.5f, 0, 1)[0], 0.2595894f, 1e-5f);
    EXPECT_NEAR(to(*light("Gamma2.2"), 0.5f, 0, 1)[0], std::pow(0.5f, 2.2f), 1e-6f);
    EXPECT_NEAR(to(*light("gamma1.8"), 0.5f, 0, 1)[0], std::pow(0.5f, 1.8f), 1e-6f);
    EXPECT_NEAR(to(*light("Gamma2.4"), 0.5f, 0, 1)[0], std::pow(0.5f, 2.4f), 1e-6f);
    EXPECT_NEAR(to(*light("Gamma2.6"), 0.5f, 0, 1)[0], std::pow(0.5f, 2.6f), 1e-6f);
    // The image's own primaries: no matrix is left.
    EXPECT_NEAR(to(*light("AdobeRGB"), 0.5f, 0, 1)[0], std::pow(0.5f, 563.0f / 256), 1e-6f);
    EXPECT_NEAR(to(*light("AdobeRGB"), 0.5f, 0, 1)[1], 0.0f, 1e-6f);
}

struct DecimalComma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
};

// OpenColorIO reads the numbers of a config's text by it.
TEST_F(LightTest, TheHostsLocaleDoesNotMatter) {
    const std::locale before =
        std::locale::global(std::locale(std::locale::classic(), new DecimalComma));
    for (const char* name : {"sRGB", "Rec709", "Gamma1.8", "AdobeRGB", "g23_rec709_scene"})
        EXPECT_TRUE(light(name)->converts()) << name;
    std::locale::global(before);
}

// Any file may name a space, of which there are as many as there are exponents.
TEST_F(LightTest, OfManySpacesTheLastAreKept) {
    const auto name = [](int i) { return "Gamma2.0" + std::to_string(10 + i); };
    const std::weak_ptr<const ddt::Light> first = light(name(0));
    for (int i = 1; i < 32; ++i)
        light(name(i));
    EXPECT_EQ(light(name(0)), first.lock()) << "found once more";
    const std::weak_ptr<const ddt::Light> second = light(name(1));
    for (int i = 2; i < 33; ++i)
        light(name(i));
    EXPECT_TRUE(first.expired());
    EXPECT_FALSE(second.expired());
}

TEST_F(LightTest, LinearSpacesAreLeftAlone) {
    for (const char* space : {"Linear", "linear", "scene_linear", "lin_rec709", "ACEScg",
                              "ACES2065-1", "lin_srgb", "Gamma1"}) {
        EXPECT_FALSE(light(space)->converts()) << space;
        EXPECT_TRUE(light(space)->known()) << space;
    }
}

TEST_F(LightTest, LumaIsThatOfThePrimaries) {
    EXPECT_NEAR(light("sRGB")->luma()[1], 0.7152f, 1e-6f);
    // AP1 in Rec.709's luminance: the row sums of the white stay 1.
    const auto& l = light("ACEScg")->luma();
    EXPECT_NEAR(l[0] + l[1] + l[2], 1.0f, 1e-5f);
    EXPECT_NEAR(l[0], 0.267f, 0.01f);
}

TEST_F(LightTest, UnknownAndDataSpacesAreNotConverted) {
    for (const char* space : {"", "KodakLog", "CMYK", "raw", "Gamma", "Gamma0", "Gamma2.2x"}) {
        EXPECT_FALSE(light(space)->converts()) << space;
        EXPECT_FALSE(light(space)->known()) << space;
    }
}

TEST_F(LightTest, EveryCodeComesBack) {
    for (const char* space : {"sRGB", "Rec709", "Gamma1.8", "Gamma2.2", "Gamma2.4", "AdobeRGB",
                              "GammaCorrected", "Gamma2.6"})
        for (const int top : {255, 65535}) {
            const auto l = light(space);
            ASSERT_TRUE(l->converts()) << space;
            for (int code = 0; code <= top; ++code) {
                float v[3];
                for (float& c : v)
                    c = float(code) / float(top);
                l->to_light(v, 1);
                l->from_light(v, 1);
                for (const float c : v)
                    ASSERT_EQ(int(c * float(top) + 0.5f), code) << space;
            }
        }
}

TEST_F(LightTest, BeyondTheTableAndNegative) {
    const auto l = light("sRGB");
    for (const float x : {-3.0f, -0.5f, -1e-12f, 1e-12f, 1e-30f, 7.0f, 1e3f, 3e5f}) {
        float v[3] = {x, x, x};
        l->to_light(v, 1);
        const double a = std::fabs(double(x));
        // OpenColorIO starts its straight part with the slope that makes no corner.
        const double e = a <= 0.0392857 ? a / 12.9232102 : std::pow((a + 0.055) / 1.055, 2.4);
        EXPECT_NEAR(std::fabs(v[0]) / e, 1.0, 2e-5) << x;
        EXPECT_EQ(std::signbit(v[0]), std::signbit(x));
        l->from_light(v, 1);
        EXPECT_NEAR(v[0] / x, 1.0, 2e-5) << x;
    }
}

TEST_F(LightTest, NumbersThatAreNotFiniteStayAlone) {
    const float infinity = std::numeric_limits<float>::infinity();
    const auto v = to(*light("sRGB"), std::nanf(""), 0.5f, infinity);
    EXPECT_TRUE(std::isnan(v[0]));
    EXPECT_NEAR(v[1], 0.2140411f, 1e-6f);
    EXPECT_EQ(v[2], infinity);
}

TEST_F(LightTest, NamedSpaceMustBeKnown) {
    EXPECT_TRUE(light("", "sRGB")->converts());
    EXPECT_TRUE(light("Linear", "sRGB")->converts());
    const std::string error = error_of("sRGB", "nosuch");
    EXPECT_NE(error.find("\"nosuch\""), std::string::npos) << error;
    for (const char* name : {"auto", "encoded", "sRGB", "ACEScg"})
        EXPECT_NE(error.find(name), std::string::npos) << error;
}

TEST_F(LightTest, MissingOrBrokenConfigIsAnError) {
    {
        const ddt::Environment ocio("OCIO", "/nowhere/config.ocio");
        const std::string error = error_of("sRGB");
        EXPECT_NE(error.find("/nowhere/config.ocio"), std::string::npos) << error;
    }
    const std::string path = ddt::temporary("broken.ocio");
    std::ofstream(path) << "this is no config\n";
    const ddt::Environment ocio("OCIO", path);
    EXPECT_NE(error_of("sRGB").find(path), std::string::npos);
    EXPECT_NE(error_of("", "sRGB").find(path), std::string::npos);
    EXPECT_TRUE(light("")); // nothing to look up
}

TEST_F(LightTest, UsersConfigComesFirst) {
    const ddt::Environment ocio("OCIO", write_config());
    const auto srgb = light("sRGB");
    EXPECT_NEAR(to(*srgb, 0.5f, 0, 1)[0], 0.2140411f, 1e-5f); // the matrix is left out
    EXPECT_NEAR(to(*srgb, 0.5f, 0, 1)[1], 0.0f, 1e-5f);
    // 0.5 * 0.6 + 0.25 * 0.1 + 0.25 * 0.1
    EXPECT_NEAR(srgb->luma()[0], 0.35f, 1e-5f);
    EXPECT_FALSE(light("Linear")->converts());
    // Spaces it lacks: known to the carried config for images, unknown for the user.
    EXPECT_TRUE(light("Rec709")->converts());
    const std::string error = error_of("", "Rec709");
    EXPECT_NE(error.find("studio linear"), std::string::npos) << error;
    EXPECT_EQ(error.find("ACEScg"), std::string::npos) << error;
}

// Options end at commas.
TEST_F(LightTest, ANameWithACommaIsNotSaidToBeAllowedAsAnOption) {
    const std::string path = ddt::temporary("commas.ocio");
    std::ofstream(path) << R"(ocio_profile_version: 2
roles: {default: raw, scene_linear: raw}
displays:
  none:
    - !<View> {name: raw, colorspace: raw}
colorspaces:
  - !<ColorSpace>
    name: raw
  - !<ColorSpace>
    name: "film, graded"
    to_scene_reference: !<ExponentTransform> {value: 2}
  - !<ColorSpace>
    name: plain
)";
    const ddt::Environment ocio("OCIO", path);
    const std::string error = error_of("", "film");
    EXPECT_NE(error.find("allowed are auto, encoded, linear, raw, plain (names with commas: by "
                         "oiio:ColorSpace only)"),
              std::string::npos)
        << error;
    EXPECT_TRUE(light("film, graded")->converts());
    const ddt::Environment another("OCIO", write_config());
    EXPECT_EQ(error_of("", "film").find("commas"), std::string::npos);
}

TEST_F(LightTest, EachChannelMayHaveACurveOfItsOwn) {
    for (size_t other = 0; other < 3; ++other) {
        const auto scaled = [&](float by) {
            return [=](float* rgb, size_t count) {
                for (size_t i = 0; i < count; ++i)
                    rgb[3 * i + other] *= by;
            };
        };
        ddt::Light l;
        ASSERT_TRUE(ddt::Light::curves(scaled(0.5f), scaled(2.0f), {0.3f, 0.6f, 0.1f}, l)) << other;
        EXPECT_FALSE(l.alike()) << other;
        const auto v = to(l, 0.25f, 0.25f, 0.25f);
        for (size_t c = 0; c < 3; ++c)
            EXPECT_EQ(v[c], c == other ? 0.125f : 0.25f) << other << " " << c;
    }
}

TEST_F(LightTest, SpaceThatMixesChannelsGoesThroughOcio) {
    const ddt::Environment ocio("OCIO", write_config());
    const auto curvy = light("curvy");
    const auto v = to(*curvy, 0.2f, 0.4f, 0.9f);
    EXPECT_NEAR(v[0], std::pow(0.6 * 0.2 + 0.3 * 0.4 + 0.1 * 0.9, 2.2), 1e-5);
    EXPECT_NEAR(v[2], std::pow(0.1 * 0.2 + 0.1 * 0.4 + 0.8 * 0.9, 2.2), 1e-5);
    std::vector<float> many(3000);
    for (size_t i = 0; i < many.size(); ++i)
        many[i] = float(i % 97) / 97.0f;
    std::vector<float> back = many;
    curvy->to_light(back.data(), back.size() / 3);
    curvy->from_light(back.data(), back.size() / 3);
    for (size_t i = 0; i < many.size(); ++i)
        ASSERT_NEAR(back[i], many[i], 1e-5f);
}

TEST_F(LightTest, LogarithmicSpaceComesBack) {
    const ddt::Environment ocio("OCIO", write_config());
    const auto log = light("log");
    ASSERT_TRUE(log->converts());
    EXPECT_FALSE(log->keeps_unit());
    for (int code = 0; code <= 255; ++code) {
        float v[3] = {float(code) / 255, float(code) / 255, float(code) / 255};
        log->to_light(v, 1);
        log->from_light(v, 1);
        ASSERT_EQ(int(v[1] * 255 + 0.5f), code);
    }
    // 200 would be 2^1995. What is no number, or infinite, stays so.
    const float inf = std::numeric_limits<float>::infinity();
    float v[6] = {200, -200, 0.5f, inf, -inf, std::nanf("")};
    log->to_light(v, 2);
    EXPECT_EQ(v[0], std::numeric_limits<float>::max());
    EXPECT_TRUE(std::isfinite(v[1]));
    EXPECT_EQ(v[3], inf);
    EXPECT_EQ(v[4], -inf);
    EXPECT_TRUE(std::isnan(v[5]));
    log->from_light(v, 2);
    EXPECT_TRUE(std::isfinite(v[0]));
}

// PQ's numbers went through what ACES makes of 100 nits, and came back with its brightest.
TEST_F(LightTest, ADisplaysIsNotToneMapped) {
    const std::string gone = R"(view_transforms:
  - !<ViewTransform>
    name: gone
    from_scene_reference: !<FileTransform> {src: nowhere.cube})";
    for (const std::string& transforms : {std::string(tone_mapping), std::string(), gone}) {
        const ddt::Environment ocio("OCIO", write_displays(transforms));
        for (const char* option : {"auto", "PQ - Display"}) {
            const auto pq = light("PQ - Display", option);
            // SMPTE ST 2084: 100 and 1000 nits.
            EXPECT_NEAR(to(*pq, 0.751827f, 0.508078f, 0)[0] / to(*pq, 0, 0.508078f, 1)[1], 10,
                        0.01);
            EXPECT_LT(lost(*pq), 2e-6f);
            EXPECT_NEAR(pq->luma()[1], 0.678f, 1e-3f); // of Rec. 2020's green
        }
        const auto srgb = light("sRGB - Display");
        EXPECT_NEAR(to(*srgb, 0.5f, 0, 1)[0], 0.2140411f, 1e-5f);
        EXPECT_NEAR(to(*srgb, 0.5f, 0, 1)[1], 0, 1e-6f);
        EXPECT_NEAR(srgb->luma()[0], 0.2126f, 1e-4f);
        EXPECT_TRUE(srgb->alike());
        EXPECT_FALSE(light("XYZ")->converts());
        EXPECT_EQ(light("XYZ")->luma()[1], 1.0f);
    }
}

TEST_F(LightTest, ADisplaysIsSceneLinearWhereThatIsTheSame) {
    const std::string path =
        write_displays("default_view_transform: plain\n" + std::string(tone_mapping));
    const ddt::Environment ocio("OCIO", path);
    const auto srgb = light("sRGB - Display");
    EXPECT_NEAR(to(*srgb, 0.5f, 0, 1)[0], 0.2140411f, 1e-5f);
    // The config's luma of AP0, 0.5 of what is red there.
    EXPECT_NEAR(srgb->luma()[0], 0.5 * 0.4397 + 0.25 * 0.0898 + 0.25 * 0.0175, 1e-3);
}

// ACEScc has no colours that are negative in AP0.
TEST_F(LightTest, PrimariesThatCutColoursOffAreLeftOut) {
    const ddt::Environment ocio("OCIO", write_displays(tone_mapping));
    const auto cc = light("ACEScc");
    EXPECT_LT(lost(*cc), 2e-6f);
    const auto& luma = cc->luma(); // of AP1 in AP0, whose whites are the same
    EXPECT_NEAR(luma[0], 0.5 * 0.6955 + 0.25 * 0.0448 - 0.25 * 0.0055, 1e-3);
    EXPECT_NEAR(luma[0] + luma[1] + luma[2], 1, 1e-4);
}

class LossyTest : public LightTest {
protected:
    /// A picture of one colour that the space "cut" has no light for, enlarged.
    static float enlarged(const std::string& option, std::string& error) {
        auto src = images::make(4, 4, 3, OIIO::TypeFloat);
        images::fill(src, [](int, int, int c) { return c == 0 ? 0.9f : 0.5f; });
        src.specmod().attribute("oiio:ColorSpace", "cut");
        ddt::Options options;
        options.light = option;
        OIIO::ImageBuf dst;
        if (!ddt::resize(dst, src, options, OIIO::ROI(0, 8, 0, 8, 0, 1))) {
            error = dst.geterror();
            return -1;
        }
        return images::value(dst, 4, 4, 0);
    }

private:
    static std::string write() {
        const std::string path = ddt::temporary("lossy.ocio");
        std::ofstream(path) << R"(ocio_profile_version: 2
roles: {default: raw, scene_linear: linear}
displays:
  none:
    - !<View> {name: raw, colorspace: raw}
colorspaces:
  - !<ColorSpace>
    name: linear
  - !<ColorSpace>
    name: raw
    isdata: true
  - !<ColorSpace>
    name: cut
    to_scene_reference: !<GroupTransform>
      children:
        - !<MatrixTransform> {matrix: [0.6, 0.3, 0.1, 0, 0.1, 0.8, 0.1, 0, 0.1, 0.1, 0.8, 0, 0, 0, 0, 1]}
        - !<RangeTransform> {min_in_value: 0, min_out_value: 0, max_in_value: 0.7, max_out_value: 0.7}
        - !<ExponentTransform> {value: 2.2}
)";
        return path;
    }
    const ddt::Environment m_ocio{"OCIO", write()};
};

TEST_F(LossyTest, ColoursThatDoNotComeBackAreNotConverted) {
    EXPECT_FALSE(light("cut")->comes_back());
    EXPECT_TRUE(ddt::Light::whole([](float*, size_t) {}, [](float*, size_t) {}, {}).comes_back());
    std::string error;
    EXPECT_NEAR(enlarged("auto", error), 0.9f, 1e-6f) << error;
    EXPECT_NEAR(enlarged("encoded", error), 0.9f, 1e-6f) << error;
}

TEST_F(LossyTest, ColoursThatDoNotComeBackAreAnErrorByName) {
    EXPECT_NE(error_of("", "cut").find("light=cut: "), std::string::npos);
    std::string error;
    EXPECT_EQ(enlarged("cut", error), -1);
    EXPECT_NE(error.find("auto, encoded"), std::string::npos) << error;
}

// What it is for: the middle between black and white is half the light, code 188 of 255.
TEST_F(LightTest, MiddleOfBlackAndWhite) {
    auto middle = [](const char* option, const char* space) {
        auto src = images::make(2, 2, 3, OIIO::TypeUInt8);
        images::fill(src, [](int x, int, int) { return float(x); });
        src.specmod().attribute("oiio:ColorSpace", space);
        ddt::Options options;
        options.surface = ddt::test::plain_surface(ddt::Surface::linear);
        options.light = option;
        const auto dst = images::enlarged(src, 6, 6, options);
        return int(std::lround(images::value(dst, 2, 2) * 255));
    };
    // Pixel 2 of 6 shows position 1/3: a third of the light.
    EXPECT_EQ(middle("auto", "sRGB"), 156);
    EXPECT_EQ(middle("encoded", "sRGB"), 85);
    EXPECT_EQ(middle("auto", "Linear"), 85);
    EXPECT_EQ(middle("auto", ""), 85);
    EXPECT_EQ(middle("sRGB", ""), 156);
}

} // namespace
