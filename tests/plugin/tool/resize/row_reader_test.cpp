// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/open_image.h"
#include "plugin/tool/resize/row_reader.h"

#include <atomic>
#include <cstring>
#include <filesystem>

#include <OpenImageIO/imagebufalgo.h>
#include <gtest/gtest.h>

#include "plugin/imagebuf/resize.h"
#include "tests/temporary.h"

namespace ddt::tool {
namespace {

using OIIO::ImageBuf;

constexpr int usual_width = 301, usual_height = 1234;

ImageBuf noise(int channels, int width = usual_width, int height = usual_height) {
    OIIO::ImageSpec spec(width, height, channels, OIIO::TypeFloat);
    spec.x = -20;
    spec.y = 30;
    spec.full_x = -25;
    spec.full_width = width + 40;
    spec.full_height = height + 50;
    ImageBuf image(spec);
    OIIO::ImageBufAlgo::noise(image, "uniform", 0.0f, 1.0f);
    return image;
}

/// As bytes, row by row.
std::string pixels_of(const ImageBuf& image) {
    std::string pixels;
    const size_t row = image.spec().scanline_bytes();
    for (int y = image.ybegin(); y < image.yend(); ++y)
        pixels.append(static_cast<const char*>(image.pixeladdr(image.xbegin(), y)), row);
    return pixels;
}

class RowReaders : public testing::Test {
protected:
    struct Kind {
        const char* name;
        int channels;
        OIIO::TypeDesc type;
        int tile = 0;
        int width = usual_width, height = usual_height;
    };

    /// Write a file of this kind.
    std::string file(const Kind& kind) {
        const std::string path = temporary(kind.name);
        ImageBuf image = noise(kind.channels, kind.width, kind.height);
        image.set_write_format(kind.type);
        if (kind.tile)
            image.set_write_tiles(kind.tile, kind.tile);
        EXPECT_TRUE(image.write(path)) << image.geterror();
        return path;
    }
};

TEST_F(RowReaders, ReadWhatIsReadAtOnce) {
    const Kind kinds[] = {{"half.exr", 4, OIIO::TypeHalf},
                          {"float.exr", 1, OIIO::TypeFloat},
                          {"tiled.exr", 3, OIIO::TypeHalf, 64},
                          {"bytes.tif", 3, OIIO::TypeUInt8},
                          {"tiled.tif", 3, OIIO::TypeUInt16, 32},
                          {"bytes.png", 4, OIIO::TypeUInt8},
                          {"bytes.jpg", 3, OIIO::TypeUInt8},
                          {"ids.tif", 1, OIIO::TypeUInt32},
                          // Of more than is read at once, which is 8 MiB, about.
                          {"wide.exr", 4, OIIO::TypeHalf, 64, 3000, 400}};
    for (const Kind& kind : kinds) {
        SCOPED_TRACE(kind.name);
        const std::string path = file(kind);
        ImageBuf expected, image;
        std::string error;
        ASSERT_TRUE(open_image(path, expected, error)) << error;
        RowReader reader;
        ASSERT_TRUE(reader.begin(path, image, error)) << error;
        EXPECT_EQ(image.spec().serialize(OIIO::ImageSpec::SerialXML),
                  expected.spec().serialize(OIIO::ImageSpec::SerialXML));
        EXPECT_EQ(image.nativespec().format, expected.nativespec().format);
        for (const int end : {image.ybegin(), image.ybegin() + 100, image.yend()})
            ASSERT_TRUE(reader.wait_for(end, error)) << error;
        EXPECT_TRUE(pixels_of(image) == pixels_of(expected));
    }
}

TEST_F(RowReaders, ChannelsOfSeveralTypesComeToo) {
    ImageBuf given = noise(2);
    const std::string path = temporary("types.exr");
    const auto out = OIIO::ImageOutput::create(path);
    OIIO::ImageSpec spec = given.spec();
    spec.channelformats = {OIIO::TypeHalf, OIIO::TypeFloat};
    ASSERT_TRUE(out->open(path, spec));
    ASSERT_TRUE(out->write_image(OIIO::TypeFloat, given.localpixels()));
    ASSERT_TRUE(out->close());
    ImageBuf expected, image;
    std::string error;
    ASSERT_TRUE(open_image(path, expected, error)) << error;
    RowReader reader;
    ASSERT_TRUE(reader.begin(path, image, error)) << error;
    ASSERT_TRUE(reader.wait_for(image.yend(), error)) << error;
    EXPECT_TRUE(pixels_of(image) == pixels_of(expected));
}

TEST_F(RowReaders, TellWhatCannotBeRead) {
    ImageBuf image;
    std::string error;
    EXPECT_FALSE(RowReader().begin(temporary("missing.exr"), image, error));
    EXPECT_NE(error.find("missing.exr"), std::string::npos) << error;
    for (const Kind& kind :
         {Kind{"cut.exr", 3, OIIO::TypeHalf}, Kind{"cut.png", 3, OIIO::TypeUInt8},
          Kind{"cut_tiles.exr", 3, OIIO::TypeHalf, 64}}) {
        SCOPED_TRACE(kind.name);
        const std::string path = file(kind);
        std::filesystem::resize_file(path, std::filesystem::file_size(path) * 2 / 3);
        RowReader reader;
        error.clear();
        const bool all = reader.begin(path, image, error) && reader.wait_for(image.yend(), error);
        EXPECT_FALSE(all);
        EXPECT_NE(error.find(kind.name), std::string::npos) << error;
        // And again, whoever asks.
        std::string same;
        EXPECT_FALSE(reader.wait_for(image.yend(), same));
        EXPECT_EQ(same, error);
    }
}

TEST_F(RowReaders, MayGoBeforeTheyAreDone) {
    const std::string path = file({"long.exr", 4, OIIO::TypeFloat});
    for (int i = 0; i < 5; ++i) {
        ImageBuf image;
        std::string error;
        RowReader reader;
        ASSERT_TRUE(reader.begin(path, image, error)) << error;
    }
}

/// An image whose rows come when they are asked for, up to a row from which on they do not.
class OnDemand final : public Arrival {
public:
    OnDemand(ImageBuf& image, const ImageBuf& from, int missing)
        : m_image(image), m_from(from), m_missing(missing), m_ready(image.ybegin()) {}
    bool wait_for(int end, std::string& error) override {
        const std::lock_guard lock(m_mutex);
        if (asked == 0)
            first = end;
        ++asked;
        if (end > m_missing) {
            error = "the wire was cut";
            return false;
        }
        for (; m_ready < end; ++m_ready)
            std::memcpy(m_image.pixeladdr(m_image.xbegin(), m_ready),
                        m_from.pixeladdr(m_image.xbegin(), m_ready),
                        m_image.spec().scanline_bytes());
        return true;
    }

    int asked = 0, first = 0;

private:
    ImageBuf& m_image;
    const ImageBuf& m_from;
    const int m_missing;
    std::mutex m_mutex;
    int m_ready;
};

TEST(Arriving, PixelsAreWaitedForAsTheyAreNeededAndTheBitsAreTheSame) {
    const ImageBuf source = noise(3);
    struct Size {
        int width, height;
        bool by_rows;
    };
    // Enlarged; as it is; the one axis up, the other down.
    for (const Size size :
         {Size{500, 3000, true}, Size{341, 1284, false}, Size{200, 3000, false}}) {
        const OIIO::ROI roi(0, size.width, 0, size.height);
        ImageBuf expected, result, arriving(source.spec());
        ASSERT_TRUE(ddt::resize(expected, source, {}, roi, 2)) << expected.geterror();
        OnDemand rows(arriving, source, source.yend());
        ASSERT_TRUE(resize_arriving(result, arriving, &rows, {}, roi, 2)) << result.geterror();
        EXPECT_GE(rows.asked, 1);
        EXPECT_EQ(rows.first < source.yend(), size.by_rows) << size.width;
        EXPECT_TRUE(pixels_of(result) == pixels_of(expected)) << size.width;
    }
}

TEST(Arriving, WhatDoesNotComeIsAFailure) {
    const ImageBuf source = noise(1);
    for (const int columns : {700, 200}) {
        ImageBuf result, arriving(source.spec());
        OnDemand rows(arriving, source, source.ybegin() + 700);
        EXPECT_FALSE(
            resize_arriving(result, arriving, &rows, {}, OIIO::ROI(0, columns, 0, 2500), 2));
        EXPECT_NE(result.geterror().find("the wire was cut"), std::string::npos);
        EXPECT_FALSE(result.initialized());
    }
}

} // namespace
} // namespace ddt::tool
