// SPDX-License-Identifier: Apache-2.0
// Reading the originals and reducing them to what the rows start from.
#pragma once

#include <string>
#include <vector>

#include "light.h"

namespace bench {

enum class Reduce { box, cubic };

/// The image files of a folder, sorted; those OpenImageIO cannot open are left out.
std::vector<std::string> image_files(const std::string& folder);

/// Display values of an image file with integer pixels, or for Light::scene with floating point
/// ones, cropped at its right and lower edge to multiples of `scale`; grey becomes RGB. Alpha of
/// integers is composited over white as the values are stored. On failure `error` says why.
bool read_original(const std::string& path, int scale, Light light, metrics::Image& image,
                   std::string& error);

/// `image` reduced by `scale` in `light` and stored: by the mean of scale x scale
/// pixels, or by a Catmull-Rom cubic that is as much wider.
metrics::Image reduced(const metrics::Image& image, int scale, Light light, Reduce reduce);

} // namespace bench
