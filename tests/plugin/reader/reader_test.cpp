// SPDX-License-Identifier: Apache-2.0
// The reader by way of OIIO: ImageInput, ImageCache, TextureSystem.
#include "tests/environment.h"
#include "tests/temporary.h"

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <regex>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imagecache.h>
#include <OpenImageIO/texture.h>

namespace {

using namespace OIIO;

class Reader : public testing::Test {
protected:
    static void SetUpTestSuite() {
        OIIO::attribute("plugin_searchpath", DDT_PLUGIN_FOLDER);
        ImageSpec spec(11, 9, 3, TypeDesc::UINT16);
        ImageBuf image(spec);
        uint32_t state = 7;
        for (ImageBuf::Iterator<uint16_t> p(image); !p.done(); ++p)
            for (int c = 0; c < 3; ++c) {
                state = state * 1664525u + 1013904223u;
                p[c] = float(state >> 16) / 65535.0f;
            }
        ASSERT_TRUE(image.write(path())) << image.geterror();
        const ImageBuf source(path());
        expected = ImageBufAlgo::resize(source, "ddt", 0.0f, ROI(0, 44, 0, 36, 0, 1, 0, 3));
        ASSERT_FALSE(expected.has_error()) << expected.geterror();
    }

    static std::string path() { return ddt::temporary("reader_test.tif"); }
    static std::string name() { return path() + ".ddt?scale=4"; }

    inline static ImageBuf expected;
};

std::vector<float> values(const ImageBuf& image) {
    std::vector<float> result(image.spec().image_pixels() * size_t(image.nchannels()));
    EXPECT_TRUE(image.get_pixels(image.roi(), TypeFloat, result.data()));
    return result;
}

TEST_F(Reader, ReadsTheWholeImage) {
    auto input = ImageInput::open(name());
    ASSERT_TRUE(input) << OIIO::geterror();
    EXPECT_STREQ(input->format_name(), "ddt");
    EXPECT_EQ(input->spec().format, TypeDesc::UINT16);
    EXPECT_EQ(input->spec().tile_width, 64);
    EXPECT_FALSE(input->supports("procedural"));
    std::vector<float> pixels(44 * 36 * 3);
    ASSERT_TRUE(input->read_image(0, 0, 0, 3, TypeFloat, pixels.data())) << input->geterror();
    EXPECT_EQ(pixels, values(expected));
}

TEST_F(Reader, ReadsSingleTilesInAnyOrder) {
    auto input = ImageInput::open(name());
    ASSERT_TRUE(input) << OIIO::geterror();
    const int side = input->spec().tile_width;
    ASSERT_EQ(side, 64); // one tile holds all, and what is beyond is black
    std::vector<float> all(size_t(side) * size_t(side) * 3, 1.0f);
    ASSERT_TRUE(input->read_tile(0, 0, 0, TypeFloat, all.data())) << input->geterror();
    const std::vector<float> whole = values(expected);
    for (int y = 0; y < side; ++y)
        for (int i = 0; i < side * 3; ++i) {
            const bool inside = y < 36 && i < 44 * 3;
            ASSERT_EQ(all[size_t(y * side * 3 + i)], inside ? whole[size_t(y * 44 * 3 + i)] : 0.0f);
        }
}

/// Of a picture of 4 x 4 tiles of the mesh, those on which the tiles that are read lie.
TEST_F(Reader, TilesTakeTheirPartOfTheMesh) {
    const std::string large = ddt::temporary("reader_test_large.tif");
    ASSERT_TRUE(
        ImageBufAlgo::resize(ImageBuf(path()), "", 0.0f, ROI(0, 1024, 0, 1024)).write(large));
    auto input = ImageInput::open(large + ".ddt?scale=4");
    ASSERT_TRUE(input) << OIIO::geterror();
    const ddt::Environment verbose("DDT_VERBOSE", "1"), device("DDT_DEVICE", "cpu");
    std::vector<uint8_t> pixels(64 * 64 * 3);
    testing::internal::CaptureStderr();
    EXPECT_TRUE(
        input->read_tiles(0, 0, 2176, 2240, 2176, 2240, 0, 1, 0, 3, TypeUInt8, pixels.data()))
        << input->geterror();
    const std::string told = testing::internal::GetCapturedStderr();
    int64_t taken = 0;
    const std::regex line("; (\\d+) pixels, \\d+ flips");
    for (std::sregex_iterator found(told.begin(), told.end(), line), end; found != end; ++found)
        taken += std::stoll((*found)[1]);
    EXPECT_GT(taken, 0) << told;
    EXPECT_LE(taken, 4 * 321 * 321) << told;
}

TEST_F(Reader, TellsOfAWrongLightWhenItIsOpened) {
    EXPECT_FALSE(ImageInput::open(name() + "&light=nosuch"));
    EXPECT_NE(OIIO::geterror().find("nosuch"), std::string::npos);
    EXPECT_TRUE(ImageInput::open(name() + "&light=encoded"));
}

// Who copies it writes tiles, too.
TEST_F(Reader, HasNothingThatATiffInTilesCannotHold) {
    ImageSpec spec(8, 8, 3, TypeDesc::DOUBLE);
    ImageBuf image(spec);
    ASSERT_TRUE(ImageBufAlgo::fill(image, {0.5f, 0.25f, 0.75f}));
    const std::string in = ddt::temporary("double.tif"), out = ddt::temporary("tiles.tif");
    ASSERT_TRUE(image.write(in));
    ImageBuf large(in + ".ddt?scale=2");
    ASSERT_TRUE(large.read()) << large.geterror();
    EXPECT_GT(large.nativespec().tile_width, 0);
    ASSERT_TRUE(large.write(out));
    EXPECT_EQ(values(ImageBuf(out)), values(large));

    ImageSpec cmyk(8, 8, 3, TypeUInt8);
    cmyk.attribute("tiff:ColorSpace", "CMYK");
    cmyk.attribute("compression", "jpeg");
    ASSERT_TRUE(ImageBuf(cmyk).write(ddt::temporary("cmyk.tif")));
    const auto input = ImageInput::open(ddt::temporary("cmyk.tif") + ".ddt?scale=2");
    ASSERT_TRUE(input) << OIIO::geterror();
    EXPECT_FALSE(input->spec().find_attribute("tiff:ColorSpace"));
    EXPECT_NE(input->spec().get_string_attribute("compression"), "jpeg");
}

TEST_F(Reader, RefusesWhatOverrunsMemory) {
    ImageSpec cmyk(20, 10, 4, TypeUInt8);
    cmyk.channelnames = {"C", "M", "Y", "K"};
    cmyk.attribute("tiff:ColorSpace", "CMYK");
    ImageBuf image(cmyk);
    image.set_write_tiles(16, 16);
    const std::string path = ddt::temporary("cmyk_tiles.tif");
    ASSERT_TRUE(image.write(path));
    const auto input = ImageInput::open(path + ".ddt?scale=2");
    if (OIIO::openimageio_version() < 30200) {
        EXPECT_FALSE(input);
        EXPECT_NE(OIIO::geterror().find("it has CMYK in tiles"), std::string::npos);
    } else
        EXPECT_TRUE(input);

    // Another image than the first.
    const std::string second = ddt::temporary("cmyk_second.tif");
    const auto out = OIIO::ImageOutput::create(second);
    const ImageSpec plain(20, 10, 3, TypeUInt8);
    const std::vector<uint8_t> pixels(20 * 10 * 4);
    ASSERT_TRUE(out->open(second, plain) && out->write_image(TypeUInt8, pixels.data()));
    cmyk.tile_width = cmyk.tile_height = 16;
    ASSERT_TRUE(out->open(second, cmyk, OIIO::ImageOutput::AppendSubimage) &&
                out->write_image(TypeUInt8, pixels.data()) && out->close());
    const auto both = ImageInput::open(second + ".ddt?scale=2");
    ASSERT_TRUE(both) << OIIO::geterror();
    EXPECT_EQ(both->seek_subimage(1, 0), OIIO::openimageio_version() >= 30200);
}

TEST_F(Reader, TellsThatItsSourceWasReplaced) {
    const std::string replaced = ddt::temporary("reader_test_replaced.tif");
    ASSERT_TRUE(ImageBuf(path()).write(replaced));
    auto input = ImageInput::open(replaced + ".ddt?scale=4");
    ASSERT_TRUE(input) << OIIO::geterror();
    ASSERT_TRUE(ImageBufAlgo::resize(ImageBuf(path()), "", 0.0f, ROI(0, 5, 0, 4)).write(replaced));
    std::vector<float> pixels(44 * 36 * 3);
    EXPECT_FALSE(input->read_image(0, 0, 0, 3, TypeFloat, pixels.data()));
    EXPECT_EQ(input->geterror(), "ddt: \"" + replaced + "\" was changed while it was read");
}

TEST_F(Reader, HasTheSubimagesOfItsSource) {
    auto input = ImageInput::open(name());
    ASSERT_TRUE(input) << OIIO::geterror();
    EXPECT_TRUE(input->seek_subimage(0, 0));
    EXPECT_FALSE(input->seek_subimage(1, 0));
    EXPECT_FALSE(input->seek_subimage(0, 1));
    EXPECT_FALSE(input->seek_subimage(-1, 0));
    EXPECT_EQ(input->current_subimage(), 0);
}

TEST_F(Reader, CanBeClosedAndOpenedAgain) {
    auto input = ImageInput::open(name());
    ASSERT_TRUE(input) << OIIO::geterror();
    EXPECT_TRUE(input->close());
    ImageSpec spec;
    EXPECT_FALSE(input->open(path(), spec)); // a foreign name
    ASSERT_TRUE(input->open(path() + ".ddt?scale=2", spec)) << input->geterror();
    EXPECT_EQ(spec.width, 22);
}

TEST_F(Reader, ServesAnImageCacheFromSeveralThreads) {
    auto cache = ImageCache::create(false);
    cache->attribute("autotile", 8);
    std::vector<std::vector<float>> read(4, std::vector<float>(44 * 36 * 3));
    std::vector<std::thread> threads;
    for (auto& pixels : read)
        threads.emplace_back([&] {
            EXPECT_TRUE(cache->get_pixels(ustring(name()), 0, 0, 0, 44, 0, 36, 0, 1, TypeFloat,
                                          pixels.data()))
                << cache->geterror();
        });
    for (std::thread& thread : threads)
        thread.join();
    for (const auto& pixels : read)
        EXPECT_EQ(pixels, values(expected));
    ImageCache::destroy(cache);
}

TEST_F(Reader, ServesATextureSystem) {
    auto system = TextureSystem::create(false);
    TextureOpt options;
    options.interpmode = TextureOpt::InterpClosest;
    float texel[3];
    // The centre of pixel (10, 20).
    ASSERT_TRUE(
        system->texture(ustring(name()), options, 10.5f / 44, 20.5f / 36, 0, 0, 0, 0, 3, texel))
        << system->geterror();
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(texel[c], expected.getchannel(10, 20, 0, c), 1e-4f);
    TextureSystem::destroy(system);
}

} // namespace
