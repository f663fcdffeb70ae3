// SPDX-License-Identifier: Apache-2.0
// What every test image is painted with: linear light in double precision, many samples a pixel.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <OpenImageIO/imagebuf.h>

namespace testimages {

struct Colour {
    double r = 0, g = 0, b = 0, a = 1; ///< not multiplied by a
};

Colour grey(double value);
Colour mix(const Colour& from, const Colour& to, double share);
Colour operator*(const Colour& colour, double factor); ///< leaves a as it is

/// Colour at a position; pixel (x, y) covers [x, x+1) x [y, y+1).
using Paint = std::function<Colour(double x, double y)>;

/// An image as it was painted: area averages over the pixels, in linear light.
struct Picture {
    int width = 0, height = 0;
    std::vector<Colour> pixels;
    const Colour& at(int x, int y) const { return pixels[size_t(y) * width + x]; }
};

/// Average samples x samples positions in each pixel. Colours are averaged by their alpha.
Picture paint(int width, int height, const Paint& colour_at, int samples = 8);

/// 8 bits a channel, sRGB. channels: 1 (from r), 3, or 4 (alpha unassociated, as PNG keeps it).
OIIO::ImageBuf eight_bit(const Picture& picture, int channels);

/// Floats as they are, linear light. channels: 3, or 4 (colour multiplied by alpha, as EXR keeps
/// it).
OIIO::ImageBuf scene_linear(const Picture& picture, int channels, OIIO::TypeDesc format);

} // namespace testimages
