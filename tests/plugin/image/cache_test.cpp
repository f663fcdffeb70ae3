// SPDX-License-Identifier: Apache-2.0
// Sources that are files behind OpenImageIO's cache.
#include <array>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "plugin/image/lazy_file.h"
#include "tests/core/gathering.h"
#include "tests/plugin/images.h"
#include "tests/temporary.h"

namespace {

constexpr int side = 2048, tile = 64;

/// A cache that nobody else uses. One for all tests, since worker threads outlive them: see
/// plugin/image/lazy_file.cpp.
ddt::CacheHandle empty_cache() {
    static auto* cache = new ddt::CacheHandle(OIIO::ImageCache::create(false));
    (*cache)->invalidate_all(true);
    (*cache)->reset_stats();
    (*cache)->attribute("max_memory_MB", 1024.0f);
    return *cache;
}

/// A tiled file, and such a cache.
class CacheTest : public testing::Test {
protected:
    CacheTest() : m_path(ddt::temporary("cache_test.tif")) {
        auto image = images::make(side, side, 1, OIIO::TypeUInt8);
        images::fill(
            image, [](int x, int y, int) { return float((x / 16 * 7 + y / 16 * 5) & 255) / 255; });
        image.set_write_tiles(tile, tile);
        EXPECT_TRUE(image.write(m_path)) << image.geterror();
        m_pixels = image;
        m_cache = empty_cache();
    }
    ~CacheTest() override { std::remove(m_path.c_str()); }
    /// Noise in place of the picture.
    void write(int size) {
        auto image = images::make(size, size, 1, OIIO::TypeUInt8);
        images::noise(image);
        image.set_write_tiles(tile, tile);
        ASSERT_TRUE(image.write(m_path)) << image.geterror();
    }
    /// That without its end: a tile is not whole.
    void truncate(int size) {
        write(size);
        std::filesystem::resize_file(m_path, std::filesystem::file_size(m_path) - 100);
    }
    int64_t statistic(const char* name) const {
        long long value = -1;
        EXPECT_TRUE(m_cache->getattribute(name, OIIO::TypeDesc::INT64, &value)) << name;
        return value;
    }

    std::string m_path;
    OIIO::ImageBuf m_pixels; ///< the same in memory
    ddt::CacheHandle m_cache;
};

TEST_F(CacheTest, AFileIsReadTileByTile) {
    const OIIO::ImageBuf src(m_path, 0, 0, m_cache);
    OIIO::ImageBuf dst, whole;
    // Source pixels 1050 to 1100: one tile of the mesh's grid, 32 + 256 + 33 pixels wide.
    const OIIO::ROI part(4200, 4400, 4200, 4400, 0, 1);
    auto spec = src.spec();
    OIIO::set_roi(spec, part);
    OIIO::set_roi_full(spec, OIIO::ROI(0, 4 * side, 0, 4 * side, 0, 1));
    dst.reset(spec);
    auto same = dst;
    ASSERT_TRUE(ddt::resize(dst, src, {}, part)) << dst.geterror();
    EXPECT_EQ(src.storage(), OIIO::ImageBuf::IMAGECACHE);
    constexpr int64_t most = 321 / tile + 2;
    EXPECT_LE(statistic("stat:bytes_read"), most * most * tile * tile);
    EXPECT_GT(statistic("stat:bytes_read"), 0);

    ASSERT_TRUE(ddt::resize(same, m_pixels, {}, part)) << same.geterror();
    EXPECT_EQ(images::bytes(dst), images::bytes(same));
}

// The cache counts as the file does.
TEST_F(CacheTest, AnImageThatWasMovedHasItsPixelsElsewhere) {
    const std::string rows = ddt::temporary("cache_test_rows.tif");
    OIIO::ImageBuf by_rows = m_pixels;
    by_rows.set_write_tiles(0, 0);
    ASSERT_TRUE(by_rows.write(rows)) << by_rows.geterror();
    for (const std::string& path : {m_path, rows}) {
        OIIO::ImageBuf src(path, 0, 0, m_cache), moved = m_pixels;
        for (OIIO::ImageBuf* image : {&src, &moved})
            image->set_origin(-7, 300);
        OIIO::ImageBuf dst, same;
        const OIIO::ROI part(0, 4400, 1200, 1300, 0, 1);
        for (OIIO::ImageBuf* image : {&dst, &same}) {
            auto spec = src.spec();
            OIIO::set_roi(spec, part);
            OIIO::set_roi_full(spec, OIIO::ROI(0, 4 * side, 0, 4 * side, 0, 1));
            image->reset(spec);
        }
        ASSERT_TRUE(ddt::resize(dst, src, {}, part)) << dst.geterror();
        EXPECT_EQ(src.storage(), OIIO::ImageBuf::IMAGECACHE);
        ASSERT_TRUE(ddt::resize(same, moved, {}, part)) << same.geterror();
        EXPECT_EQ(images::bytes(dst), images::bytes(same)) << path;
    }
    std::remove(rows.c_str());
}

// Every pixel of the whole, from a cache that holds a quarter of the file.
TEST_F(CacheTest, AWholeFileIsNeverInMemory) {
    m_cache->attribute("max_memory_MB", 1.0f);
    const OIIO::ImageBuf src(m_path, 0, 0, m_cache);
    OIIO::ImageBuf dst;
    const OIIO::ROI size(0, side * 5 / 4, 0, side * 5 / 4);
    ASSERT_TRUE(ddt::resize(dst, src, {}, size, 2)) << dst.geterror();
    EXPECT_EQ(src.storage(), OIIO::ImageBuf::IMAGECACHE);
    EXPECT_LE(statistic("stat:cache_memory_used"), 2 << 20);
    OIIO::ImageBuf same;
    ASSERT_TRUE(ddt::resize(same, m_pixels, {}, size, 2)) << same.geterror();
    EXPECT_EQ(images::bytes(dst), images::bytes(same));
}

TEST_F(CacheTest, AnErrorPendingOnTheSourceIsNotOurs) {
    const OIIO::ImageBuf src(m_path, 0, 0, m_cache);
    src.error("left by somebody");
    OIIO::ImageBuf dst, same;
    const OIIO::ROI size(0, side + 8, 0, side + 8, 0, 1, 0, 1);
    ASSERT_TRUE(ddt::resize(dst, src, {}, size)) << dst.geterror();
    EXPECT_EQ(src.geterror(), "left by somebody");
    ASSERT_TRUE(ddt::resize(same, m_pixels, {}, size)) << same.geterror();
    EXPECT_EQ(images::bytes(dst), images::bytes(same));
}

TEST_F(CacheTest, ATruncatedFileIsAnError) {
    std::filesystem::resize_file(m_path, std::filesystem::file_size(m_path) / 2);
    const OIIO::ImageBuf src(m_path, 0, 0, m_cache);
    OIIO::ImageBuf dst;
    EXPECT_FALSE(ddt::resize(dst, src, {}, OIIO::ROI(0, side + 8, 0, side + 8, 0, 1, 0, 1)));
    const std::string error = dst.geterror();
    EXPECT_EQ(error.find("ddt: "), 0u) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    EXPECT_FALSE(dst.initialized());
}

// OpenImageIO's cache keeps black tiles, and finds nothing wrong with them the next time; its own
// filters go on with black.
TEST_F(CacheTest, ATruncatedFileIsAnErrorWhateverIsMadeOfItEachTime) {
    constexpr int few = 4 * tile;
    truncate(few);
    const float half[3][3] = {{0.5f, 0, 0}, {0, 0.5f, 0}, {0, 0, 1}};
    const OIIO::ROI small(0, few / 2, 0, few / 2, 0, 1), narrow(0, few / 2, 0, few + 8, 0, 1);
    using Work = std::function<bool(OIIO::ImageBuf & dst, const OIIO::ImageBuf& src)>;
    const OIIO::ROI large(0, few + 8, 0, few + 8, 0, 1);
    const Work ways[] = {[&](auto& dst, auto& src) { return ddt::resize(dst, src, {}, large); },
                         [&](auto& dst, auto& src) { return ddt::resize(dst, src, {}, small); },
                         [&](auto& dst, auto& src) { return ddt::resize(dst, src, {}, narrow); },
                         [&](auto& dst, auto& src) { return ddt::warp(dst, src, half); },
                         [&](auto& dst, auto& src) { return ddt::fill(dst, src); }};
    m_cache = empty_cache();
    for (int time = 0; time < 2; ++time)
        for (const Work& work : ways) {
            const OIIO::ImageBuf src(m_path, 0, 0, m_cache);
            OIIO::ImageBuf dst;
            EXPECT_FALSE(work(dst, src));
            EXPECT_FALSE(dst.initialized());
            const std::string error = dst.geterror();
            EXPECT_EQ(error.find("ddt: "), 0u) << error;
            EXPECT_EQ(error.find('\n'), std::string::npos) << error;
        }
}

TEST_F(CacheTest, ATruncatedFileIsAnErrorToAllWhoReadItAtOnce) {
    if (OIIO::openimageio_version() >= 20500)
        GTEST_SKIP() << "OpenImageIO's cache asserts there that no other thread has found the file "
                        "broken meanwhile, which Debian's ends the program for";
    constexpr int few = 4 * tile, callers = 4;
    truncate(few);
    m_cache = empty_cache();
    ddt::test::Gathering begun(callers);
    std::array<bool, callers> done{};
    std::vector<std::thread> threads;
    for (bool& is_done : done)
        threads.emplace_back([&] {
            const OIIO::ImageBuf src(m_path, 0, 0, m_cache);
            OIIO::ImageBuf dst;
            ddt::Options options;
            options.device = ddt::Device::cpu;
            const ddt::test::Gathering::Guest here(begun);
            is_done = ddt::resize(dst, src, options, OIIO::ROI(0, few + 8, 0, few + 8), 1);
        });
    for (auto& thread : threads)
        thread.join();
    for (const bool is_done : done)
        EXPECT_FALSE(is_done);
    // Repaired, it is read anew.
    write(few);
    m_cache->invalidate(OIIO::ustring(m_path), true);
    const OIIO::ImageBuf src(m_path, 0, 0, m_cache);
    OIIO::ImageBuf dst;
    EXPECT_TRUE(ddt::resize(dst, src, {}, OIIO::ROI(0, few + 8, 0, few + 8))) << dst.geterror();
}

} // namespace
