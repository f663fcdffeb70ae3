// SPDX-License-Identifier: Apache-2.0
#include "light.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "ddt/guide.h"

namespace bench {

bool find_light(const std::string& name, Light& light) {
    if (name == "linear")
        light = Light::linear;
    else if (name == "encoded")
        light = Light::encoded;
    else if (name == "scene")
        light = Light::scene;
    else
        return false;
    return true;
}

double decode_srgb(double encoded) {
    double v = std::abs(encoded);
    double linear = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    return std::copysign(linear, encoded);
}

double encode_srgb(double linear) {
    double v = std::abs(linear);
    double encoded = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
    return std::copysign(encoded, linear);
}

double decode_log(double display) {
    return std::copysign((std::exp2(std::abs(display) * 16 / 255) - 1) / 1024, display);
}

double encode_log(double scene) {
    return std::copysign(255.0 / 16 * std::log2(1 + 1024 * std::abs(scene)), scene);
}

double decode(double display, Light light) {
    switch (light) {
    case Light::linear:
        return decode_srgb(display / 255);
    case Light::encoded:
        return display / 255;
    case Light::scene:
        return decode_log(display);
    }
    return 0;
}

double encode(double value, Light light) {
    switch (light) {
    case Light::linear:
        return 255 * encode_srgb(value);
    case Light::encoded:
        return 255 * value;
    case Light::scene:
        return encode_log(value);
    }
    return 0;
}

std::vector<float> pixels_of(const metrics::Image& image, Light light) {
    std::vector<float> pixels;
    pixels.reserve(image.channels[0].values.size() * std::size(image.channels));
    for (size_t i = 0; i < image.channels[0].values.size(); ++i)
        for (const metrics::Plane& plane : image.channels)
            pixels.push_back(float(decode(plane.values[i], light)));
    return pixels;
}

std::vector<float> guide_of(const std::vector<float>& pixels, Light light) {
    ddt::GuideRecipe recipe;
    for (int c = 0; c < 3; ++c) {
        recipe.channel[c] = c;
        recipe.weight[c] = ddt::luminance_weights[c];
    }
    recipe.linear = light != Light::encoded;
    std::vector<float> guide(pixels.size() / 3);
    ddt::make_guide(recipe, pixels.data(), guide.size(), 3, guide.data());
    return guide;
}

OIIO::ImageBuf to_light(const metrics::Image& image, Light light) {
    OIIO::ImageSpec spec(image.width(), image.height(), 3, OIIO::TypeDesc::FLOAT);
    spec.attribute("oiio:ColorSpace", light == Light::encoded ? "sRGB" : "Linear");
    OIIO::ImageBuf buffer(spec);
    buffer.set_pixels(buffer.roi(), OIIO::TypeDesc::FLOAT, pixels_of(image, light).data());
    return buffer;
}

metrics::Image to_display(const OIIO::ImageBuf& image, Light light) {
    const OIIO::ImageSpec& spec = image.spec();
    std::vector<float> values(spec.image_pixels() * 3);
    OIIO::ROI roi = image.roi();
    roi.chend = 3;
    image.get_pixels(roi, OIIO::TypeDesc::FLOAT, values.data());
    metrics::Image out;
    for (size_t c = 0; c < 3; ++c) {
        metrics::Plane plane(spec.width, spec.height);
        for (size_t i = 0; i < plane.values.size(); ++i)
            plane.values[i] = encode(double(values[i * 3 + c]), light);
        out.channels[c] = std::move(plane);
    }
    return out;
}

metrics::Image stored(const metrics::Image& image, Light light) {
    if (light == Light::scene)
        return image;
    metrics::Image out = image;
    for (metrics::Plane& plane : out.channels)
        for (double& v : plane.values)
            v = std::clamp(std::round(v), 0.0, 255.0);
    return out;
}

} // namespace bench
