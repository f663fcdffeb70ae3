// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/open_image.h"
#include "plugin/tool/file/other_images.h"

#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

#include <sys/stat.h>

#include <OpenImageIO/strutil.h>
#include <gtest/gtest.h>

#include "tests/temporary.h"

namespace ddt::tool {
namespace {

constexpr const char* extension = ".growing";

/// Reads black pixels of a file that has another byte after each row.
class GrowingInput final : public OIIO::ImageInput {
public:
    const char* format_name() const override { return "growing"; }
    bool open(const std::string& name, OIIO::ImageSpec& spec) override {
        m_name = name;
        m_spec = spec = OIIO::ImageSpec(4, 4, 1, OIIO::TypeUInt8);
        return OIIO::Strutil::ends_with(name, extension); // any are tried where others fail
    }
    bool close() override { return true; }
    bool read_native_scanline(int, int, int, int, void* data) override {
        std::memset(data, 0, m_spec.scanline_bytes());
        std::ofstream(m_name, std::ios::app).put('x');
        return true;
    }

private:
    std::string m_name;
};

TEST(OpenImage, OfAPipeOrADeviceThereIsNone) {
    const std::string pipe = temporary("pipe.png"), device = temporary("device.png");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    std::filesystem::create_symlink("/dev/zero", device);
    for (const auto& [path, what] :
         {std::pair{pipe, "pipe"}, {device, "device"}, {std::string("/dev/zero"), "device"}}) {
        OIIO::ImageBuf image;
        std::string error;
        EXPECT_FALSE(open_image(path, image, error));
        EXPECT_EQ(error, "cannot read \"" + path + "\": it is a " + what +
                             ", and images are read from files alone");
    }
}

TEST(OpenImage, OfAFileThatChangesMeanwhileThereIsNone) {
    static const char* extensions[] = {extension + 1, nullptr};
    OIIO::declare_imageio_format(
        "growing", []() -> OIIO::ImageInput* { return new GrowingInput; }, extensions, nullptr,
        nullptr, nullptr);
    const std::string path = temporary(std::string("file") + extension);
    std::ofstream(path).put('x');
    OIIO::ImageBuf image;
    std::string error;
    EXPECT_FALSE(open_image(path, image, error));
    EXPECT_GT(text_in(path).size(), 1u);
    EXPECT_EQ(error, "\"" + path + "\" was changed while it was read");
    EXPECT_EQ(unreadable(path, error).code, exit_resources);
}

constexpr const char* of_several = ".several";

/// Has three images, and says of their number what a test wants.
class SeveralInput final : public OIIO::ImageInput {
public:
    static inline OIIO::ParamValue told;
    static inline int sought = 0;

    const char* format_name() const override { return "several"; }
    bool open(const std::string& name, OIIO::ImageSpec& spec) override {
        m_spec = OIIO::ImageSpec(4, 4, 1, OIIO::TypeUInt8);
        if (!told.name().empty())
            m_spec.extra_attribs.push_back(told);
        spec = m_spec;
        return OIIO::Strutil::ends_with(name, of_several);
    }
    bool close() override { return true; }
    bool seek_subimage(int number, int level) override {
        ++sought;
        return number >= 0 && number < 3 && level == 0;
    }
    bool read_native_scanline(int, int, int, int, void*) override { return false; }
};

/// PNG has texts of any name.
TEST(CountImages, BelievesNoNumberOfAFileItself) {
    static const char* extensions[] = {of_several + 1, nullptr};
    OIIO::declare_imageio_format(
        "several", []() -> OIIO::ImageInput* { return new SeveralInput; }, extensions, nullptr,
        nullptr, nullptr);
    const std::string path = temporary(std::string("file") + of_several);
    std::ofstream(path).put('x');
    const char* const name = "oiio:subimages";
    const int many = 2000000000, negative = -7, right = 3, few = 2;
    const OIIO::ustring text("2000000000");
    for (const OIIO::ParamValue& told :
         {OIIO::ParamValue(), OIIO::ParamValue(name, OIIO::TypeInt, 1, &many),
          OIIO::ParamValue(name, OIIO::TypeInt, 1, &negative),
          OIIO::ParamValue(name, OIIO::TypeInt, 1, &few),
          OIIO::ParamValue(name, OIIO::TypeInt, 1, &right),
          OIIO::ParamValue(name, OIIO::TypeString, 1, &text)}) {
        SeveralInput::told = told;
        SeveralInput::sought = 0;
        EXPECT_EQ(count_images(path), 3) << told.get_string();
        if (told.type() == OIIO::TypeInt && told.get_int() == right) {
            EXPECT_EQ(SeveralInput::sought, 2); // the last, and none after it
        }
    }
}

} // namespace
} // namespace ddt::tool
