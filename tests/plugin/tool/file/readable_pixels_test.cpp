// SPDX-License-Identifier: Apache-2.0
// Files with pixels that cannot be read.
#include "plugin/tool/file/readable_pixels.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <OpenImageIO/imagebufalgo.h>
#include <gtest/gtest.h>

#include "plugin/tool/file/image_file.h"
#include "plugin/tool/file/open_image.h"
#include "plugin/tool/part/resize_part.h"
#include "plugin/tool/resize/resize_file.h"
#include "tests/temporary.h"

namespace ddt::tool {
namespace {

constexpr int damaged_side = 200;

/// A TIFF of noise; `tile`: pixels a side of its tiles, if any.
struct NoisyTiff {
    const char* name;
    const char* compression;
    OIIO::TypeDesc type;
    int channels = 3, tile = 0;

    std::string write() const {
        OIIO::ImageBuf image(OIIO::ImageSpec(damaged_side, damaged_side, channels, type));
        OIIO::ImageBufAlgo::noise(image, "uniform", 0.0f, 1.0f);
        image.specmod().attribute("compression", compression);
        // Which the reader makes associated.
        image.specmod().attribute("oiio:UnassociatedAlpha", channels == 4 ? 1 : 0);
        if (tile)
            image.set_write_tiles(tile, tile);
        std::string path = temporary(std::string("damaged_") + name);
        EXPECT_TRUE(image.write(path)) << image.geterror();
        return path;
    }
};

const NoisyTiff noisy_tiffs[] = {
    {"zip8.tif", "zip", OIIO::TypeUInt8},     {"zip16.tif", "zip", OIIO::TypeUInt16},
    {"float.tif", "zip", OIIO::TypeFloat},    {"lzw.tif", "lzw", OIIO::TypeUInt8},
    {"alpha.tif", "zip", OIIO::TypeUInt8, 4}, {"tiled.tif", "zip", OIIO::TypeUInt8, 3, 32},
};

/// Put zeros in place of bytes in a file's middle.
void damage(const std::string& path, size_t count) {
    std::string bytes = text_in(path);
    bytes.replace((bytes.size() - count) / 2, count, count, '\0');
    std::ofstream(path, std::ios::binary) << bytes;
}

/// Whether each of the ways in which commands read a file reads this one.
std::vector<bool> ways_that_read(const std::string& path) {
    OIIO::ImageBuf image;
    ResizeSettings settings;
    settings.size = "200%";
    std::string error;
    Failure failures[2];
    const auto progress = [](float) { return true; };
    const std::string out = temporary("damaged.exr");
    const std::vector<bool> read = {
        open_image(path, image, error),
        resize_file(path, out, settings, progress, failures[0]),
        resize_part(path, out, settings, {1, 1}, progress, failures[1]),
    };
    for (const std::string& said : {error, failures[0].why, failures[1].why})
        EXPECT_TRUE(said.empty() || said.find(path) != std::string::npos) << said;
    return read;
}

TEST(ReadablePixels, AreNotThoseOfADamagedTiff) {
    for (const NoisyTiff& tiff : noisy_tiffs) {
        SCOPED_TRACE(tiff.name);
        const std::string path = tiff.write();
        EXPECT_EQ(ways_that_read(path), std::vector<bool>(3, true));
        damage(path, text_in(path).size() / 2);
        EXPECT_EQ(ways_that_read(path), std::vector<bool>(3, false));
        std::string error;
        const auto input = open_input(path, 0, error);
        ASSERT_TRUE(input) << error;
        EXPECT_FALSE(can_be_read(*input));
        input->geterror();
        EXPECT_TRUE(can_be_read(*input, 0, 1));
        input->geterror();
    }
}

// As where the disk refuses to read on.
TEST(ReadablePixels, AreNotThoseThatAFileLostMeanwhile) {
    for (const NoisyTiff& tiff : noisy_tiffs) {
        SCOPED_TRACE(tiff.name);
        const std::string path = tiff.write();
        std::string error;
        const auto input = open_input(path, 0, error);
        ASSERT_TRUE(input) << error;
        std::filesystem::resize_file(path, 1000);
        EXPECT_FALSE(can_be_read(*input));
        input->geterror();
    }
}

// Rows that a part is not made of need not be there.
TEST(ReadablePixels, AreThoseOfAPartThatIsNotDamaged) {
    OIIO::ImageBuf image(OIIO::ImageSpec(64, 2000, 3, OIIO::TypeUInt8));
    OIIO::ImageBufAlgo::noise(image, "uniform", 0.0f, 1.0f);
    const std::string path = temporary("damaged_high.tif"), out = temporary("damaged_high.exr");
    ASSERT_TRUE(image.write(path));
    damage(path, 15000); // the begin of a strip among them
    ResizeSettings settings;
    settings.size = "200%";
    const auto makes = [&](int part) {
        Failure failure;
        return resize_part(
            path, out, settings, {part, 7}, [](float) { return true; }, failure);
    };
    EXPECT_TRUE(makes(1));
    EXPECT_FALSE(makes(4));
    EXPECT_TRUE(makes(7));
}

} // namespace
} // namespace ddt::tool
