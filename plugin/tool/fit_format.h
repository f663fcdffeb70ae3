// SPDX-License-Identifier: Apache-2.0
// What of an image a file's format has room for.
#pragma once

#include <string>

#include <OpenImageIO/imageio.h>

namespace ddt::tool {

/// Make the spec of an image what `output` can write of it, as oiiotool does: where the format has
/// no windows, the pixels of the display window; where it has no negative coordinates, those of no
/// other; types of single channels only where it has them. False with one line in `error` if no
/// pixel is left.
bool fit_format(const OIIO::ImageOutput& output, OIIO::ImageSpec& spec, std::string& error);

} // namespace ddt::tool
