// SPDX-License-Identifier: Apache-2.0
// Between display values (0..255) and the light in which an image is resized.
#pragma once

#include <string>
#include <vector>

#include <OpenImageIO/imagebuf.h>

#include "metrics/image.h"

namespace bench {

enum class Light {
    linear,  ///< linear light; display values are sRGB encoded
    encoded, ///< the display values themselves
    scene,   ///< linear light without a white; display values are its logarithm
};

/// The light called "linear", "encoded" or "scene"; false if `name` is none of them.
bool find_light(const std::string& name, Light& light);

/// IEC 61966-2-1 between 0..1 and 0..1, mirrored for negatives and carried on past 1.
double decode_srgb(double encoded);
double encode_srgb(double linear);

/// 255 / 16 log2(1 + 1024 |scene|) with the sign of `scene`, and back: 0 to 255 for 0 to 64, and
/// on past that.
double decode_log(double display);
double encode_log(double scene);

/// One display value in a light, and back.
double decode(double display, Light light);
double encode(double value, Light light);

/// Red, green and blue of every pixel in a light, row by row.
std::vector<float> pixels_of(const metrics::Image& image, Light light);

/// The guide that the filters make of such pixels, before it is blurred.
std::vector<float> guide_of(const std::vector<float>& pixels, Light light);

/// Three float channels, 1 is white, "oiio:ColorSpace" set.
OIIO::ImageBuf to_light(const metrics::Image& image, Light light);

/// Back to 0..255, neither clipped nor rounded.
metrics::Image to_display(const OIIO::ImageBuf& image, Light light);

/// As a file would hold it: 8 bits, or for scene light floats.
metrics::Image stored(const metrics::Image& image, Light light);

} // namespace bench
