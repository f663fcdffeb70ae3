// SPDX-License-Identifier: Apache-2.0
// What the effect does, in a host that suits.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "plugin/colour/space_light.h"
#include "tests/plugin/openfx/effect_fixture.h"

namespace {

using namespace mini;

TEST_F(OpenFx, PiecesAreCropsAndOnlyTheRegionOfInterestIsRead) {
    const ImageBuf image = photograph(600, 300, 3, TypeDesc::FLOAT);
    const ImageBuf wanted = images::enlarged(image, 1200, 600, with_light("linear"));
    open(nuke, image);
    render_whole(157);
    EXPECT_TRUE(same_pixels(effect->output, wanted));
    // What is outside of the region of interest may as well not be there.
    Picture all = effect->output;
    RectD roi{};
    ASSERT_EQ(effect->region_of_interest({1100, 20, 1150, 40}, roi), ddt::ofx::ok);
    effect->source = cut(effect->source, {int(roi.x1), int(roi.y1), int(roi.x2), int(roi.y2)});
    ASSERT_LT(effect->source.box.width(), 400);
    effect->output.box = {1100, 20, 1150, 40};
    effect->output.allocate();
    ASSERT_EQ(effect->render(effect->output.box), ddt::ofx::ok);
    EXPECT_EQ(effect->output.bytes, cut(all, effect->output.box).bytes);
}

TEST_F(OpenFx, OtherOriginsAndOptions) {
    const ImageBuf image = photograph(50, 40, 4, TypeDesc::FLOAT);
    ddt::Options options;
    std::string error;
    ASSERT_TRUE(
        ddt::parse_filter("ddt-sharp,light=linear,cost=scf,meshes=2,blur=0.1", options, error));
    open(natron, image, "OfxBitDepthFloat", -20, 300);
    effect->choose("filter", "ddt-sharp");
    effect->choose("cost", "scf");
    effect->set("meshes", 2);
    effect->set("blur", 0.1);
    effect->set("scale_y", 3);
    render_whole();
    EXPECT_EQ(effect->output.box.x0, -40);
    EXPECT_EQ(effect->output.box.y0, 900);
    EXPECT_TRUE(same_pixels(effect->output, images::enlarged(image, 100, 120, options)));
}

TEST_F(OpenFx, AWidthOrAHeightInsteadOfAScale) {
    const ImageBuf image = photograph(50, 40, 3, TypeDesc::FLOAT);
    open(nuke, image);
    effect->set("width", 130);
    render_whole();
    EXPECT_EQ(effect->output.box.width(), 130);
    EXPECT_EQ(effect->output.box.height(), 104);
    EXPECT_TRUE(
        same_pixels(effect->output, images::enlarged(image, 130, 104, with_light("linear"))));
}

TEST_F(OpenFx, NoSideShrinks) {
    const ImageBuf image = photograph(60, 40, 3, TypeDesc::FLOAT);
    const ImageBuf large = images::enlarged(image, 120, 40, with_light("linear"));
    open(natron, image);
    effect->set("scale_y", 0.5);
    render_whole();
    EXPECT_TRUE(same_pixels(effect->output, large));
    effect->set("width", 150);
    effect->set("height", 10);
    render_whole();
    EXPECT_EQ(effect->output.box.width(), 150);
    EXPECT_EQ(effect->output.box.height(), 40);
    open(resolve, image);
    effect->set("scale_y", 0.5);
    effect->set("centre_x", 0);
    render_whole();
    const OIIO::ROI left(0, 60, 0, 40, 0, 1, 0, 3);
    EXPECT_TRUE(same_pixels(effect->output, OIIO::ImageBufAlgo::cut(large, left)));
}

TEST_F(OpenFx, AHostOfOneResolutionGetsAZoomWithACentre) {
    const ImageBuf image = photograph(60, 40, 3, TypeDesc::FLOAT);
    const ImageBuf large = images::enlarged(image, 180, 120, with_light("linear"));
    open(resolve, image);
    EXPECT_EQ(effect->params.count("width"), 0u);
    effect->set("scale", 3);
    effect->set("centre_x", 0);
    effect->set("centre_y", 1); // the upper left corner stays
    render_whole(23);
    EXPECT_EQ(effect->output.box.width(), 60);
    const ImageBuf corner = OIIO::ImageBufAlgo::cut(large, OIIO::ROI(0, 60, 0, 40));
    EXPECT_TRUE(same_pixels(effect->output, corner));
    effect->set("centre_x", 0.5);
    effect->set("centre_y", 0.5);
    render_whole();
    EXPECT_TRUE(
        same_pixels(effect->output, OIIO::ImageBufAlgo::cut(large, OIIO::ROI(60, 120, 40, 80))));
}

TEST_F(OpenFx, UnpremultipliedColourIsMultipliedFirst) {
    const ImageBuf image = photograph(50, 40, 4, TypeDesc::FLOAT);
    ImageBuf straight = OIIO::ImageBufAlgo::unpremult(image);
    const ImageBuf product = OIIO::ImageBufAlgo::premult(straight);
    const ImageBuf wanted =
        OIIO::ImageBufAlgo::unpremult(images::enlarged(product, 100, 80, with_light("linear")));
    open(nuke, straight);
    effect->source.premultiplication = "OfxImageAlphaUnPremultiplied";
    render_whole();
    EXPECT_TRUE(same_pixels(effect->output, wanted));
    effect->choose("premultiplication", "premultiplied");
    render_whole();
    EXPECT_FALSE(same_pixels(effect->output, wanted));
}

TEST_F(OpenFx, AProxyIsEnlargedByItself) {
    const ImageBuf image = photograph(31, 21, 3, TypeDesc::FLOAT);
    open(natron, image);
    effect->source_region = {0, 0, 62, 42};
    effect->output = effect->source;
    effect->output.box = {0, 0, 62, 42};
    effect->output.allocate();
    ASSERT_EQ(effect->render(effect->output.box, 0.5), ddt::ofx::ok);
    EXPECT_TRUE(same_pixels(effect->output, images::enlarged(image, 62, 42, with_light("linear"))));
}

/// Half of 101 x 81 pixels, of a host that makes 50 x 40 of them.
TEST_F(OpenFx, AProxyThatWasRoundedDownHasNoFadedEdge) {
    for (const bool white : {true, false}) {
        ImageBuf image = photograph(50, 40, 3, TypeDesc::FLOAT);
        if (white)
            images::fill(image, [](int, int, int) { return 1.0f; });
        open(natron, image);
        effect->source_region = {0, 0, 101, 81};
        effect->source_defined = effect->source.box;
        effect->output = effect->source;
        effect->output.box = {0, 0, 101, 81};
        effect->output.allocate();
        ASSERT_EQ(effect->render(effect->output.box, 0.5), ddt::ofx::ok);
        Picture sharp = cut(effect->output, {0, 0, 100, 80});
        EXPECT_TRUE(same_pixels(sharp, images::enlarged(image, 100, 80, with_light("linear"))));
        const auto* numbers = reinterpret_cast<const float*>(effect->output.bytes.data());
        const auto count = ptrdiff_t(effect->output.bytes.size() / sizeof(float));
        if (white) {
            EXPECT_EQ(std::count(numbers, numbers + count, 1.0f), count);
        }
    }
}

/// Half of -3 to 1201 by -5 to 81.5 pixels, by hosts that round them otherwise.
class OpenFxRoundings : public OpenFx {
protected:
    using Rounding = double (*)(double);
    void open_half(bool white, Rounding low, Rounding high) {
        const RectD region{-3, -5, 1201, 81.5};
        const Rect box{int(low(region.x1 / 2)), int(low(region.y1 / 2)), int(high(region.x2 / 2)),
                       int(high(region.y2 / 2))};
        ImageBuf image = photograph(box.width(), box.height(), 3, TypeDesc::FLOAT);
        if (white)
            images::fill(image, [](int, int, int) { return 1.0f; });
        open(natron, image, "OfxBitDepthFloat", box.x0, box.y0);
        effect->source_region = region;
        effect->source_defined = box;
        effect->output = effect->source;
        effect->output.box = {-3, -5, 1201, 82};
        effect->output.allocate();
    }
    const Rounding down = [](double v) { return std::floor(v); };
    const Rounding up = [](double v) { return std::ceil(v); };
    const Rounding nearest = [](double v) { return std::round(v); };
    const std::pair<Rounding, Rounding> all[5] = {
        {down, up}, {down, down}, {up, down}, {up, up}, {nearest, nearest}};
};

TEST_F(OpenFxRoundings, HaveNoFadedEdge) {
    for (const auto& [low, high] : all) {
        open_half(true, low, high);
        ASSERT_EQ(effect->render(effect->output.box, 0.5), ddt::ofx::ok);
        const auto* numbers = reinterpret_cast<const float*>(effect->output.bytes.data());
        const auto count = ptrdiff_t(effect->output.bytes.size() / sizeof(float));
        EXPECT_EQ(std::count(numbers, numbers + count, 1.0f), count)
            << effect->source.box.x0 << " " << effect->source.box.y0;
    }
}

/// Of the source no more is there than was asked for.
TEST_F(OpenFxRoundings, PiecesAreCrops) {
    for (const auto& [low, high] : all) {
        open_half(false, low, high);
        ASSERT_EQ(effect->render(effect->output.box, 0.5), ddt::ofx::ok);
        Picture whole = effect->output, source = effect->source;
        for (int x = -3; x < 1201; x += 86) {
            effect->output.box = {x, 30, x + 86, 50};
            effect->output.allocate();
            const double left = x, right = x + 86;
            RectD roi{};
            ASSERT_EQ(effect->region_of_interest({2 * left, 60, 2 * right, 100}, roi, 0.5),
                      ddt::ofx::ok);
            effect->source =
                cut(source, {int(roi.x1 / 2), int(roi.y1 / 2), int(roi.x2 / 2), int(roi.y2 / 2)});
            ASSERT_EQ(effect->render(effect->output.box, 0.5), ddt::ofx::ok);
            EXPECT_EQ(effect->output.bytes, cut(whole, effect->output.box).bytes)
                << x << " " << source.box.x0;
        }
    }
}

/// Nothing, canonical coordinates, the pixels of a tile.
TEST_F(OpenFx, ARegionThatIsNotTheImagesCountsForNothing) {
    const ImageBuf image = photograph(51, 41, 3, TypeDesc::FLOAT);
    std::vector<char> usual;
    for (const std::optional<Rect>& defined :
         {std::optional<Rect>{}, std::optional<Rect>{{0, 0, 0, 0}},
          std::optional<Rect>{{0, 0, 101, 81}}, std::optional<Rect>{{0, 0, 30, 20}},
          std::optional<Rect>{{10, 0, 50, 40}}, std::optional<Rect>{{0, 0, 51, 41}}}) {
        open(natron, image);
        effect->source_region = {0, 0, 101, 81};
        effect->source_defined = defined;
        effect->output = effect->source;
        effect->output.box = {0, 0, 101, 81};
        effect->output.allocate();
        ASSERT_EQ(effect->render(effect->output.box, 0.5), ddt::ofx::ok);
        if (usual.empty())
            usual = effect->output.bytes;
        EXPECT_EQ(effect->output.bytes, usual);
    }
}

TEST_F(OpenFx, LessThanTheSourcesSizeIsTheSource) {
    open(nuke, photograph(40, 30, 3, TypeDesc::FLOAT), "OfxBitDepthFloat", 100, 60);
    effect->set("width", 20);
    RectD r{};
    ASSERT_EQ(effect->region_of_definition(r), ddt::ofx::ok);
    EXPECT_EQ(r.x1, 100);
    EXPECT_EQ(r.y1, 60);
    EXPECT_EQ(r.x2, 140);
    EXPECT_EQ(r.y2, 90);
    EXPECT_TRUE(effect->is_identity());
}

/// As clipGetImage() of the standard asks.
TEST_F(OpenFx, ASourceWithoutAnImageIsBlack) {
    open(nuke, photograph(40, 30, 3, TypeDesc::FLOAT));
    effect->output = effect->source;
    effect->output.box = {0, 0, 80, 60};
    effect->output.allocate();
    Picture untouched = effect->output;
    effect->source.bytes.clear();
    ASSERT_EQ(effect->render({10, 0, 80, 60}), ddt::ofx::ok);
    EXPECT_TRUE(host->messages.empty());
    EXPECT_EQ(effect->images_held, 0);
    for (int y = 0; y < 60; ++y) {
        EXPECT_EQ(std::memcmp(effect->output.row(y), untouched.row(y), 120), 0);
        const std::vector<char> black(70 * 12, 0);
        EXPECT_EQ(std::memcmp(effect->output.row(y) + 120, black.data(), black.size()), 0);
    }
}

TEST_F(OpenFx, AnImageWithoutPixelsAndAClipWithoutARegionAreBlack) {
    for (const bool no_region : {true, false}) {
        open(nuke, photograph(40, 30, 3, TypeDesc::FLOAT));
        effect->output = effect->source;
        effect->output.box = {0, 0, 80, 60};
        effect->output.allocate();
        if (no_region)
            effect->region_status = ddt::ofx::failed;
        else
            effect->source.box = {0, 0, 0, 0};
        ASSERT_EQ(effect->render({0, 0, 80, 60}), ddt::ofx::ok) << no_region;
        EXPECT_EQ(std::count(effect->output.bytes.begin(), effect->output.bytes.end(), 0),
                  80 * 60 * 12);
        EXPECT_TRUE(host->messages.empty());
        EXPECT_EQ(effect->images_held, 0);
    }
    effect->region_status = ddt::ofx::bad_handle;
    EXPECT_EQ(effect->render({0, 0, 80, 60}), ddt::ofx::failed);
}

TEST_F(OpenFx, NoPixelOfWhatTheHostAsksForIsBlack) {
    for (const auto& [aspect, factor, width] :
         {std::tuple{1.46, 3, 720}, {0.91, 5, 720}, {0.91, 2, 1920}, {1.0, 3, 720}})
        for (const double scale : {1.0, 0.5}) {
            const int proxy = int(width * scale);
            ImageBuf white = images::make(proxy, 8, 3);
            images::fill(white, [](int, int, int) { return 1.0f; });
            open(natron, white);
            effect->clips.at("Source").put("OfxImagePropPixelAspectRatio", aspect);
            effect->source_region = {0, 0, width * aspect, 8 / scale};
            effect->set("scale", factor);
            RectD r{};
            ASSERT_EQ(effect->region_of_definition(r), ddt::ofx::ok);
            effect->output = effect->source;
            effect->output.box = {
                int(std::floor(r.x1 * scale / aspect)), int(std::floor(r.y1 * scale)),
                int(std::ceil(r.x2 * scale / aspect)), int(std::ceil(r.y2 * scale))};
            effect->output.allocate();
            EXPECT_EQ(effect->output.box.width(), proxy * factor) << aspect << " " << scale;
            ASSERT_EQ(effect->render(effect->output.box, scale), ddt::ofx::ok);
            const auto* numbers = reinterpret_cast<const float*>(effect->output.bytes.data());
            const size_t count = effect->output.bytes.size() / sizeof(float);
            EXPECT_EQ(std::count(numbers, numbers + count, 1.0f), ptrdiff_t(count))
                << aspect << " " << scale;
        }
}

/// Of expressions and curves, which hosts need not keep in range.
TEST_F(OpenFx, NumbersOutOfRangeAreTheEndsOfTheRange) {
    for (const Kind& kind : {nuke, resolve}) {
        open(kind, photograph(40, 30, 3, TypeDesc::FLOAT), "OfxBitDepthFloat", -5, 7);
        for (const double scale : {0.99, 0.5, 0.0, -1.0, double(NAN), -double(INFINITY)}) {
            effect->params.at("scale").value = scale;
            RectD r{};
            ASSERT_EQ(effect->region_of_definition(r), ddt::ofx::ok);
            EXPECT_TRUE(r.x1 == -5 && r.y1 == 7 && r.x2 == 35 && r.y2 == 37) << scale;
            EXPECT_TRUE(effect->is_identity()) << scale;
        }
        effect->set("scale", 2);
        render_whole();
        const std::vector<char> usual = effect->output.bytes;
        for (const auto& [name, value] : {std::pair("seed", -3.0),
                                          {"blur", -0.7},
                                          {"blur", double(NAN)},
                                          {"scale_y", double(NAN)}}) {
            const double before = effect->params.at(name).value;
            effect->params.at(name).value = value;
            render_whole();
            EXPECT_EQ(effect->output.bytes, usual) << name << " " << value;
            effect->params.at(name).value = before;
        }
        EXPECT_TRUE(host->messages.empty());
    }
}

TEST_F(OpenFx, AScaleOfOneFillsHoles) {
    ImageBuf image = photograph(40, 30, 3, TypeDesc::FLOAT);
    const float hole[] = {NAN, NAN, NAN};
    for (int x = 12; x < 20; ++x)
        for (int y = 9; y < 17; ++y)
            image.setpixel(x, y, hole);
    ddt::Options options = with_light("linear");
    options.holes = ddt::Holes::fill;
    open(nuke, image);
    effect->set("scale", 1);
    effect->choose("holes", "fill");
    EXPECT_FALSE(effect->is_identity());
    RectD roi{};
    ASSERT_EQ(effect->region_of_interest({3, 4, 5, 6}, roi), ddt::ofx::ok);
    EXPECT_TRUE(roi.x1 == 0 && roi.y1 == 0 && roi.x2 == 40 && roi.y2 == 30);
    render_whole(17);
    EXPECT_TRUE(same_pixels(effect->output, images::enlarged(image, 40, 30, options)));
    effect->source_region = {0, 0, 2147483647, 100}; // without an end
    EXPECT_TRUE(effect->is_identity());
}

TEST_F(OpenFx, AMatteIsLinearWhateverTheLight) {
    for (const char* depth : {"OfxBitDepthFloat", "OfxBitDepthShort"}) {
        const ImageBuf image = photograph(40, 30, 1, type_of(depth));
        const ImageBuf wanted = images::enlarged(image, 80, 60, with_light("linear"));
        for (const char* light : {"linear", "sRGB"}) {
            open(nuke, image, depth);
            effect->choose("light", light);
            render_whole();
            EXPECT_TRUE(same_pixels(effect->output, wanted)) << light << depth;
        }
    }
}

TEST_F(OpenFx, AScaleOfOneIsTheSource) {
    open(nuke, photograph(40, 30, 4, TypeDesc::FLOAT));
    EXPECT_FALSE(effect->is_identity());
    effect->set("scale", 1);
    EXPECT_TRUE(effect->is_identity());
}

TEST_F(OpenFx, AnEndlessSourceIsTheResult) {
    open(nuke, photograph(40, 30, 4, TypeDesc::FLOAT));
    constexpr double all = 2147483647;
    for (const RectD& region : {RectD{-all - 1, -all - 1, all, all}, RectD{0, 0, all, 100},
                                RectD{-all - 1, -all - 1, all, 1080}}) {
        effect->source_region = region;
        RectD r{};
        EXPECT_EQ(effect->region_of_definition(r), ddt::ofx::reply_default);
        EXPECT_EQ(effect->region_of_interest({10, 20, 50, 40}, r), ddt::ofx::reply_default);
        EXPECT_TRUE(effect->is_identity());
    }
    // A large one is asked about by columns and rows of tiles.
    effect->source_region = {-1e6, -1e6, 1e6, 1e6};
    RectD r{};
    ASSERT_EQ(effect->region_of_interest({10, 20, 50, 40}, r), ddt::ofx::ok);
    EXPECT_LE(r.x2 - r.x1, 1024);
    EXPECT_LE(r.y2 - r.y1, 1024);
    EXPECT_TRUE(r.x1 <= 5 && r.x2 >= 25 && r.y1 <= 10 && r.y2 >= 20);
}

TEST_F(OpenFx, DescribesItself) {
    open(nuke, photograph(40, 30, 4, TypeDesc::FLOAT));
    EXPECT_STREQ(host->plugin().identifier, "oiio-ddt:Enlarge");
    EXPECT_EQ(effect->properties.at<std::string>("OfxPropLabel"), "Enlarge (ddt)");
    EXPECT_EQ(effect->clips.size(), 2u);
    for (const char* name : {"scale", "scale_y", "filter", "light", "premultiplication", "device",
                             "cost", "blur", "meshes", "consistency"})
        EXPECT_EQ(effect->params.count(name), 1u) << name;
    for (const auto& [name, param] : effect->params)
        if (param.type == "OfxParamTypeDouble" || param.type == "OfxParamTypeInteger") {
            for (const char* range : {"OfxParamPropMin", "OfxParamPropMax",
                                      "OfxParamPropDisplayMin", "OfxParamPropDisplayMax"})
                EXPECT_EQ(param.properties.values.count(range), 1u) << name << range;
            if (param.type == "OfxParamTypeInteger")
                continue;
            EXPECT_EQ(param.properties.at<int>("OfxParamPropDigits"), 4) << name;
            EXPECT_EQ(param.properties.at<double>("OfxParamPropIncrement"),
                      name == "scale" || name == "scale_y" ? 0.1 : 0.01)
                << name;
        }
}

TEST_F(OpenFx, FailuresAreToldWhereTheHostCan) {
    open(natron, photograph(40, 30, 3, TypeDesc::FLOAT));
    effect->output = effect->source;
    effect->output.depth = "OfxBitDepthNone";
    EXPECT_EQ(effect->render({0, 0, 40, 30}), ddt::ofx::failed);
    EXPECT_EQ(host->messages, std::vector<std::string>{"OfxMessageError"});
    effect->source.bytes.clear();
    EXPECT_EQ(effect->render({0, 0, 40, 30}), ddt::ofx::failed);
    EXPECT_EQ(effect->images_held, 0);
    open(bare, photograph(40, 30, 3, TypeDesc::FLOAT)); // without a message suite
    effect->output = effect->source;
    effect->output.channels = 4;
    effect->output.allocate();
    EXPECT_EQ(effect->render({0, 0, 40, 30}), ddt::ofx::failed);
}

TEST_F(OpenFx, StopsWhenTheHostSaysSo) {
    open(nuke, photograph(900, 900, 3, TypeDesc::FLOAT));
    effect->output = effect->source;
    effect->output.box = {0, 0, 1800, 1800};
    effect->output.allocate();
    for (const bool by_abort : {true, false}) {
        effect->abort_after = by_abort ? 1 : -1;
        host->stop_after = by_abort ? -1 : 1; // its progress bar's button
        EXPECT_EQ(effect->render(effect->output.box), by_abort ? ddt::ofx::ok : ddt::ofx::failed);
        EXPECT_EQ(effect->images_held, 0);
        EXPECT_EQ(host->progress_started, by_abort ? 1 : 2);
        EXPECT_EQ(host->progress_ended, by_abort ? 1 : 2);
        // Of 16 tiles most were not begun.
        const char untouched[] = {0x55, 0x55, 0x55, 0x55};
        EXPECT_EQ(std::memcmp(effect->output.row(0) + 1700 * 12, untouched, 4), 0);
    }
}

} // namespace
