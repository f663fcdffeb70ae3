// SPDX-License-Identifier: Apache-2.0
// What a file is to become, before it is resized.
#pragma once

#include <string>

#include <OpenImageIO/imageio.h>

#include "ddt/resize.h"
#include "plugin/tool/command/exit_code.h"

namespace ddt::tool {

struct ResizeSettings {
    std::string size; ///< see size.h
    Options options;
    std::string type;        ///< of the result's pixels; empty: the image's
    std::string compression; ///< of the result's file; empty: the image's, or the format's usual
    int threads = 1;         ///< at least 1
    bool all_images = false; ///< of a file, one after another; not its first alone
};

/// What an image of spec `from`, which check_image() of file/check_image.h found right, becomes:
/// the windows that oiiotool makes. The size is the display window's; the data window is scaled
/// along with it, its origin rounded down, its size up. Where a size does not change, the origin
/// does not either. False with a failure if the size is not allowed, or the data window would leave
/// the coordinates that are allowed.
bool plan_result(const OIIO::ImageSpec& from, const ResizeSettings& settings,
                 OIIO::ImageSpec& result, Failure& failure);

} // namespace ddt::tool
