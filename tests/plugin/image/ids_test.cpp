// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/ids.h"

#include <cstdio>

#include <OpenImageIO/filesystem.h>

#include "plugin/image/lazy_file.h"
#include "tests/plugin/images.h"
#include "tests/temporary.h"

namespace ddt::test {
namespace {

constexpr int side = 8;

/// Numbers that floats have room for, or just not, or not at all.
constexpr uint32_t small_ids[] = {0, 1, 777, (1u << 24) - 1},
                   rounded_ids[] = {5, 16777217, 16777216, 7},
                   large_ids[] = {5, 16777217, 2000000001, 4294967295};

using Numbers = std::vector<uint32_t>;

class Ids : public testing::TestWithParam<OIIO::TypeDesc> {
protected:
    ~Ids() override { std::remove(m_path.c_str()); }
    OIIO::ImageBuf image_of(const uint32_t* ids) const {
        auto image = images::make(side, side, 1, GetParam());
        for (int i = 0; i < side * side; ++i)
            std::memcpy(image.pixeladdr(i % side, i / side), &ids[i % 4], sizeof *ids);
        return image;
    }
    void write(const uint32_t* ids) const {
        const OIIO::ImageBuf image = image_of(ids);
        ASSERT_TRUE(image.write(m_path)) << image.geterror();
    }
    /// All bytes of the file, by way of a proxy under that name, whatever the disk has by then.
    struct InMemory {
        explicit InMemory(const std::string& path)
            : bytes(OIIO::Filesystem::file_size(path)), proxy(bytes.data(), bytes.size()) {
            OIIO::Filesystem::read_bytes(path, bytes.data(), bytes.size());
        }
        std::vector<unsigned char> bytes;
        OIIO::Filesystem::IOMemReader proxy;
    };
    /// Which 3.x does not use unless told to.
    static CacheHandle shared_cache() { return OIIO::ImageCache::create(true); }
    static Numbers numbers(const OIIO::ImageBuf& image) {
        const auto bytes = images::bytes(image);
        Numbers all(bytes.size() / sizeof(uint32_t));
        std::memcpy(all.data(), bytes.data(), bytes.size());
        return all;
    }

    std::string m_path = ddt::temporary("ids_test.tif");
    std::string m_error;
};

TEST_P(Ids, AreThoseOfTheFile) {
    for (const uint32_t* ids : {small_ids, rounded_ids, large_ids}) {
        write(ids);
        OIIO::ImageBuf src(m_path, 0, 0, shared_cache()), read;
        shared_cache()->invalidate(OIIO::ustring(m_path), true);
        src.set_origin(-3, 5);
        ASSERT_TRUE(read_ids(src, read, m_error)) << m_error;
        EXPECT_EQ(read.spec().format, GetParam());
        EXPECT_EQ(read.xbegin(), -3);
        EXPECT_EQ(read.ybegin(), 5);
        EXPECT_EQ(numbers(read), numbers(image_of(ids)));
    }
}

TEST_P(Ids, AreThoseOfAnImageThatComesFromMemory) {
    write(small_ids);
    InMemory memory(m_path);
    write(large_ids); // another file of that name
    OIIO::ImageBuf src(m_path, 0, 0, shared_cache(), nullptr, &memory.proxy), read;
    ASSERT_TRUE(read_ids(src, read, m_error)) << m_error;
    EXPECT_EQ(numbers(read), numbers(image_of(small_ids)));
    shared_cache()->invalidate(OIIO::ustring(m_path), true);
}

TEST_P(Ids, OfAnotherFileOfThatNameAreNone) {
    write(large_ids);
    InMemory memory(m_path);
    const auto fails = [&] {
        OIIO::ImageBuf src(m_path, 0, 0, shared_cache(), nullptr, &memory.proxy), read;
        m_error.clear();
        EXPECT_FALSE(read_ids(src, read, m_error));
        EXPECT_NE(m_error.find("ImageBuf::read("), std::string::npos) << m_error;
        shared_cache()->invalidate(OIIO::ustring(m_path), true);
    };
    write(small_ids);
    fails();
    std::remove(m_path.c_str());
    fails();
}

// Which is where the cache has its name's file from.
TEST_P(Ids, AreFoundInTheCachesFolders) {
    static auto* cache = new CacheHandle(OIIO::ImageCache::create(false)); // see lazy_file.cpp
    (*cache)->invalidate_all(true);
    (*cache)->attribute("searchpath", OIIO::Filesystem::parent_path(m_path));
    write(large_ids);
    OIIO::ImageBuf src(OIIO::Filesystem::filename(m_path), 0, 0, *cache), read;
    ASSERT_TRUE(read_ids(src, read, m_error)) << m_error;
    EXPECT_EQ(numbers(read), numbers(image_of(large_ids)));
}

/// A resize and a copy.
TEST_P(Ids, KeepTheirBitsInTheOtherType) {
    const OIIO::ImageBuf src = image_of(large_ids);
    const OIIO::TypeDesc other =
        GetParam() == OIIO::TypeUInt32 ? OIIO::TypeInt32 : OIIO::TypeUInt32;
    for (const int size : {side, 2 * side}) {
        auto same = images::make(size, size, 1, GetParam()),
             dst = images::make(size, size, 1, other);
        ASSERT_TRUE(resize(same, src, {}, {})) << same.geterror();
        ASSERT_TRUE(resize(dst, src, {}, {})) << dst.geterror();
        EXPECT_EQ(images::bytes(dst), images::bytes(same)) << size;
    }
}

INSTANTIATE_TEST_SUITE_P(Types, Ids, testing::Values(OIIO::TypeUInt32, OIIO::TypeInt32),
                         [](const auto& of) { return std::string(of.param.c_str()); });

} // namespace
} // namespace ddt::test
