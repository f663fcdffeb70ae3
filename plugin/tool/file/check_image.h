// SPDX-License-Identifier: Apache-2.0
// Whether an image is one that can be worked on.
#pragma once

#include <string>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imageio.h>

#include "ddt/resize.h"
#include "plugin/tool/command/exit_code.h"

namespace ddt::tool {

/// False with a failure, which begins with the name (image_name() of open_image.h), unless the
/// image is one that can be worked on with these options.
bool check_image(const OIIO::ImageBuf& image, const std::string& name, const Options& options,
                 Failure& failure);

/// False with a failure unless an image of that size may be had (check_size() of
/// plugin/image/memory.h).
bool check_size_of(const OIIO::ImageSpec& spec, Failure& failure);

} // namespace ddt::tool
