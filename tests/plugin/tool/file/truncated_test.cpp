// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/truncated.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include "plugin/tool/file/open_image.h"
#include "plugin/tool/part/resize_part.h"
#include "plugin/tool/resize/resize_file.h"
#include "tests/temporary.h"

namespace ddt::tool {
namespace {

/// What a TIFF is made of, here.
struct Kind {
    bool big_tiff, big_endian;
};

/// A TIFF whose directories come first, as OpenImageIO's writer leaves them now and then: images of
/// 8 x 12 bytes in strips of 4 rows.
class SmallTiff {
public:
    explicit SmallTiff(Kind kind, int images = 1, uint64_t compression = 8)
        : m_big(kind.big_tiff), m_big_endian(kind.big_endian) {
        const uint64_t word = m_big ? 8 : 4, head = m_big ? 16 : 8;
        const uint64_t tables = 3 * word + 3 * 4;
        const uint64_t directory = (m_big ? 8 : 2) + 8 * (4 + 2 * word) + word;
        m_bytes += m_big_endian ? "MM" : "II";
        put(m_big ? 43 : 42, 2);
        if (m_big) {
            put(8, 2);
            put(0, 2);
        }
        put(head, word);
        for (int i = 0; i < images; ++i) {
            const uint64_t at = m_bytes.size(), after = at + directory + tables + 96;
            const uint64_t offsets = at + directory, sizes = offsets + 3 * word;
            put(8, m_big ? 8 : 2);
            entry(256, 3, 1, 8);
            entry(257, 3, 1, 12);
            entry(258, 3, 1, 8);
            entry(259, 3, 1, compression);
            entry(273, m_big ? 16 : 4, 3, offsets);
            entry(277, 3, 1, 1);
            entry(278, 3, 1, 4);
            entry(279, 4, 3, sizes);
            put(i + 1 < images ? after : 0, word);
            for (uint64_t k = 0; k < 3; ++k)
                put(sizes + 3 * 4 + 32 * k, word);
            for (int k = 0; k < 3; ++k)
                put(32, 4);
            m_bytes.append(96, 'x');
        }
    }

    /// A file of so many of its bytes.
    std::string file(size_t length) const {
        std::string path = temporary("small.tif");
        std::ofstream(path, std::ios::binary).write(m_bytes.data(), std::streamsize(length));
        return path;
    }
    bool is_truncated(size_t length, int number = 0) const {
        return tool::is_truncated(file(length), "tiff", number);
    }
    size_t size() const { return m_bytes.size(); }
    std::string& bytes() { return m_bytes; }

private:
    void put(uint64_t n, uint64_t size) {
        for (uint64_t i = 0; i < size; ++i)
            m_bytes += char(n >> 8 * (m_big_endian ? size - 1 - i : i));
    }
    void entry(uint64_t tag, uint64_t type, uint64_t count, uint64_t value) {
        const uint64_t word = m_big ? 8 : 4;
        put(tag, 2);
        put(type, 2);
        put(count, word);
        const bool is_short = type == 3 && count == 1;
        put(value, is_short ? 2 : word);
        put(0, is_short ? word - 2 : 0);
    }

    const bool m_big, m_big_endian;
    std::string m_bytes;
};

constexpr Kind all_kinds[] = {{false, false}, {false, true}, {true, false}, {true, true}};

TEST(Truncated, IsATiffThatLacksAByteOfAnything) {
    for (const Kind kind : all_kinds)
        for (const int images : {1, 3}) {
            const SmallTiff tiff(kind, images);
            const int last = images - 1;
            EXPECT_FALSE(tiff.is_truncated(tiff.size(), last));
            for (size_t length = 16; length < tiff.size(); ++length)
                ASSERT_TRUE(tiff.is_truncated(length, last)) << length << " of " << tiff.size();
            // Another image's pixels are of no interest.
            EXPECT_EQ(tiff.is_truncated(tiff.size() - 1), images == 1);
        }
}

TEST(Truncated, IsNoTiffWhoseLastStripIsCountedAsWhole) {
    for (const Kind kind : all_kinds) {
        SmallTiff tiff(kind, 1, 1);
        const size_t height_at = (kind.big_tiff ? 24 + 20 + 12 : 10 + 12 + 8);
        tiff.bytes()[height_at + (kind.big_endian ? 1 : 0)] = 10; // rows, of 12
        EXPECT_FALSE(tiff.is_truncated(tiff.size() - 16));
        EXPECT_TRUE(tiff.is_truncated(tiff.size() - 17));
    }
}

TEST(Truncated, IsNoTiffThatEndsWithItsDirectory) {
    const int width = 8, height = 12, pixels = width * height;
    std::string bytes("II*\0", 4);
    const auto put = [&](int n, int size) {
        for (int i = 0; i < size; ++i)
            bytes += char(n >> 8 * i);
    };
    put(8 + pixels, 4);
    bytes.append(size_t(pixels), 'x');
    const int entries[][2] = {{256, width}, {257, height}, {258, 8},      {259, 1},
                              {273, 8},     {277, 1},      {278, height}, {279, pixels}};
    put(8, 2);
    for (const auto& [tag, value] : entries) {
        put(tag, 2);
        put(4, 2);
        put(1, 4);
        put(value, 4);
    }
    const std::string path = temporary("last.tif");
    std::ofstream(path, std::ios::binary) << bytes; // and not where the next is
    EXPECT_FALSE(is_truncated(path, "tiff", 0));
    std::filesystem::resize_file(path, bytes.size() - 1);
    EXPECT_TRUE(is_truncated(path, "tiff", 0));
}

TEST(Truncated, IsNoTiffThatMakesNoSense) {
    std::mt19937 random(1);
    for (int i = 0; i < 4000; ++i) {
        SmallTiff tiff(all_kinds[i % 4], 3, i % 3 ? 8 : 1);
        for (int k = 0; k < 3; ++k)
            tiff.bytes()[random() % (tiff.size() - 1)] = char(random() % 3 ? random() : 0xff);
        tiff.is_truncated(tiff.size(), i % 4); // which ends
    }
    SmallTiff loop({false, false});
    loop.bytes().replace(10 + 8 * 12, 4, std::string("\x08\0\0\0", 4)); // the next is the first
    EXPECT_FALSE(loop.is_truncated(loop.size(), 1000));
    EXPECT_FALSE(is_truncated(temporary("missing.tif"), "tiff", 0));
}

/// By each way that commands read a file; nothing where it was read.
std::vector<std::string> what_is_said(const std::string& path) {
    std::vector<std::string> said(4);
    OIIO::ImageBuf image;
    ResizeSettings settings;
    settings.size = "200%";
    Failure failures[2];
    const auto progress = [](float) { return true; };
    const std::string out = temporary("cut_off.exr");
    const bool read[] = {open_image(path, image, said[0]), open_input(path, 0, said[1]) != nullptr,
                         resize_file(path, out, settings, progress, failures[0]),
                         resize_part(path, out, settings, {1, 1}, progress, failures[1])};
    said[2] = failures[0].why;
    said[3] = failures[1].why;
    for (size_t k = 0; k < said.size(); ++k)
        EXPECT_EQ(read[k], said[k].empty()) << k;
    return said;
}

TEST(Truncated, IsWhatNoCommandReads) {
    const SmallTiff tiff({false, false}, 1, 1);
    for (const std::string& said : what_is_said(tiff.file(tiff.size())))
        EXPECT_EQ(said, "");
    for (const std::string& said : what_is_said(tiff.file(tiff.size() - 1)))
        EXPECT_EQ(said, "cannot read \"" + temporary("small.tif") +
                            "\": the file ends before its pixels do");
}

/// Write an image by OpenImageIO's writer; its file's name.
std::string written(const std::string& name, OIIO::ImageSpec spec, int images = 1) {
    const std::string path = temporary(name);
    const std::vector<float> pixels(spec.image_pixels() * size_t(spec.nchannels), 0.25f);
    const auto out = OIIO::ImageOutput::create(path);
    for (int i = 0; i < images; ++i) {
        EXPECT_TRUE(i == 0 ? out->open(path, spec)
                           : out->open(path, spec, OIIO::ImageOutput::AppendSubimage));
        EXPECT_TRUE(out->write_image(OIIO::TypeFloat, pixels.data())) << out->geterror();
    }
    EXPECT_TRUE(out->close());
    return path;
}

/// Not cut off, but as bad.
TEST(Truncated, NoCommandReadsWhatOverrunsMemory) {
    OIIO::ImageSpec spec(20, 10, 4, OIIO::TypeUInt8);
    spec.channelnames = {"C", "M", "Y", "K"};
    spec.attribute("tiff:ColorSpace", "CMYK");
    for (const std::string& said : what_is_said(written("strips.tif", spec)))
        EXPECT_EQ(said, "");
    spec.tile_width = spec.tile_height = 16;
    const std::string path = written("tiles.tif", spec);
    const std::string refused = "cannot read \"" + path + "\": it has CMYK in tiles";
    for (const std::string& said : what_is_said(path)) {
        if (OIIO::openimageio_version() < 30200)
            EXPECT_EQ(said.substr(0, refused.size()), refused);
        else
            EXPECT_EQ(said, "");
    }
}

TEST(Truncated, IsNothingThatIsWhole) {
    for (const char* compression : {"none", "zip", "lzw", "packbits"})
        for (const int tile : {0, 16})
            for (const char* planes : {"contig", "separate"})
                for (const int big : {0, 1}) {
                    OIIO::ImageSpec spec(70, 50, 3, OIIO::TypeUInt8);
                    spec.tile_width = spec.tile_height = tile;
                    spec.attribute("compression", compression);
                    spec.attribute("planarconfig", planes);
                    spec.attribute("tiff:bigtiff", big);
                    const std::string path = written("whole.tif", spec, 2);
                    for (const int number : {0, 1, 2})
                        EXPECT_FALSE(is_truncated(path, "tiff", number))
                            << compression << tile << planes << big << number;
                }
}

// Whether lines are filled up to words is not known.
TEST(Truncated, IsADpxOfFewerBytesThanItSays) {
    constexpr int line = 50 * 3 * 2;
    for (const int bits : {10, 12, 16}) {
        OIIO::ImageSpec spec(50, 40, 3, OIIO::TypeUInt16);
        spec.attribute("oiio:BitsPerSample", bits);
        for (const char* endian : {"little", "big"}) {
            spec.attribute("oiio:Endian", endian);
            const std::string path = written("small.dpx", spec);
            EXPECT_FALSE(is_truncated(path, "dpx", 0)) << bits << endian;
            std::filesystem::resize_file(path, std::filesystem::file_size(path) - line);
            EXPECT_TRUE(is_truncated(path, "dpx", 0)) << bits << endian;
            EXPECT_FALSE(is_truncated(path, "openexr", 0));
            std::fstream(path, std::ios::in | std::ios::out | std::ios::binary)
                .seekp(0, std::ios::end)
                .write(std::string(line, '\0').data(), line);
            EXPECT_FALSE(is_truncated(path, "dpx", 0));
            std::fstream(path, std::ios::in | std::ios::out | std::ios::binary)
                .seekp(16)
                .write(endian[0] == 'l' ? "\0\0\1\0" : "\0\1\0\0", 4); // a size that is not its own
            EXPECT_FALSE(is_truncated(path, "dpx", 0)) << "all pixels are there";
            std::filesystem::resize_file(path, std::filesystem::file_size(path) - line);
            EXPECT_TRUE(is_truncated(path, "dpx", 0)) << bits << endian;
            for (const char byte : {'\0', '\xff'}) { // no size
                std::fstream(path, std::ios::in | std::ios::out | std::ios::binary)
                    .seekp(16)
                    .write(std::string(4, byte).data(), 4);
                EXPECT_FALSE(is_truncated(path, "dpx", 0));
            }
        }
    }
}

} // namespace
} // namespace ddt::tool
