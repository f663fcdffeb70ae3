// SPDX-License-Identifier: Apache-2.0
// What of an image a file's format has room for.
#pragma once

#include <string>

#include <OpenImageIO/imageio.h>

#include "plugin/tool/exit_code.h"

namespace ddt::tool {

/// Make the spec of an image what `output` can write of it into the file `path`, as oiiotool does:
/// where the format has no windows, the pixels of the display window; where it has no negative
/// coordinates, those of no other; types of single channels only where it has them. False with a
/// failure if no pixel is left.
bool fit_format(const OIIO::ImageOutput& output, const std::string& path, OIIO::ImageSpec& spec,
                Failure& failure);

} // namespace ddt::tool
