// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/lazy_file.h"

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

} // namespace
} // namespace ddt
