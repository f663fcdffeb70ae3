// SPDX-License-Identifier: Apache-2.0
// What is told of an image beside its pixels.
#pragma once

#include <OpenImageIO/imageio.h>

namespace ddt {

/// Take away what is true of the source's pixels only, and of how its file keeps them.
inline void forget_pixels(OIIO::ImageSpec& spec) {
    for (const char* name : {"oiio:SHA-1", "oiio:ConstantColor", "oiio:AverageColor",
                             "textureformat", "openexr:chunkCount"})
        spec.erase_attribute(name);
}

/// Forget the metadata's sizes that are no longer the picture's.
inline void forget_old_size(OIIO::ImageSpec& spec) {
    const auto check = [&](const char* name, int size) {
        if (spec.get_int_attribute(name, size) != size)
            spec.erase_attribute(name);
    };
    check("Exif:PixelXDimension", spec.full_width);
    check("Exif:PixelYDimension", spec.full_height);
}

} // namespace ddt
