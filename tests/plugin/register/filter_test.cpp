// SPDX-License-Identifier: Apache-2.0
// The plugin loaded into a program that calls OpenImageIO's C++ functions.
#include <cmath>
#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <dlfcn.h>

#include <gtest/gtest.h>

#include <OpenImageIO/Imath.h>
#include <OpenImageIO/filter.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

namespace {

using namespace OIIO;

struct Destroy {
    void operator()(Filter2D* filter) const { Filter2D::destroy(filter); }
};
using Handle = std::unique_ptr<Filter2D, Destroy>;

/// A filter that no table lists.
class Foreign final : public Filter2D {
public:
    Foreign() : Filter2D(2.0f, 2.0f) {}
    float operator()(float x, float y) const override { return x * x + y * y < 1.0f ? 1.0f : 0.0f; }
    string_view name() const override { return "ddt"; } // the name is not what counts
};

ImageBuf picture() {
    ImageSpec spec(9, 7, 1, TypeFloat);
    ImageBuf image(spec);
    uint32_t state = 1;
    for (ImageBuf::Iterator<float> p(image); !p.done(); ++p) {
        state = state * 1664525u + 1013904223u;
        p[0] = float(state >> 8) / float(1 << 24);
    }
    return image;
}

std::vector<float> pixels(const ImageBuf& image) {
    std::vector<float> values(size_t(image.spec().image_pixels()) * size_t(image.nchannels()));
    EXPECT_TRUE(image.get_pixels(image.roi(), TypeFloat, values.data())) << image.geterror();
    return values;
}

const ROI large(0, 36, 0, 28, 0, 1, 0, 1);

std::vector<float> resized(const Filter2D* filter) {
    ImageBuf result;
    EXPECT_TRUE(ImageBufAlgo::resize(result, picture(), const_cast<Filter2D*>(filter), large))
        << result.geterror();
    return pixels(result);
}

std::vector<float> resized(string_view name) {
    const ImageBuf result = ImageBufAlgo::resize(picture(), name, 0.0f, large);
    EXPECT_FALSE(result.has_error()) << result.geterror();
    return pixels(result);
}

/// What stock gives has to be taken down before the plugin is there.
class Registered : public testing::Test {
protected:
    static void SetUpTestSuite() {
        stock_filters = Filter2D::num_filters();
        stock_lanczos = resized("lanczos3");
        const Foreign foreign;
        stock_foreign = resized(&foreign);
        stock_null = resized(static_cast<const Filter2D*>(nullptr));
        stock_fit = ImageBufAlgo::fit(picture(), "", 0.0f, "letterbox", true, small);
        plugin = dlopen(DDT_PLUGIN_FILE, RTLD_NOW | RTLD_LOCAL);
        ASSERT_NE(plugin, nullptr) << dlerror();
    }

    inline static const ROI small{0, 4, 0, 3, 0, 1, 0, 1};
    inline static ImageBuf stock_fit;
    inline static void* plugin;

    inline static int stock_filters;
    inline static std::vector<float> stock_lanczos, stock_foreign, stock_null;
};

TEST_F(Registered, SaysWhatWasRedirected) {
    auto* redirects = reinterpret_cast<const char* (*)()>(dlsym(plugin, "ddt_redirects"));
    ASSERT_NE(redirects, nullptr) << dlerror();
    const std::string text = redirects();
    EXPECT_NE(text.find("filter functions redirected in "), std::string::npos) << text;
    // As Ubuntu's is linked.
    if (text.find("-Bsymbolic-functions") == std::string::npos) {
        EXPECT_EQ(text.find("missed"), std::string::npos) << text;
    }
}

TEST_F(Registered, ListsItsFiltersAfterThoseOfStock) {
    std::set<std::string> ours;
    for (int i = stock_filters; i < Filter2D::num_filters(); ++i) {
        FilterDesc copy;
        Filter2D::get_filterdesc(i, &copy);
        EXPECT_STREQ(copy.name, Filter2D::get_filterdesc(i).name);
        EXPECT_EQ(copy.dim, 2);
        EXPECT_GT(copy.width, 0.0f);
        ours.insert(copy.name);
    }
    for (const char* name : {"ddt", "ddt-linear", "ddt-sharp"})
        EXPECT_EQ(ours.count(name), 1u) << name;
    EXPECT_STREQ(Filter2D::get_filterdesc(0).name, "box");
}

TEST_F(Registered, CreatesFiltersThatCanBeEvaluated) {
    const Handle filter(Filter2D::create("ddt-linear,light=encoded", 2.0f, 4.0f));
    ASSERT_NE(filter, nullptr);
    EXPECT_EQ(filter->name(), "ddt-linear,light=encoded");
    EXPECT_EQ(filter->width(), 2.0f);
    EXPECT_EQ(filter->height(), 4.0f);
    EXPECT_TRUE(filter->separable());
    EXPECT_EQ((*filter)(0.0f, 0.0f), 1.0f);
    EXPECT_EQ((*filter)(0.5f, 0.0f), 0.5f);
    EXPECT_EQ((*filter)(0.5f, -1.0f), 0.25f);
    EXPECT_EQ(filter->xfilt(-1.5f), 0.0f);
    EXPECT_EQ(filter->yfilt(1.0f), 0.5f);
}

TEST_F(Registered, CreatesNothingByNamesThatAreNotFilters) {
    EXPECT_EQ(Filter2D::create("ddt,light=encoded,nonsense=1", 2.0f, 2.0f), nullptr);
    EXPECT_EQ(Filter2D::create("ddtx", 2.0f, 2.0f), nullptr);
    EXPECT_EQ(Filter2D::create("", 2.0f, 2.0f), nullptr);
    EXPECT_NE(Handle(Filter2D::create("mitchell", 4.0f, 4.0f)), nullptr);
}

TEST_F(Registered, AFilterObjectGivesWhatItsNameGives) {
    const Handle filter(Filter2D::create("ddt", 2.0f, 2.0f));
    EXPECT_EQ(resized(filter.get()), resized("ddt"));
    EXPECT_NE(resized("ddt"), resized("ddt-linear"));
    EXPECT_NE(resized("ddt"), resized("triangle"));
    EXPECT_NE(resized("ddt,scheme=pixel"), resized("ddt"));
}

TEST_F(Registered, OtherFiltersGiveTheSameBits) {
    EXPECT_EQ(resized("lanczos3"), stock_lanczos);
    const Foreign foreign;
    EXPECT_EQ(resized(&foreign), stock_foreign);
    EXPECT_EQ(resized(static_cast<const Filter2D*>(nullptr)), stock_null);
}

TEST_F(Registered, OptionsReachEveryFunctionThatTakesAName) {
    const std::string bad = "ddt,nonsense=1";
    ImageBuf resize, fit, warp, rotate, rotate_around;
    const Imath::M33f M(2, 0, 0, 0, 2, 0, 0, 0, 1);
    EXPECT_FALSE(ImageBufAlgo::resize(resize, picture(), bad, 0.0f, large));
    EXPECT_FALSE(ImageBufAlgo::fit(fit, picture(), bad, 0.0f, "letterbox", true, large));
    EXPECT_FALSE(ImageBufAlgo::warp(warp, picture(), M, bad));
    EXPECT_FALSE(ImageBufAlgo::rotate(rotate, picture(), 0.5f, bad));
    EXPECT_FALSE(ImageBufAlgo::rotate(rotate_around, picture(), 0.5f, 1.0f, 2.0f, bad));
    for (const ImageBuf* result : {&resize, &fit, &warp, &rotate, &rotate_around}) {
        const std::string error = result->geterror();
        EXPECT_NE(error.find("nonsense"), std::string::npos) << error;
        EXPECT_NE(error.find("light"), std::string::npos) << error; // one that is allowed
        EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    }
}

TEST_F(Registered, ExactFitCentresTheImage) {
    // 9 x 7 fits 36 x 36 at a factor of 4, 28 high: 4 black rows above and below.
    const ROI square(0, 36, 0, 36, 0, 1, 0, 1);
    const ImageBuf fitted = ImageBufAlgo::fit(picture(), "ddt", 0.0f, "letterbox", true, square);
    ASSERT_FALSE(fitted.has_error()) << fitted.geterror();
    EXPECT_EQ(fitted.roi(), square);
    const std::vector<float> plain = resized("ddt"), values = pixels(fitted);
    for (int y = 0; y < 36; ++y)
        for (int x = 0; x < 36; ++x) {
            const float expected = y < 4 || y >= 32 ? 0.0f : plain[size_t(x) + 36 * size_t(y - 4)];
            ASSERT_NEAR(values[size_t(x) + 36 * size_t(y)], expected, 1e-5f) << x << " " << y;
        }
}

TEST_F(Registered, FitFillsAsAsked) {
    const ROI square(0, 36, 0, 36, 0, 1, 0, 1);
    for (const bool exact : {false, true}) {
        // Filled to the height the factor is 36/7; filled to the width it is 4.
        const ImageBuf height = ImageBufAlgo::fit(picture(), "ddt", 0.0f, "height", exact, square);
        const ImageBuf width = ImageBufAlgo::fit(picture(), "ddt", 0.0f, "width", exact, square);
        EXPECT_GT(height.getchannel(18, 1, 0, 0), 0.0f) << exact;
        EXPECT_EQ(width.getchannel(18, 1, 0, 0, ImageBuf::WrapBlack), 0.0f) << exact;
    }
}

TEST_F(Registered, FitFillsHolesWhereNothingIsEnlarged) {
    ImageBuf holed = picture();
    const float nan = std::nanf("");
    holed.setpixel(3, 3, cspan<float>(&nan, 1));
    for (const bool exact : {false, true}) {
        const ImageBuf fitted =
            ImageBufAlgo::fit(holed, "ddt,holes=fill", 0.0f, "letterbox", exact, holed.roi());
        ASSERT_FALSE(fitted.has_error()) << fitted.geterror();
        EXPECT_TRUE(std::isfinite(fitted.getchannel(3, 3, 0, 0))) << exact;
        EXPECT_EQ(fitted.getchannel(5, 2, 0, 0), holed.getchannel(5, 2, 0, 0)) << exact;
    }
}

TEST_F(Registered, TheFrameStaysBlackWhereASourceHasNoPixels) {
    ImageBuf crop = picture();
    ImageSpec& spec = crop.specmod();
    spec.x = 2;
    spec.y = 1;
    spec.full_width = 12;
    spec.full_height = 10;
    const ROI frame(0, 48, 0, 40, 0, 1, 0, 1);
    const ImageBuf fitted = ImageBufAlgo::fit(crop, "ddt", 0.0f, "letterbox", false, frame);
    ASSERT_FALSE(fitted.has_error()) << fitted.geterror();
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 48; ++x) {
            const bool shown = x >= 8 && x < 44 && y >= 4 && y < 32;
            EXPECT_EQ(fitted.getchannel(x, y, 0, 0) != 0.0f, shown) << x << " " << y;
        }
}

TEST_F(Registered, AFitOfNoSizeLeavesNothing) {
    ImageBuf fitted;
    const ROI endless(0, 1 << 28, 0, 1 << 28, 0, 1, 0, 1);
    EXPECT_FALSE(ImageBufAlgo::fit(fitted, picture(), "ddt", 0.0f, "letterbox", false, endless));
    EXPECT_FALSE(fitted.initialized());
    const std::string error = fitted.geterror();
    EXPECT_EQ(error.find("ddt: the output of 268435456 x 268435456"), 0u) << error;
}

TEST_F(Registered, APictureThatFillsAFrameBeyondAnySizeLeavesNothing) {
    // The frame could be: it is one pixel wide.
    ImageBuf fitted;
    const ROI slit(0, 1, 0, 1 << 24, 0, 1, 0, 1);
    EXPECT_FALSE(ImageBufAlgo::fit(fitted, picture(), "ddt", 0.0f, "height", false, slit));
    EXPECT_FALSE(fitted.initialized());
    const std::string error = fitted.geterror();
    EXPECT_EQ(error.find("ddt: the output of 21570"), 0u) << error;
}

TEST_F(Registered, AFitWhoseResizeFailsFails) {
    // The limit has room for both images, and not for the floats that holes are filled in.
    const ImageBuf source(ImageSpec(300, 300, 3, TypeUInt8));
    const ROI square(0, 450, 0, 450, 0, 1, 0, 3);
    int before = 0;
    OIIO::getattribute("limits:imagesize_MB", before);
    OIIO::attribute("limits:imagesize_MB", 1);
    ImageBuf fitted;
    const bool done =
        ImageBufAlgo::fit(fitted, source, "ddt,holes=fill", 0.0f, "letterbox", false, square);
    OIIO::attribute("limits:imagesize_MB", before);
    EXPECT_FALSE(done);
    EXPECT_FALSE(fitted.initialized());
    const std::string error = fitted.geterror();
    EXPECT_NE(error.find("limits:imagesize_MB"), std::string::npos) << error;
}

TEST_F(Registered, AnExactFitThatShrinksIsOpenImageIOs) {
    // Its edges are not darkened by what is beyond them.
    const ImageBuf fitted = ImageBufAlgo::fit(picture(), "ddt", 0.0f, "letterbox", true, small);
    ASSERT_FALSE(fitted.has_error()) << fitted.geterror();
    EXPECT_EQ(pixels(fitted), pixels(stock_fit));
}

TEST_F(Registered, FitsToWholePixelsLikeOpenImageIO) {
    for (const char* fillmode : {"letterbox", "width", "height"})
        for (const ROI& frame : {ROI(3, 40, 5, 33, 0, 1, 0, 1), ROI(0, 36, 0, 28, 0, 1, 0, 1),
                                 ROI(0, 9, 0, 7, 0, 1, 0, 1), ROI(0, 20, 0, 60, 0, 1, 0, 1)}) {
            const ImageBuf ours = ImageBufAlgo::fit(picture(), "ddt", 0.0f, fillmode, false, frame);
            const ImageBuf stock =
                ImageBufAlgo::fit(picture(), "lanczos3", 0.0f, fillmode, false, frame);
            ASSERT_FALSE(ours.has_error()) << ours.geterror();
            EXPECT_EQ(ours.roi(), stock.roi()) << fillmode;
            EXPECT_EQ(ours.roi_full(), stock.roi_full()) << fillmode;
        }
}

TEST_F(Registered, StWarpRefusesOurFilters) {
    ImageBuf st(ImageSpec(4, 4, 2, TypeFloat));
    ImageBufAlgo::fill(st, {0.5f, 0.5f});
    const Handle filter(Filter2D::create("ddt", 2.0f, 2.0f));
    const Filter2D* pointer = filter.get();
    ImageBuf named = ImageBufAlgo::st_warp(picture(), st, "ddt");
    ImageBuf pointed = ImageBufAlgo::st_warp(picture(), st, pointer);
    ImageBuf into_by_name, into_by_pointer;
    EXPECT_FALSE(ImageBufAlgo::st_warp(into_by_name, picture(), st, "ddt"));
    EXPECT_FALSE(ImageBufAlgo::st_warp(into_by_pointer, picture(), st, pointer));
    for (const ImageBuf* result : {&named, &pointed, &into_by_name, &into_by_pointer}) {
        EXPECT_TRUE(result->has_error());
        EXPECT_NE(result->geterror().find("st_warp"), std::string::npos);
    }
    EXPECT_FALSE(ImageBufAlgo::st_warp(picture(), st, "triangle").has_error());
}

TEST_F(Registered, RotateIsWarpToTheBit) {
    Imath::M33f M;
    M.translate(Imath::V2f(-4.5f, -3.5f));
    M.rotate(0.3f);
    M *= Imath::M33f().translate(Imath::V2f(4.5f, 3.5f));
    const ImageBuf warped =
        ImageBufAlgo::warp(picture(), M, "ddt", 0.0f, false, ImageBuf::WrapBlack);
    EXPECT_EQ(pixels(ImageBufAlgo::rotate(picture(), 0.3f, "ddt")), pixels(warped));
    EXPECT_EQ(pixels(ImageBufAlgo::rotate(picture(), 0.3f, 4.5f, 3.5f, "ddt")), pixels(warped));
}

TEST_F(Registered, RotateAndWarpAgree) {
    const float quarter = 1.5707963f;
    const Imath::M33f M(0, 1, 0, -1, 0, 0, 8, -1, 1); // about (4.5, 3.5)
    const ImageBuf rotated = ImageBufAlgo::rotate(picture(), quarter, "ddt");
    const ImageBuf warped = ImageBufAlgo::warp(picture(), M, "ddt");
    ASSERT_FALSE(rotated.has_error()) << rotated.geterror();
    ASSERT_FALSE(warped.has_error()) << warped.geterror();
    const std::vector<float> a = pixels(rotated), b = pixels(warped);
    ASSERT_EQ(a.size(), b.size());
    for (size_t i = 0; i < a.size(); ++i)
        EXPECT_NEAR(a[i], b[i], 1e-4f) << i;
}

} // namespace
