// SPDX-License-Identifier: Apache-2.0
// The plugin in a program that uses another version of OpenImageIO, which a library stands in for
// that goes by such a name.
#include <string>

#include <dlfcn.h>

#include <gtest/gtest.h>

#include "tests/plugin/register/answer.h"

namespace {

TEST(Version, AnotherOpenImageIOIsToldInOneLineAndLeftAlone) {
    ASSERT_EQ(answer(), 42); // the library is used
    testing::internal::CaptureStderr();
    void* plugin = dlopen(DDT_PLUGIN_FILE, RTLD_NOW | RTLD_LOCAL);
    const std::string told = testing::internal::GetCapturedStderr();
    ASSERT_NE(plugin, nullptr) << dlerror();
    EXPECT_EQ(told.find("ddt: this plugin is built for OpenImageIO "), 0u) << told;
    EXPECT_NE(told.find("the program uses 9.9"), std::string::npos) << told;
    EXPECT_EQ(told.find('\n'), told.size() - 1) << told;

    // OpenImageIO refuses it for this number.
    EXPECT_EQ(*static_cast<int*>(dlsym(plugin, "ddt_imageio_version")), -1);
    auto* redirects = reinterpret_cast<const char* (*)()>(dlsym(plugin, "ddt_redirects"));
    EXPECT_EQ(std::string(redirects()).find("0 of 0"), 0u) << redirects();
}

} // namespace
