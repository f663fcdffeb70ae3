// SPDX-License-Identifier: Apache-2.0
// The effect, loaded from its bundle into hosts of several kinds.
#include <cmath>
#include <filesystem>
#include <iterator>
#include <thread>

#include "ddt/resize.h"
#include "plugin/colour/space_light.h"
#include "tests/plugin/images.h"
#include "tests/plugin/openfx/mini_host.h"

namespace {

using namespace mini;
using ddt::ofx::RectD;
using OIIO::ImageBuf;
using OIIO::TypeDesc;

/// What these hosts are known to differ in.
const Kind nuke{"uk.co.thefoundry.nuke", 1, true, true, true, {"OfxPropPluginDescription"}};
const Kind natron{"fr.inria.Natron", 1, true, true, true, {}};
const Kind resolve{"DaVinciResolve", 0, false, false, false, {"OfxPropPluginDescription"}};

TypeDesc type_of(const std::string& depth) {
    return depth == "OfxBitDepthFloat"   ? TypeDesc::FLOAT
           : depth == "OfxBitDepthHalf"  ? TypeDesc::HALF
           : depth == "OfxBitDepthShort" ? TypeDesc::UINT16
                                         : TypeDesc::UINT8;
}

ImageBuf photograph(int width, int height, int channels, TypeDesc type) {
    ImageBuf image = images::make(width, height, channels, type);
    images::fill(image, [&](int x, int y, int c) {
        const float alpha = channels == 4 ? float(x % 50) / 49.0f : 1.0f;
        return c == 3 ? alpha : images::disc(x, y, 80) * (1 - 0.2f * float(c)) * alpha;
    });
    return image;
}

/// Put an image, whose rows run downwards, into a host's picture with the corner (x0, y0).
Picture picture_of(const ImageBuf& image, const std::string& depth, int x0, int y0, bool reversed) {
    Picture p;
    p.box = {x0, y0, x0 + image.spec().width, y0 + image.spec().height};
    p.channels = image.nchannels();
    p.depth = depth;
    p.rows_reversed = reversed;
    p.allocate();
    for (int y = 0; y < image.spec().height; ++y)
        std::memcpy(p.row(p.box.y1 - 1 - y), image.pixeladdr(0, y), p.row_bytes());
    return p;
}

bool same_pixels(Picture& p, const ImageBuf& wanted) {
    for (int y = 0; y < wanted.spec().height; ++y)
        if (std::memcmp(p.row(p.box.y1 - 1 - y), wanted.pixeladdr(0, y), p.row_bytes()) != 0)
            return false;
    return true;
}

class OpenFx : public testing::Test {
protected:
    /// A loaded host with an instance whose source is `image` with the corner (x0, y0).
    void open(const Kind& kind, const ImageBuf& image,
              const std::string& depth = "OfxBitDepthFloat", int x0 = 0, int y0 = 0,
              bool reversed = false) {
        effect.reset();
        host = std::make_unique<Host>(kind, DDT_OFX_BUNDLE);
        host->plugin().set_host(host->abi());
        ASSERT_EQ(host->act("OfxActionLoad"), ddt::ofx::ok);
        effect = std::make_unique<Effect>(*host);
        effect->describe();
        effect->source = picture_of(image, depth, x0, y0, reversed);
        const Rect& b = effect->source.box;
        effect->source_region = {double(b.x0), double(b.y0), double(b.x1), double(b.y1)};
    }
    /// Render the whole of the region of definition, in parts of `step` pixels.
    void render_whole(int step = 100000) {
        RectD r{};
        ASSERT_EQ(effect->region_of_definition(r), ddt::ofx::ok);
        effect->output = effect->source;
        effect->output.box = {int(r.x1), int(r.y1), int(r.x2), int(r.y2)};
        effect->output.allocate();
        const Rect& b = effect->output.box;
        for (int y = b.y0; y < b.y1; y += step)
            for (int x = b.x0; x < b.x1; x += step)
                ASSERT_EQ(
                    effect->render({x, y, std::min(x + step, b.x1), std::min(y + step, b.y1)}),
                    ddt::ofx::ok);
        EXPECT_EQ(effect->images_held, 0);
        EXPECT_EQ(effect->foreign_calls, 0);
    }
    std::unique_ptr<Host> host;
    std::unique_ptr<Effect> effect;
};

ddt::Options with_light(const char* light) {
    ddt::Options options;
    options.light = light;
    return options;
}

TEST_F(OpenFx, TheFiltersBitsInEveryDepthAndComponent) {
    for (const Kind& kind : {nuke, natron})
        for (const char* depth :
             {"OfxBitDepthFloat", "OfxBitDepthHalf", "OfxBitDepthShort", "OfxBitDepthByte"})
            for (const int channels : {3, 4})
                for (const char* light : {"linear", "sRGB"}) {
                    const ImageBuf image = photograph(60, 44, channels, type_of(depth));
                    open(kind, image, depth, 0, 0, channels == 3);
                    effect->choose("light", light);
                    render_whole();
                    EXPECT_TRUE(same_pixels(effect->output,
                                            images::enlarged(image, 120, 88, with_light(light))))
                        << kind.name << depth << channels << light;
                }
}

TEST_F(OpenFx, PiecesAreCropsAndOnlyTheRegionOfInterestIsRead) {
    const ImageBuf image = photograph(600, 300, 3, TypeDesc::FLOAT);
    const ImageBuf wanted = images::enlarged(image, 1200, 600, with_light("linear"));
    open(nuke, image);
    render_whole(157);
    EXPECT_TRUE(same_pixels(effect->output, wanted));
    // What is outside of the region of interest may as well not be there.
    const Picture whole = effect->source, large = effect->output;
    RectD roi{};
    ASSERT_EQ(effect->region_of_interest({1100, 20, 1150, 40}, roi), ddt::ofx::ok);
    Picture part = whole;
    part.box = {int(roi.x1), int(roi.y1), int(roi.x2), int(roi.y2)};
    ASSERT_LT(part.box.width(), 400);
    part.allocate();
    Picture from = whole;
    for (int y = part.box.y0; y < part.box.y1; ++y)
        std::memcpy(part.row(y), from.row(y) + size_t(part.box.x0) * 12, part.row_bytes());
    effect->source = part;
    effect->output.box = {1100, 20, 1150, 40};
    effect->output.allocate();
    ASSERT_EQ(effect->render(effect->output.box), ddt::ofx::ok);
    Picture all = large;
    for (int y = 20; y < 40; ++y)
        EXPECT_EQ(std::memcmp(effect->output.row(y), all.row(y) + 1100 * 12, 50 * 12), 0);
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
        }
}

TEST_F(OpenFx, TheContextsAreFilterAndGeneral) {
    Host host_(natron, DDT_OFX_BUNDLE);
    host_.plugin().set_host(host_.abi());
    ASSERT_EQ(host_.act("OfxActionLoad"), ddt::ofx::ok);
    for (const auto& [context, status] :
         {std::pair("OfxImageEffectContextFilter", ddt::ofx::ok),
          {"OfxImageEffectContextGeneral", ddt::ofx::ok},
          {"OfxImageEffectContextGenerator", ddt::ofx::missing_host_feature}}) {
        Effect described(host_);
        Properties in;
        in.put("OfxImageEffectPropContext", std::string(context));
        EXPECT_EQ(host_.act("OfxImageEffectActionDescribeInContext", &described, &in), status);
        EXPECT_EQ(described.clips.size(), status == ddt::ofx::ok ? 2u : 0u) << context;
    }
}

TEST_F(OpenFx, ActionsInAnyOrderAndOfNobody) {
    Host early(nuke, DDT_OFX_BUNDLE);
    early.plugin().set_host(nullptr);
    EXPECT_EQ(early.act("OfxActionUnload"), ddt::ofx::ok);
    Effect none(early);
    EXPECT_EQ(early.act("OfxActionDescribe", &none), ddt::ofx::failed);
    EXPECT_EQ(early.act("OfxActionLoad"), ddt::ofx::missing_host_feature);
    early.plugin().set_host(early.abi());
    early.give_suites = false;
    EXPECT_EQ(early.act("OfxActionLoad"), ddt::ofx::missing_host_feature);
    early.give_suites = true;
    EXPECT_EQ(early.act("OfxActionLoad"), ddt::ofx::ok);
    EXPECT_EQ(early.act("OfxActionLoad"), ddt::ofx::ok);
    EXPECT_EQ(early.act("OfxActionOfTheFuture", &none), ddt::ofx::reply_default);
    EXPECT_EQ(early.act("OfxActionDescribe"), ddt::ofx::reply_default);
    // No clips yet.
    EXPECT_EQ(none.render({0, 0, 1, 1}), ddt::ofx::failed);
    EXPECT_FALSE(none.is_identity());
    EXPECT_EQ(early.act("OfxActionUnload"), ddt::ofx::ok);
    EXPECT_EQ(none.render({0, 0, 1, 1}), ddt::ofx::failed);
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
    open(resolve, photograph(40, 30, 3, TypeDesc::FLOAT)); // without a message suite
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
    effect->abort_after = 1;
    EXPECT_EQ(effect->render(effect->output.box), ddt::ofx::ok);
    EXPECT_EQ(effect->images_held, 0);
    EXPECT_EQ(host->progress_started, 1);
    EXPECT_EQ(host->progress_ended, 1);
    // Of 16 tiles most were not begun.
    const char untouched[] = {0x55, 0x55, 0x55, 0x55};
    EXPECT_EQ(std::memcmp(effect->output.row(0) + 1700 * 12, untouched, 4), 0);
}

size_t threads_here() {
    const std::filesystem::directory_iterator tasks("/proc/self/task"), end;
    return size_t(std::distance(tasks, end));
}

TEST_F(OpenFx, TwoThreadsAtOnceAndNoneLeft) {
    const ImageBuf image = photograph(300, 200, 4, TypeDesc::FLOAT);
    const ImageBuf wanted = images::enlarged(image, 600, 400, with_light("linear"));
    open(natron, image);
    effect->choose("device", "cpu"); // a GPU's thread stays
    effect->output = effect->source;
    effect->output.box = {0, 0, 600, 400};
    effect->output.allocate();
    const size_t before = threads_here();
    std::thread other([&] { EXPECT_EQ(effect->render({0, 0, 600, 200}), ddt::ofx::ok); });
    EXPECT_EQ(effect->render({0, 200, 600, 400}), ddt::ofx::ok);
    other.join();
    EXPECT_EQ(threads_here(), before);
    EXPECT_TRUE(same_pixels(effect->output, wanted));
}

} // namespace
