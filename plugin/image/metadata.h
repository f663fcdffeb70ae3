// SPDX-License-Identifier: Apache-2.0
// What is told of an image beside its pixels.
#pragma once

#include <OpenImageIO/imageio.h>

namespace ddt {

/// Take away what is true of the source's pixels only.
inline void forget_pixels(OIIO::ImageSpec& spec) {
    for (const char* name :
         {"oiio:SHA-1", "oiio:ConstantColor", "oiio:AverageColor", "textureformat"})
        spec.erase_attribute(name);
}

} // namespace ddt
