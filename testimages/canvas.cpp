// SPDX-License-Identifier: Apache-2.0
#include "canvas.h"

#include <cmath>

namespace testimages {

namespace {

/// IEC 61966-2-1, 0..1 linear to 0..255.
uint8_t encode(double linear) {
    double clipped = std::min(std::max(linear, 0.0), 1.0);
    double encoded =
        clipped <= 0.0031308 ? 12.92 * clipped : 1.055 * std::pow(clipped, 1 / 2.4) - 0.055;
    return uint8_t(std::lround(encoded * 255));
}

template <typename T, typename Convert>
OIIO::ImageBuf fill(const Picture& picture, OIIO::ImageSpec spec, Convert convert) {
    std::vector<T> values;
    values.reserve(picture.pixels.size() * size_t(spec.nchannels));
    for (const Colour& colour : picture.pixels) {
        T channels[4];
        convert(colour, channels);
        values.insert(values.end(), channels, channels + spec.nchannels);
    }
    OIIO::ImageBuf image(spec);
    image.set_pixels(image.roi(), OIIO::BaseTypeFromC<T>::value, values.data());
    return image;
}

} // namespace

Colour grey(double value) {
    return {value, value, value, 1};
}

Colour mix(const Colour& from, const Colour& to, double share) {
    return {from.r + (to.r - from.r) * share, from.g + (to.g - from.g) * share,
            from.b + (to.b - from.b) * share, from.a + (to.a - from.a) * share};
}

Colour operator*(const Colour& colour, double factor) {
    return {colour.r * factor, colour.g * factor, colour.b * factor, colour.a};
}

Picture paint(int width, int height, const Paint& colour_at, int samples) {
    Picture picture{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            Colour sum{0, 0, 0, 0};
            for (int j = 0; j < samples; ++j)
                for (int i = 0; i < samples; ++i) {
                    Colour c = colour_at(x + (i + 0.5) / samples, y + (j + 0.5) / samples);
                    sum.r += c.r * c.a;
                    sum.g += c.g * c.a;
                    sum.b += c.b * c.a;
                    sum.a += c.a;
                }
            double weight = sum.a > 0 ? 1 / sum.a : 0;
            picture.pixels.push_back({sum.r * weight, sum.g * weight, sum.b * weight,
                                      sum.a / (double(samples) * samples)});
        }
    return picture;
}

OIIO::ImageBuf eight_bit(const Picture& picture, int channels) {
    OIIO::ImageSpec spec(picture.width, picture.height, channels, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    if (channels == 4)
        spec.attribute("oiio:UnassociatedAlpha", 1);
    return fill<uint8_t>(picture, spec, [](const Colour& colour, uint8_t* out) {
        out[0] = encode(colour.r);
        out[1] = encode(colour.g);
        out[2] = encode(colour.b);
        out[3] = uint8_t(std::lround(colour.a * 255));
    });
}

OIIO::ImageBuf scene_linear(const Picture& picture, int channels, OIIO::TypeDesc format) {
    OIIO::ImageSpec spec(picture.width, picture.height, channels, format);
    spec.attribute("oiio:ColorSpace", "Linear");
    return fill<float>(picture, spec, [channels](const Colour& colour, float* out) {
        double coverage = channels == 4 ? colour.a : 1;
        out[0] = float(colour.r * coverage);
        out[1] = float(colour.g * coverage);
        out[2] = float(colour.b * coverage);
        out[3] = float(colour.a);
    });
}

} // namespace testimages
