// SPDX-License-Identifier: Apache-2.0
// A host's picture is enlarged to the bits that ddt::resize() makes of the same ImageBuf.
#include "plugin/host/enlargement.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>

#include "ddt/resize.h"
#include "plugin/colour/encodings.h"
#include "plugin/host/request.h"
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
    work.place = onto(work.from.box, work.to.box);
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
    for (const bool tall : {false, true}) {
        const auto turned = [&](OIIO::ROI r) {
            return tall ? images::window(r.ybegin, r.yend, r.xbegin, r.xend) : r;
        };
        const OIIO::ROI size = turned(images::window(0, 1200, 0, 140));
        ImageBuf from = picture(size.xend / 2, size.yend / 2, 3, TypeDesc::FLOAT);
        const ImageBuf whole = by_filter(from, "linear", size.xend, size.yend);
        for (const OIIO::ROI along :
             {images::window(0, 60, 0, 60), images::window(513, 543, 17, 18),
              images::window(1100, 1200, 60, 140)}) {
            const OIIO::ROI roi = turned(along);
            ImageBuf to = images::make(roi, size, 3);
            Enlargement work = work_of(from, to, "linear");
            work.place = onto(work.from.box, {0, 0, size.xend, size.yend});
            const ddt::Rect box = needed(work.place, work.to.box);
            EXPECT_LT(tall ? box.height() : box.width(), 400);
            ImageBuf part =
                images::make(images::window(box.x0, box.x1, box.y0, box.y1), from.roi(), 3);
            ASSERT_TRUE(OIIO::ImageBufAlgo::copy(part, from, TypeDesc::FLOAT, part.roi()));
            work.from = buffer_of(part);
            std::string error;
            ASSERT_EQ(enlarge(work, error), ddt::Outcome::done) << error;
            EXPECT_TRUE(bytes(to) == bytes(whole, roi)) << tall << " " << along;
        }
    }
}

TEST(Enlargement, WhatTheBufferLacksCountsAsZero) {
    for (const OIIO::ROI there : {images::window(5, 40, 0, 30), images::window(0, 33, 0, 30),
                                  images::window(0, 40, 4, 30), images::window(0, 40, 0, 21)}) {
        ImageBuf from = picture(40, 30, 3, TypeDesc::FLOAT);
        ImageBuf part = images::make(there, from.roi(), 3), padded = images::make(40, 30, 3);
        for (ImageBuf* image : {&part, &padded})
            images::fill(*image, [&](int x, int y, int c) {
                return there.contains(x, y) ? images::value(from, x, y, c) : 0.0f;
            });
        const ImageBuf wanted = by_filter(padded, "linear", 90, 70);
        ImageBuf to = images::make(90, 70, 3);
        Enlargement work = work_of(from, to, "linear");
        std::string error;
        // Memory that stays for the next call has all pixels then.
        ASSERT_EQ(enlarge(work, error), ddt::Outcome::done) << error;
        work.from = buffer_of(part);
        ASSERT_EQ(enlarge(work, error), ddt::Outcome::done) << error;
        EXPECT_TRUE(bytes(to) == bytes(wanted)) << there;
    }
}

TEST(Enlargement, CodesAreStoredWithTheGapsBetweenPixels) {
    ImageBuf from = picture(40, 30, 3, TypeDesc::UINT8);
    const ImageBuf wanted = by_filter(from, "sRGB", 100, 70);
    std::vector<uint8_t> memory(100 * 70 * 4, 0xee), packed;
    ImageBuf to = images::make(100, 70, 3, TypeDesc::UINT8);
    Enlargement work = work_of(from, to, "sRGB");
    work.to = {memory.data(), 400, 4, 1, work.to.box, Sample::uint8};
    std::string error;
    ASSERT_EQ(enlarge(work, error), ddt::Outcome::done) << error;
    for (size_t i = 0; i < memory.size(); ++i)
        if (i % 4 < 3)
            packed.push_back(memory[i]);
        else
            ASSERT_EQ(memory[i], 0xee) << i;
    EXPECT_TRUE(packed == bytes(wanted));
}

TEST(Enlargement, ChannelsMayRunBackwards) {
    ImageBuf from = picture(40, 30, 3, TypeDesc::UINT8);
    const ImageBuf wanted = by_filter(from, "sRGB", 100, 70);
    ImageBuf to = images::make(100, 70, 3, TypeDesc::UINT8);
    Enlargement work = work_of(from, to, "sRGB");
    std::vector<uint8_t> memory(100 * 70 * 3);
    work.to = {memory.data() + 2, 300, 3, -1, work.to.box, Sample::uint8}; // blue first
    std::string error;
    ASSERT_EQ(enlarge(work, error), ddt::Outcome::done) << error;
    for (size_t i = 0; i < memory.size(); i += 3)
        std::swap(memory[i], memory[i + 2]);
    EXPECT_TRUE(memory == bytes(wanted));
}

TEST(Enlargement, RowsOfFloatsMayBeginAnywhere) {
    ImageBuf from = picture(40, 30, 3, TypeDesc::FLOAT);
    const std::vector<unsigned char> wanted = bytes(by_filter(from, "linear", 100, 70));
    ImageBuf to = images::make(100, 70, 3, TypeDesc::FLOAT);
    Enlargement work = work_of(from, to, "linear");
    constexpr size_t row = 100 * 3 * sizeof(float);
    for (const size_t gap : {0, 2, 4}) {
        std::vector<unsigned char> memory(70 * (row + gap) + 4), dense;
        work.to = {memory.data(), ptrdiff_t(row + gap), 12, 4, work.to.box, Sample::float32};
        std::string error;
        ASSERT_EQ(enlarge(work, error), ddt::Outcome::done) << error;
        for (size_t y = 0; y < 70; ++y) {
            const auto begin = memory.begin() + ptrdiff_t(y * (row + gap));
            dense.insert(dense.end(), begin, begin + row);
        }
        EXPECT_TRUE(dense == wanted) << gap;
    }
}

TEST(Enlargement, TellsHowFarItIsAndStopsWhenTold) {
    ImageBuf from = picture(40, 30, 3, TypeDesc::HALF),
             to = images::make(100, 70, 3, TypeDesc::HALF);
    Enlargement work = work_of(from, to, "sRGB");
    std::vector<float> shares;
    bool going = true;
    work.progress = [&](float share) {
        shares.push_back(share);
        return going;
    };
    std::string error;
    ASSERT_EQ(enlarge(work, error), ddt::Outcome::done) << error;
    ASSERT_FALSE(shares.empty());
    EXPECT_EQ(shares.back(), 1.0f);
    going = false;
    EXPECT_EQ(enlarge(work, error), ddt::Outcome::cancelled);
    EXPECT_EQ(error, "ddt: cancelled");
}

TEST(Enlargement, UsesNoMoreThreadsThanItsProgramAllows) {
    const int usual = threads_within(std::numeric_limits<uint64_t>::max());
    EXPECT_GE(usual, 1);
    EXPECT_EQ(threads_within(0), 1);
    EXPECT_EQ(threads_within(1), 1);
    EXPECT_EQ(threads_within(uint64_t(usual)), usual);
    EXPECT_EQ(threads_within(uint64_t(usual) + 1), usual);
}

TEST(Enlargement, UnassociatedAlphaIsMultipliedFirst) {
    ImageBuf from = picture(60, 40, 4, TypeDesc::FLOAT), straight;
    ASSERT_TRUE(OIIO::ImageBufAlgo::unpremult(straight, from));
    ImageBuf again;
    ASSERT_TRUE(OIIO::ImageBufAlgo::premult(again, straight));
    for (const char* light : {"sRGB", "linear", "encoded"}) {
        const ImageBuf large = by_filter(again, light, 120, 80);
        ImageBuf wanted;
        ASSERT_TRUE(OIIO::ImageBufAlgo::unpremult(wanted, large));
        ImageBuf to = images::make(120, 80, 4);
        Enlargement work = work_of(straight, to, light);
        work.layout.associated = false;
        std::string error;
        ASSERT_EQ(enlarge(work, error), ddt::Outcome::done) << error;
        EXPECT_TRUE(bytes(to) == bytes(wanted)) << light;
    }
}

TEST(Enlargement, TheSameSizeIsACopyAndASmallerOneAnError) {
    ImageBuf from = picture(30, 20, 3, TypeDesc::HALF),
             to = images::make(30, 20, 3, TypeDesc::HALF);
    std::string error;
    ASSERT_EQ(enlarge(work_of(from, to, "sRGB"), error), ddt::Outcome::done);
    EXPECT_TRUE(bytes(to) == bytes(from));
    // Of numbers of another kind, the values.
    ImageBuf floats = images::make(30, 20, 3, TypeDesc::FLOAT), values;
    ASSERT_EQ(enlarge(work_of(from, floats, "sRGB"), error), ddt::Outcome::done);
    ASSERT_TRUE(values.copy(from, TypeDesc::FLOAT));
    EXPECT_TRUE(bytes(floats) == bytes(values));
    ImageBuf small = images::make(29, 20, 3, TypeDesc::HALF);
    EXPECT_EQ(enlarge(work_of(from, small, "sRGB"), error), ddt::Outcome::bad_job);
    EXPECT_NE(error.find("29 x 20"), std::string::npos) << error;
    ImageBuf large = images::make(60, 40, 3, TypeDesc::HALF);
    for (const ddt::Rect& full : {ddt::Rect{0, 0, 59, 40}, {0, 0, 60, 39}, {1, 0, 60, 40}}) {
        Enlargement work = work_of(from, large, "sRGB");
        work.place = onto(work.from.box, full);
        EXPECT_EQ(enlarge(work, error), ddt::Outcome::bad_job);
        EXPECT_EQ(error, "ddt: the part wanted lies outside the result");
    }
}

/// A part of the copy, from a picture that lies elsewhere than the result.
TEST(Enlargement, ACopyTakesThePixelsThatNeededNames) {
    const OIIO::ROI window = images::window(-7, 23, 40, 60),
                    full = images::window(100, 130, -9, 11);
    const OIIO::ROI part = images::window(110, 118, -4, 8);
    ImageBuf from = images::make(window, window, 3, TypeDesc::HALF);
    images::fill(from, [](int x, int y, int c) { return float(x) + 0.25f * float(y) + float(c); });
    ImageBuf to = images::make(part, full, 3, TypeDesc::HALF);
    Enlargement work = work_of(from, to, "sRGB");
    work.place = onto(work.from.box, {100, -9, 130, 11});
    const ddt::Rect box = needed(work.place, work.to.box);
    EXPECT_TRUE((box == ddt::Rect{3, 45, 11, 57}));
    std::string error;
    ASSERT_EQ(enlarge(work, error), ddt::Outcome::done) << error;
    EXPECT_TRUE(bytes(to) == bytes(from, images::window(3, 11, 45, 57)));
}

TEST(Enlargement, HolesAreFilledAsTheFilterDoes) {
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
        const ddt::Rect all = needed(work.place, {0, 0, 4, 4}, work.holes);
        EXPECT_EQ(all.width(), 60);
        EXPECT_EQ(all.height(), 40);
    }
}

/// A picture with a hole, and a pixel beside it that lacks red alone.
ImageBuf holed_picture(int channels, TypeDesc type) {
    ImageBuf image = picture(60, 40, channels, type);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float hole[] = {nan, nan, nan, nan}, lacks_red[] = {nan, 0.5f, 0.25f, 0.75f};
    for (int x = 20; x < 31; ++x)
        for (int y = 9; y < 25; ++y)
            image.setpixel(x, y, x == 30 ? lacks_red : hole);
    return image;
}

TEST(Enlargement, TheSameSizeIsACopyWhoseHolesAreFilledAsTheFilterDoes) {
    for (const TypeDesc type : {TypeDesc::HALF, TypeDesc::FLOAT, TypeDesc::DOUBLE})
        for (const int channels : {3, 4})
            for (const std::string light : {"linear", "sRGB", "encoded"}) {
                ImageBuf from = holed_picture(channels, type);
                if (type == TypeDesc::DOUBLE) // what floats have no room for stays
                    *static_cast<double*>(from.pixeladdr(3, 4)) = 1.0 / 3;
                ddt::Options options;
                options.holes = ddt::Holes::fill;
                options.light = light;
                if (light == "encoded")
                    from.specmod().attribute("oiio:ColorSpace", "sRGB");
                const ImageBuf wanted = images::enlarged(from, 60, 40, options);
                ASSERT_FALSE(std::isnan(images::value(wanted, 25, 17)));
                const OIIO::ROI part = images::window(17, 48, 3, 21);
                ImageBuf to = images::make(part, from.roi(), channels, type);
                Enlargement work = work_of(from, to, light);
                work.place = onto(work.from.box, work.from.box);
                work.holes = options.holes;
                std::string error;
                ASSERT_EQ(enlarge(work, error), ddt::Outcome::done) << error;
                EXPECT_TRUE(bytes(to) == bytes(wanted, part)) << type << channels << light;
                EXPECT_EQ(needed(work.place, work.to.box, work.holes), work.from.box);
            }
}

TEST(Enlargement, ACopyKeepsUnassociatedColourWhereNothingIsMissing) {
    ImageBuf straight = picture(60, 40, 4, TypeDesc::FLOAT);
    ASSERT_TRUE(OIIO::ImageBufAlgo::unpremult(straight, straight));
    const float unseen[] = {5, 5, 5, 0};
    for (int x = 20; x < 31; ++x)
        for (int y = 9; y < 25; ++y)
            straight.setpixel(x, y, unseen);
    ImageBuf product, wanted;
    ASSERT_TRUE(OIIO::ImageBufAlgo::premult(product, straight));
    ddt::Options options;
    options.holes = ddt::Holes::fill_alpha;
    options.light = "linear";
    const ImageBuf filled = images::enlarged(product, 60, 40, options);
    ASSERT_TRUE(OIIO::ImageBufAlgo::unpremult(wanted, filled));
    ImageBuf to = images::make(60, 40, 4);
    Enlargement work = work_of(straight, to, "linear");
    work.layout.associated = false;
    work.holes = options.holes;
    std::string error;
    ASSERT_EQ(enlarge(work, error), ddt::Outcome::done) << error;
    int missing = 0;
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 60; ++x) {
            const bool there = images::value(straight, x, y, 3) != 0;
            missing += !there;
            for (int c = 0; c < 4; ++c)
                ASSERT_EQ(images::value(to, x, y, c),
                          images::value(there ? straight : wanted, x, y, c))
                    << x << " " << y << " " << c;
            EXPECT_GT(images::value(to, x, y, 3), 0);
        }
    EXPECT_GE(missing, 11 * 16);
}

TEST(Enlargement, ACopyOfNumbersOfObjectsHasNoHoles) {
    ImageBuf from = images::make(40, 30, 1, TypeDesc::UINT32),
             to = images::make(40, 30, 1, TypeDesc::UINT32);
    auto* ids = static_cast<uint32_t*>(from.localpixels());
    for (size_t i = 0; i < 40 * 30; ++i)
        ids[i] = 0x7fc00000u + uint32_t(i / 7); // NaN, were they floats
    Enlargement work = work_of(from, to, "linear");
    work.holes = ddt::Holes::fill;
    std::string error;
    ASSERT_EQ(enlarge(work, error), ddt::Outcome::done) << error;
    EXPECT_TRUE(bytes(to) == bytes(from));
}

TEST(Enlargement, FillingACopyTellsHowFarItIsAndStopsWhenTold) {
    ImageBuf from = holed_picture(3, TypeDesc::FLOAT), to = images::make(60, 40, 3);
    Enlargement work = work_of(from, to, "linear");
    work.holes = ddt::Holes::fill;
    std::vector<float> shares;
    size_t last = SIZE_MAX;
    work.progress = [&](float share) {
        shares.push_back(share);
        return shares.size() < last;
    };
    std::string error;
    ASSERT_EQ(enlarge(work, error), ddt::Outcome::done) << error;
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_EQ(shares.back(), 1.0f);
    const size_t calls = shares.size();
    for (const size_t stop : {size_t(1), calls / 2, calls}) {
        shares.clear();
        last = stop;
        EXPECT_EQ(enlarge(work, error), ddt::Outcome::cancelled) << stop;
        EXPECT_EQ(error, "ddt: cancelled");
        EXPECT_EQ(shares.size(), stop);
    }
}

TEST(Enlargement, AFiltersOptionsReachTheWork) {
    Enlargement work;
    std::string error;
    ASSERT_TRUE(set_filter("ddt-sharp,cost=scf,limit=2,holes=fill-alpha,device=cpu,light=encoded",
                           "sRGB", work, error))
        << error;
    EXPECT_EQ(work.mesh.cost, ddt::Cost::scf);
    EXPECT_EQ(work.surface.limit, 2.0f);
    EXPECT_EQ(work.holes, ddt::Holes::fill_alpha);
    EXPECT_EQ(work.device, ddt::Device::cpu);
    EXPECT_FALSE(work.meaning.light->converts());
    ASSERT_TRUE(set_filter("ddt", "sRGB", work, error)) << error;
    EXPECT_EQ(work.holes, ddt::Holes::keep);
    EXPECT_TRUE(work.meaning.light->converts());
    EXPECT_FALSE(set_filter("ddt,light=sRGB", "bright", work, error));
    EXPECT_EQ(error.find("auto"), std::string::npos) << error;
    EXPECT_FALSE(set_filter("ddt,light=bright", "sRGB", work, error));
    EXPECT_NE(error.find("allowed are auto, linear, encoded, "), std::string::npos) << error;
}

TEST(Enlargement, LightsHaveNames) {
    Meaning meaning;
    std::string error;
    EXPECT_FALSE(find_meaning("bright", meaning, error));
    EXPECT_EQ(error, "ddt: light \"bright\" is not allowed; allowed are linear, encoded, sRGB, "
                     "Rec709, Gamma1.8, Gamma2.2, Gamma2.4");
}

} // namespace
