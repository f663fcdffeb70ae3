// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/reading_errors.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include <OpenImageIO/imagebuf.h>

#include "plugin/tool/file/open_image.h"
#include "plugin/tool/part/join.h"
#include "tests/resource_limit.h"
#include "tests/temporary.h"

namespace ddt::tool {
namespace {

TEST(CodeOfReading, SaysWhetherToTryAgain) {
    const std::string path = temporary("broken.exr");
    std::ofstream(path) << "no picture";
    EXPECT_EQ(code_of_reading(path), exit_failed);
    EXPECT_EQ(code_of_reading(temporary("missing.exr")), exit_failed);
    EXPECT_EQ(code_of_reading(temporary("")), exit_failed);
    const auto code = [&] {
        const test::ResourceLimit none(RLIMIT_NOFILE, 0);
        return code_of_reading(path);
    }();
    EXPECT_EQ(code, exit_resources);
}

/// Run `body` as a user who is not root, if need be; whether that could be done.
template <class Body>
bool without_rights(Body&& body) {
    constexpr uid_t nobody = 65534;
    const bool is_root = geteuid() == 0;
    if (is_root && seteuid(nobody) != 0)
        return false;
    body();
    return !is_root || seteuid(0) == 0;
}

TEST(Unreadable, FilesThatMayNotBeReadAreCalledSo) {
    const std::string path = temporary("secret.exr");
    ASSERT_TRUE(OIIO::ImageBuf(OIIO::ImageSpec(8, 8, 3, OIIO::TypeHalf)).write(path));
    ASSERT_EQ(why_not_opened(path), "");
    ASSERT_EQ(chmod(path.c_str(), 0), 0);
    const std::string said = "cannot read \"" + path + "\": Permission denied";
    std::string error;
    Failure failure;
    const bool tried = without_rights([&] {
        OIIO::ImageBuf image;
        EXPECT_FALSE(open_image(path, image, error));
        const auto progress = [](float) { return true; };
        EXPECT_FALSE(join({path}, temporary("of_secret.exr"), progress, failure));
    });
    if (!tried)
        GTEST_SKIP() << "root cannot become another user here";
    EXPECT_EQ(error, said);
    EXPECT_EQ(failure.why, said);
    EXPECT_EQ(failure.code, exit_failed);
}

// Readers of EXR, PNG and JPEG call what is not there broken.
TEST(Unreadable, FilesThatAreNotThereAreCalledSo) {
    for (const char* name : {"not_there.exr", "not_there.png", "not_there.tif", "not_there.jpg"}) {
        const std::string path = temporary(name);
        OIIO::ImageBuf image;
        std::string error;
        EXPECT_FALSE(open_image(path, image, error));
        EXPECT_EQ(error, "cannot read \"" + path + "\": No such file or directory");
        EXPECT_EQ(open_input(path, 0, error), nullptr);
        EXPECT_EQ(error, "cannot read \"" + path + "\": No such file or directory");
    }
    OIIO::ImageBuf image;
    std::string error;
    EXPECT_TRUE(open_image("a.null?RES=4x4", image, error)) << error;
}

TEST(Unreadable, WhatTheSystemSaysIsSaidOfFilesThatAreThere) {
    const std::string loop = temporary("loop.exr");
    std::filesystem::create_symlink(loop, loop);
    EXPECT_EQ(why_not_opened(loop), std::strerror(ELOOP));
    EXPECT_EQ(why_not_opened(temporary("missing.exr")), "");
}

TEST(Unreadable, WhatIsSaidTwiceIsSaidOnce) {
    const std::string path = temporary("there.png");
    std::ofstream(path) << "no picture";
    EXPECT_EQ(why_unreadable("no header\nnothing read\nno header\nnothing read\n", path),
              "\"" + path + "\": no header\nnothing read");
}

} // namespace
} // namespace ddt::tool
