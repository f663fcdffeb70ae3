// Between display values (0..255, sRGB encoded) and the light in which an image is resized.
#pragma once

#include <OpenImageIO/imagebuf.h>

#include "metrics/image.h"

namespace bench {

enum class Light { linear, encoded };

/// IEC 61966-2-1 between 0..1 and 0..1, mirrored for negatives and carried on past 1.
double decode_srgb(double encoded);
double encode_srgb(double linear);

/// Three float channels, 1 is white, "oiio:ColorSpace" set.
OIIO::ImageBuf to_light(const metrics::Image& image, Light light);

/// Back to 0..255, neither clipped nor rounded.
metrics::Image to_display(const OIIO::ImageBuf& image, Light light);

/// As 8 bits would hold it.
metrics::Image rounded(const metrics::Image& image);

} // namespace bench
