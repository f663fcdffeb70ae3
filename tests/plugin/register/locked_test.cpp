// SPDX-License-Identifier: Apache-2.0
// The plugin on a system that does not let pages be made writable.
#include <string>

#include <dlfcn.h>

#include <gtest/gtest.h>

#include <OpenImageIO/imagebufalgo.h>

#include "tests/plugin/register/refuse_writable.h"

namespace {

TEST(Locked, WhatCouldNotBeRedirectedIsTold) {
    const OIIO::ImageBuf image(OIIO::ImageSpec(4, 4, 1, OIIO::TypeFloat));
    ASSERT_TRUE(image.initialized()); // the library is used
    setenv("DDT_VERBOSE", "1", 1);
    testing::internal::CaptureStderr();
    refuse = true;
    void* plugin = dlopen(DDT_PLUGIN_FILE, RTLD_NOW | RTLD_LOCAL);
    refuse = false;
    const std::string told = testing::internal::GetCapturedStderr();
    ASSERT_NE(plugin, nullptr) << dlerror();
    EXPECT_NE(told.find("that the system keeps locked"), std::string::npos) << told;
    auto* redirects = reinterpret_cast<const char* (*)()>(dlsym(plugin, "ddt_redirects"));
    ASSERT_NE(redirects, nullptr) << dlerror();
    EXPECT_NE(std::string(redirects()).find("that the system keeps locked"), std::string::npos)
        << redirects();
}

} // namespace
