// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/memory.h"

#include "tests/plugin/images.h"

namespace {

using images::window;

TEST(ImageMemory, SizesAreChecked) {
    std::string error;
    EXPECT_TRUE(ddt::check_size(window(0, 4096, 0, 4096), 4, OIIO::TypeFloat, error)) << error;
    EXPECT_FALSE(ddt::check_size(window(0, 1000000, 0, 1000000), 4, OIIO::TypeFloat, error));
    EXPECT_NE(error.find("1000000 x 1000000"), std::string::npos) << error;
    EXPECT_NE(error.find("limits:imagesize_MB"), std::string::npos) << error;
    EXPECT_FALSE(ddt::check_size(window(0, 1 << 30, 0, 1), 1, OIIO::TypeUInt8, error));
    EXPECT_FALSE(ddt::check_size(window(-2147483647, 2147483647, 0, 1), 1, OIIO::TypeUInt8, error));
    // 64 MB a channel.
    EXPECT_FALSE(ddt::check_size(window(0, 4096, 0, 4096), 1 << 20, OIIO::TypeFloat, error));
    EXPECT_FALSE(ddt::check_size(window(5, 5, 0, 1), 1, OIIO::TypeUInt8, error));
    EXPECT_FALSE(ddt::check_size(window(9, 5, 0, 1), 1, OIIO::TypeUInt8, error));
}

} // namespace
