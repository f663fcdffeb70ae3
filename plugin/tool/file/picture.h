// SPDX-License-Identifier: Apache-2.0
// An image as a display shows it.
#pragma once

#include <string>
#include <vector>

#include <OpenImageIO/imagebuf.h>

#include "ddt/resize.h"

namespace ddt::tool {

/// One pixel as a display shows it: not associated with alpha, 0 to 1 from black to white (values
/// of a scene may be beyond).
struct Colour {
    float red = 0, green = 0, blue = 0, alpha = 1;
};

/// The pixels of an image's data window, row by row.
struct Picture {
    int width = 0, height = 0;
    bool has_alpha = false;
    std::vector<Colour> colours; ///< grey as three equal; without colour, the guide's channel
    std::vector<float> guide;
    std::vector<float> heights; ///< a pixel, in a mesh that is lifted (mesh/heights.h); or none
};

/// Read an image under options.light. False with one line in `error`, as for an image of IDs
/// alone, which no display shows.
bool read_picture(const OIIO::ImageBuf& image, const Options& options, Picture& picture,
                  std::string& error);

} // namespace ddt::tool
