// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/image_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/strutil.h>

#include "plugin/tool/file/open_image.h"
#include "tests/resource_limit.h"
#include "tests/temporary.h"

namespace ddt::tool {
namespace {

TEST(ImageFile, NamesThatCannotBeReadAgainAreRefusedAtOnce) {
    const std::string path = temporary("what?.exr");
    ImageFile file;
    Failure failure;
    EXPECT_FALSE(file.create(path, failure));
    EXPECT_NE(failure.why.find(path), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(ImageFile, HasOnlyAsManyChannelsAsItsFormat) {
    const auto begins = [](const std::string& name, int channels) {
        ImageFile file;
        Failure failure;
        return file.create(temporary(name), failure) &&
               file.open(OIIO::ImageSpec(8, 8, channels, OIIO::TypeUInt8), failure);
    };
    for (const int channels : {1, 3, 4}) {
        EXPECT_TRUE(begins("channels.dpx", channels)) << channels;
        EXPECT_TRUE(begins("channels.jpg", channels)) << channels;
    }
    EXPECT_FALSE(begins("channels.dpx", 2));
    EXPECT_FALSE(begins("channels.dpx", 5));
    EXPECT_FALSE(begins("channels.jpg", 2));
}

TEST(ImageFile, RowsOfPnmArriveInTheirOrder) {
    OIIO::ImageBuf image(OIIO::ImageSpec(8, 5, 3, OIIO::TypeFloat));
    for (OIIO::ImageBuf::Iterator<float> p(image); !p.done(); ++p)
        for (int k = 0; k < 3; ++k)
            p[k] = float(p.y()) / 5;
    for (const OIIO::TypeDesc& type : {OIIO::TypeFloat, OIIO::TypeUInt8}) {
        const std::string path = temporary(std::string("rows_of_") + type.c_str() + ".ppm");
        OIIO::ImageSpec spec = image.spec();
        spec.set_format(type);
        ImageFile file;
        Failure failure;
        ASSERT_TRUE(file.create(path, failure) && file.open({spec}, failure) &&
                    write_image(image, file, failure))
            << failure.why;
        OIIO::ImageBuf written;
        std::string error;
        ASSERT_TRUE(open_image(path, written, error)) << error;
        EXPECT_LE(OIIO::ImageBufAlgo::compare(image, written, 0, 0).maxerror, 0.6 / 255) << type;
    }
}

/// Writes an image into the file `path`, and calls `meanwhile` once the file is made (0), open (1)
/// or has its rows (2).
Failure failure_of_image(const std::string& path, int when,
                         const std::function<void(const std::string&)>& meanwhile) {
    const OIIO::ImageSpec spec(16, 16, 3, OIIO::TypeUInt8);
    const std::vector<uint8_t> pixels(spec.image_bytes(), 200);
    ImageFile file;
    Failure failure;
    const auto at = [&](int now) {
        if (now == when)
            meanwhile(file.temporary());
        return true;
    };
    EXPECT_FALSE(file.create(path, failure) && at(0) && file.open(spec, failure) && at(1) &&
                 file.write_rows(0, 16, OIIO::TypeUInt8, pixels.data()) && at(2) &&
                 file.commit(failure))
        << path << " " << when;
    return failure;
}

// EXR's has a stream, the writers of the others open the file themselves.
TEST(ImageFile, WhoseUnfinishedFileIsNotItsOwnAnyMoreIsTriedAgain) {
    for (const char* name : {"taken.exr", "taken.tif", "taken.rla"})
        for (const int when : {0, 1, 2}) {
            const std::string path = temporary(name);
            std::string unfinished;
            Failure failure = failure_of_image(path, when, [&](const std::string& own) {
                unfinished = own;
                std::ofstream(own + ".new") << "another's";
                std::filesystem::rename(own + ".new", own);
            });
            EXPECT_EQ(failure.code, exit_resources) << path << " " << when;
            EXPECT_NE(failure.why.find('"' + path + '"'), std::string::npos) << failure.why;
            EXPECT_EQ(text_in(unfinished), "another's") << path << " " << when;
            std::filesystem::remove(unfinished);
            failure = failure_of_image(
                path, when, [](const std::string& own) { std::filesystem::remove(own); });
            EXPECT_EQ(failure.code, exit_resources) << path << " " << when;
            EXPECT_FALSE(std::filesystem::exists(path)) << when;
            EXPECT_FALSE(std::filesystem::exists(unfinished)) << path << " " << when;
        }
}

// Whose writer leaves a hole of a row: whole blocks of the disk, of a wide one.
TEST(ImageFile, OfFitsMayBeWide) {
    const std::string path = temporary("wide.fits");
    const OIIO::ImageSpec spec(20000, 8, 3, OIIO::TypeUInt8);
    const std::vector<uint8_t> pixels(spec.image_bytes(), 200);
    ImageFile file;
    Failure failure;
    ASSERT_TRUE(file.create(path, failure) && file.open(spec, failure)) << failure.why;
    ASSERT_TRUE(file.write_rows(0, 8, OIIO::TypeUInt8, pixels.data()));
    EXPECT_TRUE(file.commit(failure)) << failure.why;
}

TEST(ImageFile, WhyAWriterFailedIsToldWhereItDoesNotSayIt) {
    const std::string path = temporary("large.fits");
    const OIIO::ImageSpec spec(1024, 16, 3, OIIO::TypeFloat); // rows too large for a buffer
    const std::vector<float> pixels(1024 * 16 * 3, 0.5f);
    ImageFile file;
    Failure failure;
    ASSERT_TRUE(file.create(path, failure) && file.open(spec, failure)) << failure.why;
    auto* const before = std::signal(SIGXFSZ, SIG_IGN);
    {
        const test::ResourceLimit small(RLIMIT_FSIZE, 2880); // the header
        EXPECT_FALSE(file.write_rows(0, 16, OIIO::TypeFloat, pixels.data()));
        failure = file.failed();
    }
    std::signal(SIGXFSZ, before);
    EXPECT_EQ(failure.why, "cannot write \"" + path + "\": " + std::strerror(EFBIG));
    EXPECT_EQ(failure.code, exit_resources);
}

constexpr const char* of_wanting = ".wanting";

/// Writes a file by its name, as some do.
class WantingOutput final : public OIIO::ImageOutput {
public:
    const char* format_name() const override { return "wanting"; }
    bool open(const std::string& name, const OIIO::ImageSpec& spec, OpenMode) override {
        m_spec = spec;
        std::ofstream(name) << "pixels";
        return true;
    }
    bool close() override { return true; }
    bool write_scanline(int, int, OIIO::TypeDesc, const void*, OIIO::stride_t) override {
        return true;
    }
};

/// Has no memory to open a file, or to read one.
class WantingInput final : public OIIO::ImageInput {
public:
    static inline bool opens = false;

    const char* format_name() const override { return "wanting"; }
    bool open(const std::string& name, OIIO::ImageSpec& spec) override {
        m_spec = spec = OIIO::ImageSpec(16, 16, 3, OIIO::TypeUInt8);
        if (!opens)
            errorfmt("std::bad_alloc");
        return opens && OIIO::Strutil::ends_with(name, of_wanting); // any are tried
    }
    bool close() override { return true; }
    bool read_native_scanline(int, int, int, int, void*) override {
        errorfmt("std::bad_alloc");
        return false;
    }
};

TEST(ImageFile, WhoseReaderHasNoMemoryIsTriedAgain) {
    static const char* extensions[] = {of_wanting + 1, nullptr};
    OIIO::declare_imageio_format(
        "wanting", []() -> OIIO::ImageInput* { return new WantingInput; }, extensions,
        []() -> OIIO::ImageOutput* { return new WantingOutput; }, extensions, nullptr);
    for (const bool opens : {false, true}) {
        WantingInput::opens = opens;
        const Failure failure =
            failure_of_image(temporary(std::string("file") + of_wanting), -1, {});
        EXPECT_EQ(failure.code, exit_resources) << failure.why;
        EXPECT_NE(failure.why.find("cannot be read back"), std::string::npos) << failure.why;
    }
}

/// What was written to a pipe so far.
std::string taken_from(int pipe) {
    std::string all;
    char bytes[4096];
    for (ssize_t n = 0; (n = read(pipe, bytes, sizeof bytes)) > 0;)
        all.append(bytes, size_t(n));
    return all;
}

class Streams : public testing::Test {
protected:
    /// A pipe with somebody at its other end.
    void open_pipe(const std::string& name) {
        m_path = temporary(name);
        ASSERT_EQ(mkfifo(m_path.c_str(), 0600), 0);
        m_end = open(m_path.c_str(), O_RDWR | O_NONBLOCK);
        ASSERT_GE(m_end, 0);
    }
    void close_pipe() {
        close(m_end);
        std::filesystem::remove(m_path);
    }
    /// Whether this OpenImageIO writes such files.
    static bool is_known(const std::string& name) {
        const bool known = OIIO::ImageOutput::create(name) != nullptr;
        OIIO::geterror();
        return known;
    }
    bool write(const std::string& path) {
        ImageFile file;
        const OIIO::ImageSpec spec(16, 16, 3, OIIO::TypeUInt8);
        std::vector<uint8_t> pixels(16 * 16 * 3);
        for (size_t i = 0; i < pixels.size(); ++i)
            pixels[i] = uint8_t(i);
        return file.create(path, m_failure) && file.open(spec, m_failure) &&
               file.write_rows(0, 16, OIIO::TypeUInt8, pixels.data()) && file.commit(m_failure);
    }

    std::string m_path;
    int m_end = -1;
    Failure m_failure;
};

TEST_F(Streams, HaveThePixelsOfAFile) {
    for (const char* name :
         {"s.gif", "s.hdr", "s.iff", "s.jpg", "s.exr", "s.png", "s.ppm", "s.webp"}) {
        if (!is_known(name))
            continue;
        open_pipe(name);
        ASSERT_TRUE(write(m_path)) << m_failure.why;
        const std::string got = temporary(std::string("got_") + name);
        std::ofstream(got, std::ios::binary) << taken_from(m_end);
        close_pipe();
        ASSERT_TRUE(write(m_path)) << m_failure.why;
        const OIIO::ImageBuf of_pipe(got), of_file(m_path);
        EXPECT_EQ(OIIO::ImageBufAlgo::computePixelHashSHA1(of_pipe),
                  OIIO::ImageBufAlgo::computePixelHashSHA1(of_file))
            << name;
    }
}

TEST_F(Streams, OfFormatsWhoseWritersGoBackAreRefusedAtOnce) {
    for (const char* name :
         {"s.bmp", "s.dpx", "s.fits", "s.ico", "s.jp2", "s.rla", "s.sgi", "s.tga", "s.tif"}) {
        if (!is_known(name))
            continue;
        open_pipe(name);
        EXPECT_FALSE(write(m_path)) << name;
        EXPECT_NE(m_failure.why.find(m_path), std::string::npos) << m_failure.why;
        EXPECT_NE(m_failure.why.find("allowed are gif, hdr"), std::string::npos) << m_failure.why;
        EXPECT_EQ(m_failure.code, exit_usage);
        EXPECT_EQ(taken_from(m_end), "");
        close_pipe();
    }
}

TEST_F(Streams, AnExrOfSeveralImagesIsRefusedAtOnce) {
    open_pipe("several.exr");
    const OIIO::ImageSpec spec(16, 16, 3, OIIO::TypeHalf);
    ImageFile file;
    ASSERT_TRUE(file.create(m_path, m_failure)) << m_failure.why;
    EXPECT_FALSE(file.open({spec, spec}, m_failure));
    EXPECT_NE(m_failure.why.find("allowed is one image"), std::string::npos) << m_failure.why;
    EXPECT_EQ(m_failure.code, exit_usage);
    EXPECT_EQ(taken_from(m_end), "");
    close_pipe();
}

TEST_F(Streams, WhatCanBeSoughtInIsNone) {
    const std::string link = temporary("nothing.bmp");
    std::filesystem::create_symlink("/dev/null", link);
    EXPECT_TRUE(write(link)) << m_failure.why;
}

} // namespace
} // namespace ddt::tool
