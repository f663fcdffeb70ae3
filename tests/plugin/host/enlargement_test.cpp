// SPDX-License-Identifier: Apache-2.0
// A host's picture is enlarged to the bits that ddt::resize() makes of the same ImageBuf.
#include "plugin/host/enlargement.h"

#include <cmath>
#include <limits>
#include <map>

#include "ddt/points.h"
#include "ddt/resize.h"
#include "plugin/colour/encodings.h"
#include "tests/plugin/images.h"

namespace {

using namespace ddt::host;
using images::bytes;
using OIIO::ImageBuf;
using OIIO::TypeDesc;

Sample sample_of(TypeDesc type) {
    static const std::map<int, Sample> samples{
        {TypeDesc::UINT8, Sample::uint8},   {TypeDesc::UINT16, Sample::uint16},
        {TypeDesc::INT16, Sample::int16},   {TypeDesc::HALF, Sample::half},
        {TypeDesc::FLOAT, Sample::float32}, {TypeDesc::DOUBLE, Sample::float64},
        {TypeDesc::UINT32, Sample::id32}};
    return samples.at(type.basetype);
}

Buffer buffer_of(ImageBuf& image) {
    return {image.localpixels(),
            image.scanline_stride(),
            image.pixel_stride(),
            ptrdiff_t(image.spec().format.size()),
            {image.xbegin(), image.ybegin(), image.xend(), image.yend()},
            sample_of(image.spec().format)};
}

/// An edge in any direction, alpha that goes to 0, and light beyond 1 in floats.
ImageBuf picture(int width, int height, int channels, TypeDesc type) {
    ImageBuf image = images::make(width, height, channels, type);
    if (channels == 2) { // as readers of PNG say
        image.specmod().channelnames = {"Y", "A"};
        image.specmod().alpha_channel = 1;
    }
    const float top = type.is_floating_point() ? 3.0f : 1.0f;
    images::fill(image, [&](int x, int y, int c) {
        const float alpha = float(x % 64) / 63.0f;
        const float colour = images::disc(x, y, 90) * top * (0.5f + 0.2f * float(c));
        if (c == 3 || (channels == 2 && c == 1))
            return alpha;
        return channels == 4 || channels == 2 ? colour * alpha : colour;
    });
    return image;
}

Enlargement work_of(ImageBuf& from, ImageBuf& to, const std::string& light) {
    Enlargement work;
    work.from = buffer_of(from);
    work.to = buffer_of(to);
    work.window = work.from.box;
    work.full = work.to.box;
    work.layout = is_unsigned(work.from.sample) || sample_of(from.spec().format) != Sample::id32
                      ? Layout::usual(from.nchannels())
                      : Layout::ids(from.nchannels());
    const ddt::Options options;
    work.surface = options.surface;
    work.mesh = options.mesh;
    std::string error;
    EXPECT_TRUE(find_meaning(light, work.meaning, error)) << error;
    return work;
}

/// What the filter makes of it; `light` as a host's users write it.
ImageBuf by_filter(ImageBuf& from, const std::string& light, int width, int height) {
    ddt::Options options;
    if (light == "encoded") {
        options.light = "encoded";
        from.specmod().attribute("oiio:ColorSpace", "sRGB");
    } else {
        options.light = light;
    }
    return images::enlarged(from, width, height, options);
}

TEST(Enlargement, TheBitsOfTheFilter) {
    for (const TypeDesc type : {TypeDesc::UINT8, TypeDesc::UINT16, TypeDesc::INT16, TypeDesc::HALF,
                                TypeDesc::FLOAT, TypeDesc::DOUBLE})
        for (const int channels : {1, 2, 3, 4, 5})
            for (const char* light : {"linear", "sRGB", "encoded"}) {
                ImageBuf from = picture(70, 50, channels, type);
                const ImageBuf wanted = by_filter(from, light, 161, 101);
                for (const ddt::Device device : {ddt::Device::cpu, ddt::Device::egl}) {
                    ImageBuf to = images::make(161, 101, channels, type);
                    Enlargement work = work_of(from, to, light);
                    work.device = device;
                    std::string error;
                    const ddt::Outcome outcome = enlarge(work, error);
                    if (device != ddt::Device::cpu && outcome == ddt::Outcome::device_unavailable)
                        continue;
                    ASSERT_EQ(outcome, ddt::Outcome::done) << error;
                    EXPECT_TRUE(bytes(to) == bytes(wanted))
                        << type << " " << channels << " " << light << " " << int(device);
                }
            }
}

TEST(Enlargement, NumbersOfObjectsAreCopied) {
    ImageBuf from = images::make(40, 30, 2, TypeDesc::UINT32);
    auto* ids = static_cast<uint32_t*>(from.localpixels());
    for (size_t i = 0; i < 40 * 30 * 2; ++i)
        ids[i] = 0xff800001u + uint32_t(i / 7);
    const ImageBuf wanted = images::enlarged(from, 100, 90);
    ImageBuf to = images::make(100, 90, 2, TypeDesc::UINT32);
    std::string error;
    ASSERT_EQ(enlarge(work_of(from, to, "linear"), error), ddt::Outcome::done) << error;
    EXPECT_TRUE(bytes(to) == bytes(wanted));
}

TEST(Enlargement, APartIsACropAndNeedsNoMoreThanItSays) {
    ImageBuf from = picture(600, 70, 3, TypeDesc::FLOAT);
    const ImageBuf whole = by_filter(from, "linear", 1200, 140);
    for (const OIIO::ROI roi :
         {OIIO::ROI(0, 60, 0, 60), OIIO::ROI(560, 590, 17, 18), OIIO::ROI(1100, 1200, 60, 140)}) {
        ImageBuf to = images::make(roi, OIIO::ROI(0, 1200, 0, 140), 3);
        Enlargement work = work_of(from, to, "linear");
        work.full = {0, 0, 1200, 140};
        const ddt::Rect box = needed(work.window, work.full, work.to.box);
        EXPECT_LT(box.width(), 400);
        ImageBuf part = images::make(OIIO::ROI(box.x0, box.x1, box.y0, box.y1), from.roi(), 3);
        ASSERT_TRUE(OIIO::ImageBufAlgo::copy(part, from, TypeDesc::FLOAT, part.roi()));
        work.from = buffer_of(part);
        std::string error;
        ASSERT_EQ(enlarge(work, error), ddt::Outcome::done) << error;
        OIIO::ROI colours = roi;
        colours.chend = 3;
        EXPECT_TRUE(bytes(to) == bytes(whole, colours));
    }
}

TEST(Enlargement, UnassociatedAlphaIsMultipliedFirst) {
    ImageBuf from = picture(60, 40, 4, TypeDesc::FLOAT), straight;
    ASSERT_TRUE(OIIO::ImageBufAlgo::unpremult(straight, from));
    ImageBuf again;
    ASSERT_TRUE(OIIO::ImageBufAlgo::premult(again, straight));
    const ImageBuf large = by_filter(again, "sRGB", 120, 80);
    ImageBuf wanted;
    ASSERT_TRUE(OIIO::ImageBufAlgo::unpremult(wanted, large));
    ImageBuf to = images::make(120, 80, 4);
    Enlargement work = work_of(straight, to, "sRGB");
    work.layout.associated = false;
    std::string error;
    ASSERT_EQ(enlarge(work, error), ddt::Outcome::done) << error;
    EXPECT_TRUE(bytes(to) == bytes(wanted));
}

TEST(Enlargement, TheSameSizeIsACopyAndASmallerOneAnError) {
    ImageBuf from = picture(30, 20, 3, TypeDesc::HALF),
             to = images::make(30, 20, 3, TypeDesc::HALF);
    std::string error;
    ASSERT_EQ(enlarge(work_of(from, to, "sRGB"), error), ddt::Outcome::done);
    EXPECT_TRUE(bytes(to) == bytes(from));
    ImageBuf small = images::make(29, 20, 3, TypeDesc::HALF);
    EXPECT_EQ(enlarge(work_of(from, small, "sRGB"), error), ddt::Outcome::bad_job);
    EXPECT_NE(error.find("29 x 20"), std::string::npos) << error;
}

TEST(Enlargement, HolesAreFilledAsTheFilterDoes) {
    if (!ddt::has_delaunay())
        GTEST_SKIP() << "built without GEOS";
    for (const std::string light : {"linear", "sRGB"}) {
        ImageBuf from = picture(60, 40, 3, TypeDesc::FLOAT);
        const float nan = std::numeric_limits<float>::quiet_NaN();
        const float hole[] = {nan, nan, nan}, lacks_red[] = {nan, 0.5f, 0.25f};
        for (int x = 20; x < 31; ++x)
            for (int y = 9; y < 25; ++y)
                from.setpixel(x, y, x == 30 ? lacks_red : hole);
        ddt::Options options;
        options.holes = ddt::Holes::fill;
        options.light = light;
        const ImageBuf wanted = images::enlarged(from, 150, 90, options);
        ImageBuf to = images::make(150, 90, 3);
        Enlargement work = work_of(from, to, light);
        work.holes = options.holes;
        std::string error;
        ASSERT_EQ(enlarge(work, error), ddt::Outcome::done) << error;
        EXPECT_TRUE(bytes(to) == bytes(wanted)) << light;
        for (int y = 0; y < 90; ++y)
            for (int x = 0; x < 150; ++x)
                ASSERT_FALSE(std::isnan(images::value(to, x, y))) << x << " " << y;
        const ddt::Rect all = needed(work.window, work.full, {0, 0, 4, 4}, work.holes);
        EXPECT_EQ(all.width(), 60);
        EXPECT_EQ(all.height(), 40);
    }
}

TEST(Enlargement, LightsHaveNames) {
    Meaning meaning;
    std::string error;
    EXPECT_FALSE(find_meaning("bright", meaning, error));
    EXPECT_EQ(error, "ddt: light \"bright\" is not allowed; allowed are linear, encoded, sRGB, "
                     "Rec709, Gamma1.8, Gamma2.2, Gamma2.4");
}

} // namespace
