// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/resize/resize_file.h"

#include <filesystem>
#include <fstream>

#include <OpenImageIO/imagebufalgo.h>
#include <gtest/gtest.h>

#include "plugin/tool/commands.h"
#include "plugin/tool/file/open_image.h"
#include "plugin/tool/file/other_images.h"
#include "plugin/tool/part/join.h"
#include "plugin/tool/part/resize_part.h"
#include "tests/environment.h"
#include "tests/plugin/tool/load_image.h"
#include "tests/plugin/tool/several_types.h"
#include "tests/temporary.h"

namespace ddt::tool {
namespace {

using OIIO::ImageBuf;
using OIIO::ImageSpec;

bool resized(const std::string& in, const std::string& size, const std::string& out,
             Failure& failure, const std::string& type = "") {
    ResizeSettings settings;
    settings.size = size;
    settings.type = type;
    return resize_file(
        in, out, settings, [](float) { return true; }, failure);
}

TEST(ResizeFile, OfASourceThatChangesMeanwhileThereIsNone) {
    const std::string in = temporary("changes.tif"), out = temporary("of_both.exr");
    ImageBuf image(ImageSpec(300, 600, 1, OIIO::TypeUInt8));
    ASSERT_TRUE(image.write(in)) << image.geterror();
    ResizeSettings settings;
    settings.size = "200%";
    bool changed = false;
    const auto change = [&](float) {
        if (!changed)
            std::ofstream(in, std::ios::app).put('x');
        return changed = true;
    };
    Failure failure;
    EXPECT_FALSE(resize_file(in, out, settings, change, failure));
    EXPECT_TRUE(changed);
    EXPECT_EQ(failure.why, "\"" + in + "\" was changed while it was read");
    EXPECT_EQ(failure.code, exit_resources);
    EXPECT_FALSE(std::filesystem::exists(out));
    EXPECT_TRUE(resize_file(in, out, settings, change, failure)) << failure.why;
}

/// Writers of later OpenImageIOs divide by alpha before they round, if they get floats, as from
/// oiiotool.
TEST(ResizeFile, WhatIsDividedByAlphaIsRoundedAfterwards) {
    for (const OIIO::TypeDesc& type : {OIIO::TypeUInt8, OIIO::TypeUInt16}) {
        ImageBuf picture(ImageSpec(24, 20, 4, type));
        for (int y = 0; y < 20; ++y)
            for (int x = 0; x < 24; ++x) {
                const float alpha = float(x) / 60;
                picture.setpixel(x, y, {alpha * 0.9f, alpha * float(y) / 20, alpha * 0.1f, alpha});
            }
        const std::string name = type.c_str(); // caches know files by theirs
        const std::string in = temporary(name + ".png"), out = temporary(name + "_out.png"),
                          expected = temporary(name + "_expected.png");
        ASSERT_TRUE(picture.write(in)) << picture.geterror();
        ImageBuf image, large;
        std::string error;
        ASSERT_TRUE(open_image(in, image, error)) << error;
        ImageSpec spec = image.spec(); // with what the writer goes by
        spec.width = spec.full_width = 48;
        spec.height = spec.full_height = 40;
        spec.set_format(OIIO::TypeFloat);
        large.reset(spec);
        Options options;
        options.surface.clipped = true; // as what becomes whole numbers
        ASSERT_TRUE(ddt::resize(large, image, options)) << large.geterror();
        large.set_write_format(type);
        ASSERT_TRUE(large.write(expected)) << large.geterror();
        Failure failure;
        ASSERT_TRUE(resized(in, "200%", out, failure)) << failure.why;
        const auto same = OIIO::ImageBufAlgo::compare(ImageBuf(expected), ImageBuf(out), 0, 0);
        EXPECT_EQ(same.maxerror, 0) << type;
    }
}

TEST(ResizeFile, ChannelsKeepTheirTypes) {
    const std::string in = file_of_several_types();
    const auto formats = OIIO::ImageInput::open(in)->spec().channelformats;
    const std::string out = temporary("several_types_out.exr");
    Failure failure;
    ASSERT_TRUE(resized(in, "200%", out, failure)) << failure.why;
    EXPECT_EQ(OIIO::ImageInput::open(out)->spec().channelformats, formats);
    EXPECT_EQ(ids_of(out), std::make_pair(uint32_t(5), uint32_t(70000)));
    // By way of a part, too.
    ResizeSettings settings;
    settings.size = "200%";
    const std::string part = temporary("several_types_part.exr");
    const std::string joined = temporary("several_types_joined.exr");
    const auto progress = [](float) { return true; };
    ASSERT_TRUE(resize_part(in, part, settings, {1, 1}, progress, failure)) << failure.why;
    ASSERT_TRUE(join({part}, joined, progress, failure)) << failure.why;
    EXPECT_EQ(OIIO::ImageInput::open(joined)->spec().channelformats, formats);
    EXPECT_EQ(ids_of(joined), std::make_pair(uint32_t(5), uint32_t(70000)));
    // A type that is asked for is that of all.
    ASSERT_TRUE(resized(in, "200%", out, failure, "float")) << failure.why;
    EXPECT_TRUE(OIIO::ImageInput::open(out)->spec().channelformats.empty());
    EXPECT_EQ(OIIO::ImageInput::open(out)->spec().format, OIIO::TypeFloat);
    // Nor has each format several: they become floats there.
    const std::string whole = temporary("several_types.tif");
    ASSERT_TRUE(resized(in, "200%", whole, failure)) << failure.why;
    ASSERT_TRUE(join({part}, temporary("joined.tif"), progress, failure)) << failure.why;
    const ImageBuf of_one(whole), of_parts(temporary("joined.tif"));
    ASSERT_EQ(of_parts.spec().format, OIIO::TypeFloat);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 32; ++x)
            for (int c = 0; c < 5; ++c) {
                const float expected = of_one.getchannel(x, y, 0, c);
                if (!std::isnan(expected)) {
                    EXPECT_EQ(of_parts.getchannel(x, y, 0, c), expected) << x << " " << y;
                }
            }
}

/// Of a part of its own.
bool joined_of(const std::string& in, const std::string& out, Failure& failure) {
    ResizeSettings settings;
    settings.size = "100%";
    const std::string part = temporary("of_joined.exr");
    const auto progress = [](float) { return true; };
    return resize_part(in, part, settings, {1, 1}, progress, failure) &&
           join({part}, out, progress, failure);
}

// OpenImageIO's writers of PNM and RLA take numbers of some types for others.
TEST(ResizeFile, NumbersArriveWhicheverTypesAWriterKnows) {
    struct Case {
        const char *in, *out;
        OIIO::TypeDesc type;
        int bits, channels;
        double tolerance; // PNM has steps of 1 / 255, and parts of 8 bits are halfs
    };
    const OIIO::TypeDesc real(OIIO::TypeDesc::DOUBLE);
    for (const Case& c : {Case{"ten.dpx", "ten.ppm", OIIO::TypeUInt16, 10, 3, 0.6 / 255},
                          {"twelve.dpx", "twelve.ppm", OIIO::TypeUInt16, 12, 3, 0.6 / 255},
                          {"sixteen.tif", "sixteen.pgm", OIIO::TypeUInt16, 16, 1, 0.6 / 255},
                          {"real.tif", "real.ppm", real, 64, 3, 0.6 / 255},
                          {"six.tif", "six.pgm", OIIO::TypeUInt8, 6, 1, 0.6 / 255},
                          {"one.tif", "one.pgm", OIIO::TypeUInt8, 1, 1, 0},
                          {"half.exr", "half.rla", OIIO::TypeHalf, 16, 3, 0},
                          {"real.tif", "real.rla", real, 64, 3, 1e-7}}) {
        ImageBuf picture(ImageSpec(20, 12, c.channels, OIIO::TypeFloat));
        for (ImageBuf::Iterator<float> p(picture); !p.done(); ++p)
            for (int k = 0; k < c.channels; ++k)
                p[k] = float((p.x() * 7 + p.y() * 13 + k * 29) % 64) / 63;
        picture.specmod().attribute("oiio:BitsPerSample", c.bits);
        picture.set_write_format(c.type);
        const std::string in = temporary(c.in), out = temporary(c.out),
                          joined = temporary(std::string("joined_") + c.out);
        ASSERT_TRUE(picture.write(in)) << picture.geterror();
        const auto expect_like = [&](const std::string& path) {
            const auto same = OIIO::ImageBufAlgo::compare(load(in), load(path), 0, 0);
            EXPECT_LE(same.maxerror, c.tolerance) << path;
        };
        Failure failure;
        ASSERT_TRUE(resized(in, "100%", out, failure)) << failure.why;
        expect_like(out);
        if (c.type == real) // which parts do not hold
            continue;
        ASSERT_TRUE(joined_of(in, joined, failure)) << failure.why;
        expect_like(joined);
    }
}

/// Whether a file of float32 (PFM) begins with the last row of pixels that grow from row to row.
bool begins_with_last_row(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string word;
    for (int i = 0; i < 4; ++i) // the format's letters, the sizes, the order of bytes
        file >> word;
    file.get();
    float first = 0;
    file.read(reinterpret_cast<char*>(&first), sizeof first);
    return file && first > 0.9f;
}

// OpenImageIO has floats in PNM since 2.5.12, the last row first, and turns about each batch of
// rows that it is handed as floats, whatever it makes of them.
TEST(ResizeFile, RowsOfPnmKeepTheirOrder) {
    struct Case {
        const char* in;
        OIIO::TypeDesc type;
        int width, height; // more than one batch, of the larger one in join() too
    };
    const OIIO::TypeDesc real(OIIO::TypeDesc::DOUBLE);
    for (const Case& c : {Case{"order_half.exr", OIIO::TypeHalf, 20, 150},
                          {"order_float.exr", OIIO::TypeFloat, 4096, 360},
                          {"order_real.tif", real, 20, 150},
                          {"order_sixteen.tif", OIIO::TypeUInt16, 20, 150}}) {
        ImageBuf picture(ImageSpec(c.width, c.height, 3, OIIO::TypeFloat));
        for (ImageBuf::Iterator<float> p(picture); !p.done(); ++p)
            for (int k = 0; k < 3; ++k)
                p[k] = float(p.y()) / float(c.height - 1);
        picture.set_write_format(c.type);
        const std::string in = temporary(c.in), out = temporary(std::string(c.in) + ".ppm"),
                          joined = temporary(std::string(c.in) + "_joined.ppm");
        ASSERT_TRUE(picture.write(in)) << picture.geterror();
        const auto expect_like = [&](const std::string& path) {
            const ImageBuf written = load(path);
            const auto same = OIIO::ImageBufAlgo::compare(picture, written, 0, 0);
            EXPECT_LE(same.maxerror, 0.6 / 255) << path;
            if (written.nativespec().format == OIIO::TypeFloat) {
                EXPECT_TRUE(begins_with_last_row(path)) << path;
            }
        };
        Failure failure;
        ASSERT_TRUE(resized(in, "100%", out, failure)) << failure.why;
        expect_like(out);
        ASSERT_TRUE(resized(out, "100%", in + "_back.exr", failure)) << failure.why;
        EXPECT_LE(OIIO::ImageBufAlgo::compare(picture, load(in + "_back.exr"), 0, 0).maxerror,
                  0.6 / 255);
        if (c.type == real) // which parts do not hold
            continue;
        ASSERT_TRUE(joined_of(in, joined, failure)) << failure.why;
        expect_like(joined);
    }
}

// RLA's writer counts channels of several types wrong.
TEST(ResizeFile, ChannelsOfSeveralTypesAreFloatsInRla) {
    const std::string in = file_of_several_types(), out = temporary("several_types.rla"),
                      joined = temporary("several_types_joined.rla");
    Failure failure;
    ASSERT_TRUE(resized(in, "100%", out, failure)) << failure.why;
    ASSERT_TRUE(joined_of(in, joined, failure)) << failure.why;
    const ImageBuf source(in);
    for (const std::string& path : {out, joined}) {
        const ImageBuf image(path);
        ASSERT_EQ(image.nchannels(), 5) << path;
        EXPECT_EQ(image.nativespec().format, OIIO::TypeFloat) << path;
        for (const int x : {0, 15})
            for (int c = 0; c < 4; ++c)
                EXPECT_EQ(image.getchannel(x, 1, 0, c), source.getchannel(x, 1, 0, c)) << path;
    }
}

TEST(ResizeFile, ObjectNumbersAmongOtherTypesAreExact) {
    // As a float that number would be another, and as bits no number at all.
    for (const uint32_t large : {4000000001u, 0xff812345u}) {
        const std::string in = file_of_several_types({large});
        const std::string out = temporary("exact.exr");
        const auto both = std::make_pair(uint32_t(5), large);
        Failure failure;
        for (const char* size : {"200%", "100%", "50%", "300%x50%"}) {
            ASSERT_TRUE(resized(in, size, out, failure)) << failure.why;
            EXPECT_EQ(ids_of(out), both) << size;
        }
        ASSERT_EQ(make_fill_command()->run({in, out}), exit_done);
        EXPECT_EQ(ids_of(out), both);
        ResizeSettings settings;
        for (const auto& [size, holes] : {std::pair("200%", Holes::keep),
                                          {"100%", Holes::keep},
                                          {"200%", Holes::fill},
                                          {"100%", Holes::fill}}) {
            settings.size = size;
            settings.options.holes = holes;
            ASSERT_TRUE(resize_file(
                in, out, settings, [](float) { return true; }, failure))
                << failure.why;
            EXPECT_EQ(ids_of(out), both) << size;
            const std::string part = temporary("exact_part.exr");
            const auto progress = [](float) { return true; };
            ASSERT_TRUE(resize_part(in, part, settings, {1, 1}, progress, failure)) << failure.why;
            EXPECT_EQ(ids_of(part), both);
            ASSERT_TRUE(join({part}, out, progress, failure)) << failure.why;
            EXPECT_EQ(ids_of(out), both);
        }
    }
}

TEST(ResizeFile, ObjectNumbersFollowTheColoursMeshHoweverLarge) {
    // What was copied for a small number, which floats hold, was copied for a large one.
    std::vector<uint32_t> of[2];
    for (const bool large : {false, true}) {
        const std::string in = temporary("large_or_small.exr"), out = temporary("either.exr");
        ImageSpec spec(300, 280, 2, OIIO::TypeFloat);
        spec.channelnames = {"Y", "object"};
        spec.channelformats = {OIIO::TypeHalf, OIIO::TypeUInt32};
        std::string bytes;
        for (int y = 0; y < spec.height; ++y)
            for (int x = 0; x < spec.width; ++x) {
                const uint16_t grey = 3 * x < 2 * y ? 0x3800 : 0x3c00;
                const uint32_t id = (large ? 4000000001u : 1u) + uint32_t(x + y * spec.width);
                bytes.append(reinterpret_cast<const char*>(&grey), sizeof grey);
                bytes.append(reinterpret_cast<const char*>(&id), sizeof id);
            }
        const auto file = OIIO::ImageOutput::create(in);
        ASSERT_TRUE(file->open(in, spec) && file->write_image(OIIO::TypeUnknown, bytes.data()) &&
                    file->close());
        Failure failure;
        ASSERT_TRUE(resized(in, "200%", out, failure)) << failure.why;
        const auto result = OIIO::ImageInput::open(out);
        of[large].resize(result->spec().image_pixels());
        ASSERT_TRUE(result->read_image(0, 0, 1, 2, OIIO::TypeUInt32, of[large].data()));
    }
    size_t wrong = 0, off_the_grid = 0;
    for (size_t i = 0; i < of[0].size(); ++i) {
        wrong += of[1][i] - of[0][i] != 4000000000u;
        off_the_grid += of[0][i] != 1 + i % 600 / 2 + i / 600 / 2 * 300;
    }
    EXPECT_EQ(wrong, 0u);
    EXPECT_GT(off_the_grid, 0u); // or the mesh does not show
}

TEST(ResizeFile, ObjectNumbersThatDoNotSurviveAreNamed) {
    const std::string in = file_of_several_types();
    Failure failure;
    const auto said = [&](const std::string& out, const std::string& type) {
        testing::internal::CaptureStderr();
        EXPECT_TRUE(resized(in, "200%", out, failure, type)) << failure.why;
        return testing::internal::GetCapturedStderr();
    };
    const std::string exr = temporary("as_half.exr"), tif = temporary("as_float.tif");
    EXPECT_EQ(said(exr, ""), "");
    EXPECT_EQ(said(exr, "half"), "ddt: \"" + exr +
                                     "\" is written as half, which object IDs do not "
                                     "survive: obj\n");
    EXPECT_EQ(said(tif, ""), "ddt: \"" + tif +
                                 "\" is written as float, which object IDs do not survive: "
                                 "obj\n");
}

/// OpenImageIO 2.4 reads a turned DPX with its sides swapped.
TEST(ResizeFile, ATurnedImageThatAFormatGarblesIsRefusedByItsOrientation) {
    const std::string in = temporary("turned.tif"), out = temporary("turned.dpx");
    ImageSpec spec(8, 6, 3, OIIO::TypeUInt8);
    spec.attribute("Orientation", 6);
    ASSERT_TRUE(OIIO::ImageBuf(spec).write(in));
    Failure failure;
    if (resized(in, "200%", out, failure))
        GTEST_SKIP() << "this release reads it as it was written";
    EXPECT_NE(failure.why.find("Orientation is 6; upright ones can"), std::string::npos)
        << failure.why;
    EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(ResizeFile, OfSeveralImagesTheFirstIsTakenWhichIsSaid) {
    const std::string in = temporary("three.tif"), out = temporary("three_out.tif");
    const std::vector<ImageSpec> specs(3, ImageSpec(8, 6, 1, OIIO::TypeUInt8));
    const std::vector<uint8_t> pixels(8 * 6, 100);
    const auto file = OIIO::ImageOutput::create(in);
    for (int i = 0; i < 3; ++i)
        ASSERT_TRUE(
            file->open(in, specs[size_t(i)],
                       i > 0 ? OIIO::ImageOutput::AppendSubimage : OIIO::ImageOutput::Create) &&
            file->write_image(OIIO::TypeUInt8, pixels.data()));
    ASSERT_TRUE(file->close());
    Failure failure;
    const std::string said = "ddt: \"" + in + "\" has 3 images; the first alone was taken\n";
    const std::string how = said.substr(0, said.size() - 1) + " (all: --all-images)\n";
    testing::internal::CaptureStderr();
    EXPECT_TRUE(resized(in, "200%", out, failure)) << failure.why;
    EXPECT_EQ(testing::internal::GetCapturedStderr(), how);
    EXPECT_EQ(count_images(out), 1);
    ResizeSettings settings;
    settings.size = "200%";
    testing::internal::CaptureStderr();
    EXPECT_TRUE(resize_part(
        in, temporary("three_part.exr"), settings, {1, 1}, [](float) { return true; }, failure));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), said);
    testing::internal::CaptureStderr();
    EXPECT_EQ(make_fill_command()->run({in, out}), exit_done);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), said);
    testing::internal::CaptureStderr();
    EXPECT_EQ(make_mesh_command()->run({in, temporary("three.ply")}), exit_done);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), said);
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    EXPECT_EQ(make_compare_command()->run({in, in}), exit_done);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), said + said);
    testing::internal::GetCapturedStdout();
    // Also where the result takes the place of the file, and of the other images.
    for (const bool fills : {false, true}) {
        const std::string own = temporary("three_own.tif");
        std::filesystem::copy_file(in, own, std::filesystem::copy_options::overwrite_existing);
        testing::internal::CaptureStderr();
        EXPECT_TRUE(fills ? make_fill_command()->run({own, own}) == exit_done
                          : resized(own, "200%", own, failure));
        EXPECT_EQ(testing::internal::GetCapturedStderr(),
                  "ddt: \"" + own + "\" has 3 images; the first alone was taken" +
                      (fills ? "\n" : " (all: --all-images)\n"));
        EXPECT_EQ(count_images(own), 1);
    }
}

TEST(ResizeFile, OfLevelsTheLargestIsTakenWhichIsSaid) {
    ImageBuf image(ImageSpec(64, 64, 3, OIIO::TypeUInt8));
    OIIO::ImageBufAlgo::fill(image, {0.1f, 0.2f, 0.3f});
    for (const char* name : {"levels.tx", "levels.exr"}) {
        const std::string in = temporary(name), out = temporary("of_levels.tif");
        ASSERT_TRUE(OIIO::ImageBufAlgo::make_texture(OIIO::ImageBufAlgo::MakeTxTexture, image, in,
                                                     ImageSpec()));
        const std::string said =
            "ddt: \"" + in + "\" has MIP levels; the largest alone was taken\n";
        for (const bool all : {false, true}) {
            ResizeSettings settings;
            settings.size = "200%";
            settings.all_images = all;
            Failure failure;
            testing::internal::CaptureStderr();
            EXPECT_TRUE(resize_file(
                in, out, settings, [](float) { return true; }, failure))
                << failure.why;
            EXPECT_EQ(testing::internal::GetCapturedStderr(), said);
            EXPECT_EQ(ImageBuf(out).spec().width, 128);
        }
    }
}

/// An RLA file that says it has a display window of no width.
std::string file_without_display(const std::string& name) {
    const std::string path = temporary(name);
    ImageBuf image(ImageSpec(8, 8, 3, OIIO::TypeUInt8));
    OIIO::ImageBufAlgo::zero(image);
    EXPECT_TRUE(image.write(path));
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(2); // WindowRight, of 16 bits, the first byte the higher one
    file.write("\xff\xff", 2);
    return path;
}

TEST(ResizeFile, AnEmptyDisplayWindowIsRefusedInEveryWay) {
    const std::string in = file_without_display("no_display.rla");
    if (!OIIO::ImageInput::open(in))
        GTEST_SKIP() << "OpenImageIO refuses it itself: " << OIIO::geterror();
    Failure failure;
    EXPECT_FALSE(resized(in, "32x32", temporary("no_display.exr"), failure));
    const std::string refusal = "\"" + in + "\": the source's display window has size 0";
    EXPECT_EQ(failure.why.substr(0, refusal.size()), refusal);
    ResizeSettings settings;
    settings.size = "32x32";
    EXPECT_FALSE(resize_part(
        in, temporary("no_display.exr"), settings, {1, 1}, [](float) { return true; }, failure));
    EXPECT_EQ(failure.why.substr(0, refusal.size()), refusal);
    EXPECT_EQ(memory_to_resize(in, temporary("no_display.exr"), settings), 0);
}

// What --jobs goes by.
TEST(MemoryToResize, CountsBothImagesInTheTypesTheyAreHeldIn) {
    const std::string in = temporary("memory.exr");
    ImageBuf image(ImageSpec(64, 32, 3, OIIO::TypeHalf));
    OIIO::ImageBufAlgo::zero(image);
    ASSERT_TRUE(image.write(in));
    constexpr int64_t numbers = 64 * 32 * 3, large = 4 * numbers;
    // With one thread: a block of 16 rows, three times over, as the tests of exr_buffers() have it.
    const auto buffer = [](int64_t row) { return 3 * 16 * row; };
    constexpr int64_t small_row = 64 * 3 * 2;
    ResizeSettings settings;
    settings.size = "200%";
    const auto of = [&](const std::string& out, const std::string& type) {
        settings.type = type;
        return memory_to_resize(in, temporary(out), settings);
    };
    const int64_t halfs = of("memory2.exr", "");
    // Of another type or format the result is held as floats until it is written.
    EXPECT_EQ(of("memory2.exr", "half"), halfs + large * 2);
    EXPECT_EQ(of("memory2.tif", ""), halfs + large * 2 - buffer(2 * small_row));
    settings.options.mesh.meshes = 2;
    EXPECT_GT(of("memory2.exr", ""), halfs);
    settings.options.mesh.meshes = 1;
    settings.threads = 41;
    EXPECT_GT(of("memory2.exr", ""), halfs);
    // Of two blocks and four.
    settings.threads = 16;
    EXPECT_EQ(of("memory2.exr", ""), halfs + buffer(small_row) + 3 * buffer(2 * small_row));
    settings.threads = 1;
    EXPECT_GE(halfs, 2 * (numbers + large));
    settings.size = "400%";
    EXPECT_EQ(of("memory2.exr", ""), halfs + 2 * (16 - 4) * numbers + buffer(2 * small_row));
    // 32-bit integers among other types are read and kept beside them.
    const std::string several = file_of_several_types();
    settings.size = "200%";
    EXPECT_EQ(memory_to_resize(several, temporary("memory2.exr"), settings),
              halfs - 2 * (numbers + large) - buffer(3 * small_row) +
                  16 * 8 * (5 * 4 + 4 * 5 * 4 + 4) + buffer(16 * 14) / 2 + buffer(32 * 14));
    EXPECT_EQ(memory_to_resize(temporary("none.exr"), temporary("memory2.exr"), settings), 0);
    EXPECT_EQ(memory_to_resize("/dev/zero", temporary("memory2.exr"), settings), 0);
}

TEST(ResizeFile, WhatHasNoFlatPixelsIsRefusedForGood) {
    ImageSpec spec(8, 8, 2, OIIO::TypeHalf);
    spec.deep = true;
    spec.channelnames = {"A", "Z"};
    ImageBuf deep(spec);
    const std::string in = temporary("deep.exr"), out = temporary("of_deep.exr");
    ASSERT_TRUE(deep.write(in));
    Failure failure;
    EXPECT_FALSE(resized(in, "200%", out, failure));
    EXPECT_EQ(failure.code, exit_failed);
    EXPECT_EQ(failure.why, "\"" + in + "\": the source is a deep image; allowed are flat ones");
    testing::internal::CaptureStderr();
    EXPECT_EQ(make_fill_command()->run({in, out}), exit_failed);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "ddt: " + failure.why + "\n");

    const std::string empty = temporary("empty.fits");
    std::string header; // of an image without axes
    for (std::string card : {"SIMPLE  =                    T", "BITPIX  =                    8",
                             "NAXIS   =                    0", "END"}) {
        card.resize(80, ' ');
        header += card;
    }
    header.resize(2880, ' ');
    std::ofstream(empty) << header;
    failure = {};
    EXPECT_FALSE(resized(empty, "200%", out, failure));
    EXPECT_EQ(failure.code, exit_failed) << failure.why;
    EXPECT_NE(failure.why.find(empty), std::string::npos) << failure.why;

    failure = {};
    EXPECT_FALSE(resized("", "200%", out, failure));
    EXPECT_EQ(failure.code, exit_failed);
    EXPECT_EQ(failure.why, "\"\" is no name of a file");
}

TEST(ResizeFile, NothingIsBegunForAFilterThatDoesNotWork) {
    ImageBuf image(ImageSpec(8, 8, 3, OIIO::TypeUInt8));
    OIIO::ImageBufAlgo::zero(image);
    const std::string in = temporary("black.png"), out = temporary("not_begun.png");
    ASSERT_TRUE(image.write(in));
    ResizeSettings settings;
    settings.size = "200%";
    settings.options.light = "nosuchspace";
    Failure failure;
    testing::internal::CaptureStderr();
    EXPECT_FALSE(resize_file(
        in, out, settings, [](float) { return true; }, failure));
    // Libpng says it there when a file is closed that got no pixels.
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_NE(failure.why.find("nosuchspace"), std::string::npos) << failure.why;
    EXPECT_NE(failure.why.find(in), std::string::npos) << failure.why;
}

TEST(ResizeFile, WhatAFormatHasNoRoomForIsLeftOutAndNamed) {
    ImageSpec spec(8, 6, 6, OIIO::TypeHalf);
    spec.channelnames = {"R", "G", "B", "A", "Z", "mask"};
    spec.alpha_channel = 3;
    spec.z_channel = 4;
    ImageBuf image(spec);
    OIIO::ImageBufAlgo::fill(image, {0.1f, 0.2f, 0.3f, 1.0f, 9.0f, 1.0f});
    const std::string in = temporary("six.exr");
    ASSERT_TRUE(image.write(in));
    Failure failure;
    ResizeSettings settings;
    settings.size = "200%";
    const std::string part = temporary("six_part.exr");
    const auto progress = [](float) { return true; };
    ASSERT_TRUE(resize_part(in, part, settings, {1, 1}, progress, failure)) << failure.why;
    for (const auto& [name, channels, left_out] :
         {std::tuple("six.png", 4, "Z, mask"), std::tuple("six.ppm", 3, "A, Z, mask")}) {
        const std::string out = temporary(name);
        testing::internal::CaptureStderr();
        ASSERT_TRUE(resized(in, "200%", out, failure)) << failure.why;
        EXPECT_EQ(testing::internal::GetCapturedStderr(),
                  "ddt: \"" + out + "\" has no room for " + left_out + "\n");
        EXPECT_EQ(ImageBuf(out).nchannels(), channels);
        EXPECT_EQ(ImageBuf(out).spec().width, 16);
        const std::string joined = temporary(std::string("joined_") + name);
        testing::internal::CaptureStderr();
        ASSERT_TRUE(join({part}, joined, progress, failure)) << failure.why;
        EXPECT_NE(testing::internal::GetCapturedStderr().find(left_out), std::string::npos);
        EXPECT_EQ(ImageBuf(joined).nchannels(), channels);
        const auto difference =
            OIIO::ImageBufAlgo::compare(ImageBuf(joined), ImageBuf(out), 0.005f, 0.005f);
        EXPECT_EQ(difference.nfail, 0u); // parts are rounded to halfs
        const std::string filled = temporary(std::string("filled_") + name);
        testing::internal::CaptureStderr();
        EXPECT_EQ(make_fill_command()->run({in, filled}), exit_done);
        EXPECT_NE(testing::internal::GetCapturedStderr().find(left_out), std::string::npos);
        EXPECT_EQ(ImageBuf(filled).nchannels(), channels);
        EXPECT_EQ(ImageBuf(filled).spec().width, 8);
    }
}

TEST(ResizeFile, NoThirdChannelIsMadeUpForJpeg) {
    ImageSpec spec(8, 6, 2, OIIO::TypeHalf);
    spec.channelnames = {"u", "v"};
    ImageBuf image(spec);
    OIIO::ImageBufAlgo::fill(image, {0.1f, 0.2f});
    const std::string in = temporary("uv.exr"), out = temporary("uv.jpg");
    ASSERT_TRUE(image.write(in));
    Failure failure;
    EXPECT_FALSE(resized(in, "200%", out, failure));
    EXPECT_EQ(failure.why, "cannot write \"" + out +
                               "\": the format jpeg has no 2 channels (u, v); allowed are 1 and 3");
    EXPECT_FALSE(std::filesystem::exists(out));
}

/// What is said on stderr of a resized image of so many channels of a type.
std::string said_of(int channels, OIIO::TypeDesc of, const std::string& name,
                    const std::string& type, const std::string& compression = "") {
    ImageBuf image(ImageSpec(16, 16, channels, of));
    OIIO::ImageBufAlgo::zero(image);
    const std::string in = temporary("asked.tif"), out = temporary(name);
    EXPECT_TRUE(image.write(in)) << image.geterror();
    ResizeSettings settings;
    settings.size = "200%";
    settings.type = type;
    settings.compression = compression;
    Failure failure;
    testing::internal::CaptureStderr();
    EXPECT_TRUE(resize_file(
        in, out, settings, [](float) { return true; }, failure))
        << failure.why;
    const std::string said = testing::internal::GetCapturedStderr();
    const std::string begin = "ddt: \"" + out + "\" cannot have the ";
    return said.compare(0, begin.size(), begin) == 0 ? said.substr(begin.size()) : said;
}

TEST(ResizeFile, HalfsBecomeFloatsInFits) {
    ImageBuf image(ImageSpec(8, 6, 3, OIIO::TypeHalf));
    OIIO::ImageBufAlgo::fill(image, {0.1f, 0.2f, 0.3f});
    const std::string in = temporary("halfs.exr"), out = temporary("halfs.fits");
    ASSERT_TRUE(image.write(in));
    Failure failure;
    testing::internal::CaptureStderr();
    EXPECT_TRUE(resized(in, "200%", out, failure)) << failure.why;
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(ImageBuf(out).spec().format, OIIO::TypeFloat);
    EXPECT_EQ(ImageBuf(out).getchannel(7, 5, 0, 1), image.getchannel(0, 0, 0, 1));
}

TEST(ResizeFile, ATypeThatTheFormatHasNotIsNamed) {
    EXPECT_EQ(said_of(3, OIIO::TypeUInt8, "a.fits", "half"), "type half; float is written\n");
    EXPECT_EQ(said_of(3, OIIO::TypeUInt8, "a.exr", "uint8"), "type uint8; half is written\n");
    EXPECT_EQ(said_of(3, OIIO::TypeUInt8, "a.png", "half"), "type half; uint8 is written\n");
    EXPECT_EQ(said_of(3, OIIO::TypeUInt8, "a.jpg", "float"), "type float; uint8 is written\n");
    EXPECT_EQ(said_of(3, OIIO::TypeUInt8, "a.tif", "half"), "type half; float is written\n");
    EXPECT_EQ(said_of(3, OIIO::TypeUInt8, "a.png", "uint16"), "");
    EXPECT_EQ(said_of(3, OIIO::TypeUInt8, "a.exr", "float"), "");
    EXPECT_EQ(said_of(3, OIIO::TypeFloat, "a.png", ""), ""); // nobody asked
}

/// What said_of() is to say of a compression that not every version of OpenImageIO writes.
std::string expected_of(int channels, OIIO::TypeDesc type, const char* name,
                        const std::string& asked) {
    ImageBuf image(ImageSpec(8, 8, channels, type));
    OIIO::ImageBufAlgo::zero(image);
    image.specmod().attribute("compression", asked);
    const std::string path = temporary(std::string("written_") + name);
    EXPECT_TRUE(image.write(path)) << image.geterror();
    const auto file = OIIO::ImageInput::open(path);
    const auto without_level = [](const std::string& s) { return s.substr(0, s.find(':')); };
    const std::string wanted = without_level(asked),
                      written = without_level(file->spec().get_string_attribute("compression"));
    return written == wanted ? "" : "compression " + wanted + "; " + written + " is written\n";
}

TEST(ResizeFile, ACompressionThatTheFileHasNotIsNamed) {
    const auto uint8 = OIIO::TypeUInt8, uint16 = OIIO::TypeUInt16;
    EXPECT_EQ(said_of(3, uint16, "a.tif", "", "jpeg:85"), "compression jpeg; zip is written\n");
    EXPECT_EQ(said_of(4, uint8, "a.tif", "", "jpeg"), "compression jpeg; zip is written\n");
    EXPECT_EQ(said_of(1, uint16, "a.exr", "half", "dwaa:45"),
              expected_of(1, OIIO::TypeHalf, "a.exr", "dwaa:45"));
    EXPECT_EQ(said_of(3, uint8, "a.tif", "", "jpeg:85"), expected_of(3, uint8, "a.tif", "jpeg:85"));
    // Those that files have are not spoken of.
    for (const char* compression : {"none", "lzw", "zip:6", "packbits"})
        EXPECT_EQ(said_of(3, uint16, "a.tif", "", compression), "") << compression;
    for (const char* compression :
         {"none", "rle", "zip:4", "zips", "piz", "pxr24", "b44", "b44a", "dwaa:45", "dwab"})
        EXPECT_EQ(said_of(3, uint16, "a.exr", "half", compression), "") << compression;
    for (const char* compression : {"filtered", "huffman", "rle", "fixed"})
        EXPECT_EQ(said_of(3, uint8, "a.png", "", compression), "") << compression;
    for (const char* compression : {"none", "rle"}) {
        EXPECT_EQ(said_of(3, uint8, "a.tga", "", compression), "") << compression;
        EXPECT_EQ(said_of(3, uint8, "a.iff", "", compression), "") << compression;
    }
    EXPECT_EQ(said_of(3, uint8, "a.jpg", "", "jpeg:80"), "");
    EXPECT_EQ(said_of(3, uint8, "a.webp", "", "lossless"), "");
}

TEST(ResizeFile, GifKeepsItsAlpha) {
    // OpenImageIO's writer has no alpha: red on the left, nothing on the right, 2 x 2 pixels.
    constexpr char file[] = "GIF89a\2\0\2\0\x80\0\0\xff\0\0\0\0\0!\xf9\4\1\0\0\1\0"
                            ",\0\0\0\0\2\0\2\0\0\2\3\x44\x10\5\0;";
    const std::string in = temporary("transparent.gif");
    std::ofstream(in, std::ios::binary).write(file, sizeof file - 1);
    for (const char* name : {"transparent.png", "transparent.tif", "transparent.exr"}) {
        const std::string out = temporary(name);
        Failure failure;
        testing::internal::CaptureStderr();
        ASSERT_TRUE(resized(in, "400%", out, failure)) << failure.why;
        EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << name;
        const ImageBuf large(out);
        EXPECT_EQ(large.nchannels(), 4) << name;
        EXPECT_EQ(large.spec().alpha_channel, 3) << name;
        EXPECT_EQ(large.getchannel(0, 4, 0, 3), 1.0f) << name;
        EXPECT_EQ(large.getchannel(7, 4, 0, 3), 0.0f) << name;
        EXPECT_EQ(large.getchannel(7, 4, 0, 0), 0.0f) << name;
    }
}

TEST(ResizeFile, AnUnusableLightIsFoundBeforeTheFileIsMade) {
    const std::string in = temporary("lit.png"), out = temporary("unlit.png");
    ImageBuf image(ImageSpec(4, 4, 3, OIIO::TypeUInt8));
    ASSERT_TRUE(OIIO::ImageBufAlgo::zero(image) && image.write(in));
    const Environment config("OCIO", "/nonexistent.ocio");
    Failure failure;
    testing::internal::CaptureStderr(); // libpng's, of a file that gets no pixels
    const bool done = resized(in, "200%", out, failure);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_FALSE(done);
    EXPECT_NE(failure.why.find("/nonexistent.ocio"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(out));
}

// Its writer ends the program.
TEST(ResizeFile, TwoChannelsAreRefusedForDpx) {
    ImageBuf image(ImageSpec(8, 8, 2, OIIO::TypeHalf));
    OIIO::ImageBufAlgo::zero(image);
    const std::string in = temporary("two.exr"), out = temporary("two.dpx");
    ASSERT_TRUE(image.write(in));
    Failure failure;
    EXPECT_FALSE(resized(in, "200%", out, failure));
    EXPECT_EQ(failure.code, exit_failed);
    EXPECT_NE(failure.why.find("allowed are 1, 3 and 4"), std::string::npos) << failure.why;
}

} // namespace
} // namespace ddt::tool
