// SPDX-License-Identifier: Apache-2.0
// What an image's vertices are lifted by.
#pragma once

#include <string>
#include <vector>

#include <OpenImageIO/imagebuf.h>

namespace ddt::tool {

/// The numbers of pixels as the file has them, 1 for the largest of a whole-number type: of what a
/// picture of the image shows (shown_colour() of plugin/image/channels.h) the one channel's, or the
/// luminance (ddt/guide.h) of the three. Alpha plays no part: where the file keeps colour
/// unassociated, it is so here; what is not finite is left as it is. No curve and no rounding: a
/// height in metres stays one.
///
/// `image`: the file's, as open_image() has it; `filled`: that one, or with pixels changed. False
/// with one line in `error`.
bool read_heights(const std::string& path, const OIIO::ImageBuf& image,
                  const OIIO::ImageBuf& filled, std::vector<float>& heights, std::string& error);

} // namespace ddt::tool
