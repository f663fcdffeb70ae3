// SPDX-License-Identifier: Apache-2.0
// `ddt resize --all-images`.
#include <filesystem>
#include <vector>

#include <OpenImageIO/imagebufalgo.h>
#include <gtest/gtest.h>

#include "plugin/tool/commands.h"
#include "plugin/tool/file/other_images.h"
#include "plugin/tool/resize/resize_file.h"
#include "tests/plugin/tool/run_command.h"
#include "tests/plugin/tool/several_types.h"
#include "tests/temporary.h"

namespace ddt::tool {
namespace {

using OIIO::ImageBuf;
using OIIO::ImageSpec;

bool all_resized(const std::string& in, const std::string& size, const std::string& out,
                 Failure& failure) {
    ResizeSettings settings;
    settings.size = size;
    settings.all_images = true;
    float last = 0;
    const auto progress = [&](float share) {
        EXPECT_GE(share, last);
        EXPECT_LE(share, 1.0f);
        last = share;
        return true;
    };
    return resize_file(in, out, settings, progress, failure);
}

/// A window of noise in a display of 40 x 30 pixels, another one for every number.
ImageBuf page(int number, const OIIO::ROI& window, int channels = 3,
              OIIO::TypeDesc type = OIIO::TypeUInt8) {
    ImageSpec spec(window.width(), window.height(), channels, type);
    OIIO::set_roi(spec, window);
    spec.full_width = 40;
    spec.full_height = 30;
    spec.attribute("oiio:subimagename", "page " + std::to_string(number));
    ImageBuf image(spec);
    OIIO::ImageBufAlgo::noise(image, "uniform", 0.0f, 1.0f, false, number);
    return image;
}

std::string write(const std::string& name, const std::vector<ImageBuf>& images) {
    const std::string path = temporary(name);
    std::vector<ImageSpec> specs;
    for (const ImageBuf& image : images)
        specs.push_back(image.spec());
    const auto out = OIIO::ImageOutput::create(path);
    EXPECT_TRUE(out->open(path, int(specs.size()), specs.data())) << out->geterror();
    for (size_t i = 0; i < images.size(); ++i) {
        EXPECT_TRUE(i == 0 || out->open(path, specs[i], OIIO::ImageOutput::AppendSubimage));
        EXPECT_TRUE(images[i].write(out.get())) << images[i].geterror();
    }
    EXPECT_TRUE(out->close());
    return path;
}

/// That image i of a file has the windows, the type and the pixels of a file's first.
void expect_same(const std::string& path, int i, const std::string& alone) {
    SCOPED_TRACE(path + ", " + std::to_string(i));
    const ImageBuf made(path, i, 0), expected(alone);
    EXPECT_EQ(made.roi(), expected.roi());
    EXPECT_EQ(made.roi_full(), expected.roi_full());
    EXPECT_EQ(made.spec().format, expected.spec().format);
    EXPECT_EQ(made.spec().get_string_attribute("oiio:subimagename"),
              expected.spec().get_string_attribute("oiio:subimagename"));
    EXPECT_EQ(OIIO::ImageBufAlgo::computePixelHashSHA1(made),
              OIIO::ImageBufAlgo::computePixelHashSHA1(expected));
}

// Windows, channels and types are of each image's own.
TEST(AllImages, AreEachWhatTheyAreAlone) {
    const OIIO::ROI whole(0, 40, 0, 30, 0, 1, 0, 3), inside(5, 25, 3, 28, 0, 1, 0, 1),
        beyond(-7, 50, 10, 20, 0, 1, 0, 4);
    const struct {
        const char* name;
        std::vector<ImageBuf> images;
    } files[] = {
        {"pages.tif", {page(1, whole), page(2, whole, 1, OIIO::TypeUInt16), page(3, whole)}},
        {"parts.exr",
         {page(1, whole, 3, OIIO::TypeHalf), page(2, inside, 1, OIIO::TypeFloat),
          page(3, beyond, 4, OIIO::TypeHalf)}}};
    for (const auto& [name, images] : files) {
        const std::string in = write(name, images);
        for (const std::string size : {"200%", "100x90", "50%"}) {
            const std::string out = temporary("all_" + size + name);
            Failure failure;
            testing::internal::CaptureStderr();
            EXPECT_TRUE(all_resized(in, size, out, failure)) << failure.why;
            EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
            ASSERT_EQ(count_images(out), int(images.size()));
            for (size_t i = 0; i < images.size(); ++i) {
                const std::string one = write(std::to_string(i) + size + name, {images[i]});
                const std::string alone = temporary(std::to_string(i) + size + "alone_" + name);
                ASSERT_TRUE(all_resized(one, size, alone, failure)) << failure.why;
                EXPECT_EQ(count_images(alone), 1);
                expect_same(out, int(i), alone);
            }
        }
    }
}

TEST(AllImages, KeepTheirObjectNumbers) {
    const std::string in = file_of_several_types({70000, 16777217});
    const std::string out = temporary("all_ids.exr");
    Failure failure;
    ASSERT_TRUE(all_resized(in, "300%", out, failure)) << failure.why;
    EXPECT_EQ(ids_of(out, 0), std::make_pair(uint32_t(5), uint32_t(70000)));
    EXPECT_EQ(ids_of(out, 1), std::make_pair(uint32_t(5), uint32_t(16777217)));
}

TEST(AllImages, NeedAFormatThatHoldsSeveral) {
    const OIIO::ROI whole(0, 40, 0, 30, 0, 1, 0, 3);
    const std::string in = write("two.tif", {page(1, whole), page(2, whole)});
    for (const char* name : {"two.png", "two.fits"}) {
        const std::string out = temporary(name);
        Failure failure;
        EXPECT_FALSE(all_resized(in, "200%", out, failure));
        EXPECT_NE(failure.why.find(" holds one image, not 2"), std::string::npos) << failure.why;
        EXPECT_FALSE(std::filesystem::exists(out));
    }
    // Of one image any format will do.
    Failure failure;
    EXPECT_TRUE(
        all_resized(write("one.tif", {page(1, whole)}), "200%", temporary("one.png"), failure))
        << failure.why;
}

TEST(AllImages, AreAlikeWhereTheFormatHasThemSo) {
    const OIIO::ROI small(0, 30, 0, 20, 0, 1, 0, 3), large(0, 40, 0, 30, 0, 1, 0, 3);
    const auto alone = [](int number, const OIIO::ROI& window) {
        ImageBuf image = page(number, window);
        image.set_roi_full(window);
        return image;
    };
    for (const bool growing : {true, false}) {
        const std::string in =
            write(growing ? "growing.tif" : "shrinking.tif",
                  {alone(1, growing ? small : large), alone(2, growing ? large : small)});
        for (const auto& [ending, what] :
             {std::pair(".gif", "one size"), {".exr", "one display window"}}) {
            const std::string out = in + ending;
            Failure failure;
            EXPECT_FALSE(all_resized(in, "200%", out, failure));
            EXPECT_NE(failure.why.find(what), std::string::npos) << failure.why;
            EXPECT_FALSE(std::filesystem::exists(out));
            EXPECT_TRUE(all_resized(in, "64x48", out, failure)) << failure.why;
            EXPECT_EQ(count_images(out), 2);
        }
    }
}

TEST(AllImages, AreNoneWhereOneCannotBeRead) {
    const OIIO::ROI whole(0, 40, 0, 30, 0, 1, 0, 3);
    const std::string in = write("cut.exr", {page(1, whole), page(2, whole)});
    const std::string out = temporary("cut_out.exr");
    std::filesystem::resize_file(in, std::filesystem::file_size(in) * 9 / 10);
    Failure failure;
    EXPECT_FALSE(all_resized(in, "200%", out, failure));
    EXPECT_NE(failure.why.find(in), std::string::npos) << failure.why;
    EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(AllImages, AreNotOfAPart) {
    const auto [code, out, err] =
        run(make_resize_command(), {"--all-images", "--part", "1/2", "a.exr", "2", "b.exr"});
    EXPECT_EQ(code, exit_usage);
    EXPECT_NE(err.find("leave out --all-images"), std::string::npos) << err;
}

} // namespace
} // namespace ddt::tool
