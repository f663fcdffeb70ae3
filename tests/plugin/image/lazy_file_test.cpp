// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/lazy_file.h"

#include <algorithm>

#include "core/base/parallel.h"
#include "tests/many_threads.h"
#include "tests/plugin/huge_tile.h"
#include "tests/plugin/images.h"
#include "tests/temporary.h"

namespace ddt {
namespace {

std::string write(const std::string& name, float value) {
    const std::string path = temporary(name);
    auto image = images::make(350, 300, 1, OIIO::TypeUInt8);
    images::fill(image, [&](int, int, int) { return value; });
    EXPECT_TRUE(image.write(path)) << image.geterror();
    return path;
}

auto cache_of(LazyFile& file) {
    EXPECT_TRUE(file.image().init_spec(file.image().name(), 0, 0));
    return &*file.image().imagecache();
}

/// Why is told in lazy_file.cpp.
TEST(LazyFile, CachesAreUsedAgainAndByOneFileAtATime) {
    const std::string path = write("lazy.tif", 0.5f);
    auto a = std::make_unique<LazyFile>(path, 0, LazyFile::Pieces());
    auto b = std::make_unique<LazyFile>(path, 0, LazyFile::Pieces());
    const auto *first = cache_of(*a), *second = cache_of(*b);
    EXPECT_NE(first, second);
    a.reset();
    a = std::make_unique<LazyFile>(path, 0, LazyFile::Pieces());
    EXPECT_EQ(cache_of(*a), first);
    b.reset();
    b = std::make_unique<LazyFile>(path, 0, LazyFile::Pieces());
    EXPECT_EQ(cache_of(*b), second);
}

TEST(LazyFile, ShowsTheFileThatIsThereNow) {
    for (int i = 1; i <= 12; ++i) {
        const float value = float(i) / 255;
        const LazyFile file(write("again.tif", value), 0, {128, i % 2 == 0});
        OIIO::ImageBuf dst;
        ASSERT_TRUE(ddt::resize(dst, file.image(), {}, images::window(0, 700, 0, 600)))
            << dst.geterror();
        EXPECT_EQ(file.image().storage(), OIIO::ImageBuf::IMAGECACHE);
        for (const int x : {0, 350, 699})
            for (const int y : {0, 300, 599})
                ASSERT_NEAR(images::value(dst, x, y), value, 1e-4f) << i;
    }
}

TEST(LazyFile, AColourUnderASmallAlphaKeepsItsBits) {
    const std::string path = temporary("straight.tif");
    auto image = images::make(40, 30, 4, OIIO::TypeUInt8);
    image.specmod().attribute("oiio:UnassociatedAlpha", 1);
    images::fill(image, [](int, int, int c) { return float(c < 3 ? 200 : 3) / 255; });
    ASSERT_TRUE(image.write(path)) << image.geterror();
    const LazyFile file(path, 0, LazyFile::Pieces());
    EXPECT_NEAR(images::value(file.image(), 20, 15), 200.0f / 255 * 3 / 255, 1e-6f);
    // Other files are not held in four times the memory.
    const LazyFile plain(write("plain.tif", 0.5f), 0, LazyFile::Pieces());
    EXPECT_EQ(plain.image().spec().format, OIIO::TypeUInt8);
}

int megabytes_of(LazyFile& file) {
    int megabytes = 0;
    EXPECT_TRUE(cache_of(file)->getattribute("max_memory_MB", megabytes));
    return megabytes;
}

// It ends the program where it holds ten times what it may.
TEST(LazyFile, ItsCacheMayHoldTheFilesOwnTiles) {
    std::string error;
    {
        LazyFile huge(write_huge_tile("gigabyte.tif", 1 << 30), 0, LazyFile::Pieces());
        ASSERT_EQ(huge.image().spec().tile_height, 1 << 30);
        EXPECT_TRUE(huge.make_room(0, error)) << error;
        EXPECT_GT(megabytes_of(huge), 1024); // all of the image, which is a tile
    }
    // Of the next file as much as ever.
    LazyFile usual(write("usual.tif", 0.5f), 0, LazyFile::Pieces());
    EXPECT_TRUE(usual.make_room(0, error)) << error;
    EXPECT_EQ(megabytes_of(usual), 128);
}

TEST(LazyFile, ItsCacheMayHoldTwoTilesForEachThread) {
    const std::string path = temporary("tiles.tif");
    auto image = images::make(1024, 1024, 4, OIIO::TypeFloat);
    image.set_write_tiles(256, 256); // 16 of 1 MiB
    ASSERT_TRUE(image.write(path)) << image.geterror();
    std::string error;
    for (const int wanted : {4, 64, 128}) {
        const test::ManyThreads many(wanted);
        LazyFile file(path, 0, {10});
        EXPECT_TRUE(file.make_room(wanted, error)) << error;
        const int megabytes = megabytes_of(file), threads = std::max(usual_threads(), wanted);
        // Those, the one that is read, and what the cache itself keeps; or all there are.
        EXPECT_GE(10 * megabytes, std::min(megabytes + 2 * threads + 1, 10 * 16)) << wanted;
        EXPECT_LE(megabytes, wanted == 4 && threads == 4 ? 10 : 17) << wanted;
    }
}

TEST(LazyFile, TilesForWhichThereIsNoMemoryAreRefused) {
    int before = 0;
    ASSERT_TRUE(OIIO::getattribute("limits:imagesize_MB", before));
    LazyFile file(write_huge_tile("refused.tif", 1 << 30), 0, LazyFile::Pieces());
    std::string error;
    OIIO::attribute("limits:imagesize_MB", 1000);
    EXPECT_FALSE(file.make_room(0, error));
    OIIO::attribute("limits:imagesize_MB", before);
    EXPECT_NE(error.find("refused.tif\" in pieces of 1 x 1073741824 pixels would need 1024 MB; "
                         "allowed are 1000 MB"),
              std::string::npos)
        << error;
}

} // namespace
} // namespace ddt
