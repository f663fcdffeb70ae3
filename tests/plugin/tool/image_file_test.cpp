// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/image_file.h"

#include <sys/resource.h>

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

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

TEST(CodeOfReading, SaysWhetherToTryAgain) {
    const std::string path = temporary("broken.exr");
    std::ofstream(path) << "no picture";
    EXPECT_EQ(code_of_reading(path), exit_failed);
    EXPECT_EQ(code_of_reading(temporary("missing.exr")), exit_failed);
    EXPECT_EQ(code_of_reading(temporary("")), exit_failed);
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &before), 0);
    const rlimit none{0, before.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &none), 0);
    const ExitCode code = code_of_reading(path);
    ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &before), 0);
    EXPECT_EQ(code, exit_resources);
}

} // namespace
} // namespace ddt::tool
