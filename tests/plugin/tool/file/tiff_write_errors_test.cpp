// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/tiff_write_errors.h"

#include <csignal>
#include <cstdint>
#include <filesystem>
#include <vector>

#include <gtest/gtest.h>

#include "plugin/tool/file/image_file.h"
#include "tests/resource_limit.h"
#include "tests/temporary.h"

namespace ddt::tool {
namespace {

constexpr int momentary_side = 64, momentary_rows = 8;

/// Whether a TIFF is written where the file may not grow while the step of this number is taken: to
/// open it, to write some rows, or to commit it.
bool is_written(const char* compression, int full_at, Failure& failure) {
    const std::string path = temporary("momentary.tif");
    std::filesystem::remove(path);
    OIIO::ImageSpec spec(momentary_side, momentary_side, 3, OIIO::TypeUInt8);
    spec.attribute("compression", compression);
    spec.attribute("tiff:RowsPerStrip", momentary_rows);
    std::vector<uint8_t> rows(size_t(momentary_rows) * momentary_side * 3);
    for (size_t i = 0; i < rows.size(); ++i)
        rows[i] = uint8_t(i * i / 7 + 1);
    ImageFile file;
    int step = 0;
    const auto take = [&](const auto& call) {
        if (step++ != full_at)
            return call();
        const test::ResourceLimit full(RLIMIT_FSIZE, 16);
        return call();
    };
    bool done = file.create(path, failure) && take([&] { return file.open(spec, failure); });
    for (int y = 0; done && y < momentary_side; y += momentary_rows)
        done = take(
            [&] { return file.write_rows(y, y + momentary_rows, OIIO::TypeUInt8, rows.data()); });
    if (step > 1 && !done)
        failure = file.failed();
    // The check itself asks whether the disk is full, so a moment at the end is no moment.
    done = done && file.commit(failure);
    EXPECT_EQ(std::filesystem::exists(path), done);
    return done;
}

bool are_heard() {
    return OIIO::openimageio_version() < 20500;
}

TEST(TiffWriteErrors, AreThoseOfADiskThatIsFullForAMoment) {
    if (!are_heard())
        GTEST_SKIP() << "OpenImageIO keeps to itself what libtiff says";
    auto* const before = std::signal(SIGXFSZ, SIG_IGN);
    for (const char* compression : {"none", "zip", "lzw"})
        for (const int step : {0, 2, 5}) { // the first rows may wait for the next
            Failure failure;
            EXPECT_FALSE(is_written(compression, step, failure)) << compression << step;
            EXPECT_EQ(failure.code, exit_resources) << compression << step << failure.why;
        }
    std::signal(SIGXFSZ, before);
    for (const char* compression : {"none", "zip", "lzw"}) {
        Failure failure;
        EXPECT_TRUE(is_written(compression, -1, failure)) << failure.why;
    }
}

TEST(TiffWriteErrors, AreHeardOfOneFileAlone) {
    const std::string path = temporary("another.tif");
    ImageFile file;
    Failure failure, another;
    const OIIO::ImageSpec spec(momentary_side, momentary_side, 3, OIIO::TypeUInt8);
    const std::vector<uint8_t> pixels(spec.image_bytes(), 200);
    ASSERT_TRUE(file.create(path, failure) && file.open(spec, failure)) << failure.why;
    auto* const before = std::signal(SIGXFSZ, SIG_IGN);
    EXPECT_EQ(is_written("none", 0, another), !are_heard());
    std::signal(SIGXFSZ, before);
    EXPECT_TRUE(file.write_rows(0, momentary_side, OIIO::TypeUInt8, pixels.data()));
    EXPECT_TRUE(file.commit(failure)) << failure.why;
}

} // namespace
} // namespace ddt::tool
