// SPDX-License-Identifier: Apache-2.0
// Whether pixels of a file can be read.
#pragma once

#include <string>

#include <OpenImageIO/imageio.h>

namespace ddt::tool {

/// Read the rows [begin, end) of the image that the input is at, and forget them. False with a line
/// in input.geterror(), if its reader has one, where that fails.
bool can_be_read(OIIO::ImageInput& input, int begin, int end);
/// All rows.
bool can_be_read(OIIO::ImageInput& input);

/// Whether OpenImageIO, where it reads much at once, as into an ImageBuf or through a cache, may
/// pass over what it cannot read of an image of this format: strips and tiles of TIFF.
bool may_pass_over(const std::string& format, const OIIO::ImageSpec& spec);

} // namespace ddt::tool
