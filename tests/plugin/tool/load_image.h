// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <OpenImageIO/imagebuf.h>
#include <gtest/gtest.h>

#include "plugin/tool/file/open_image.h"

namespace ddt::tool {

/// A file's image as the commands open it: not one that OpenImageIO still has of an older file.
inline OIIO::ImageBuf load(const std::string& path) {
    OIIO::ImageBuf image;
    std::string error;
    EXPECT_TRUE(open_image(path, image, error)) << error;
    return image;
}

} // namespace ddt::tool
