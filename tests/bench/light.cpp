#include "light.h"

#include <algorithm>
#include <cmath>

namespace bench {

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

OIIO::ImageBuf to_light(const metrics::Image& image, Light light) {
    OIIO::ImageSpec spec(image.width(), image.height(), 3, OIIO::TypeDesc::FLOAT);
    spec.attribute("oiio:ColorSpace", light == Light::linear ? "Linear" : "sRGB");
    std::vector<float> values;
    values.reserve(spec.image_pixels() * 3);
    for (size_t i = 0; i < spec.image_pixels(); ++i)
        for (const metrics::Plane& plane : image.channels) {
            double v = plane.values[i] / 255;
            values.push_back(float(light == Light::linear ? decode_srgb(v) : v));
        }
    OIIO::ImageBuf buffer(spec);
    buffer.set_pixels(buffer.roi(), OIIO::TypeDesc::FLOAT, values.data());
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
        for (size_t i = 0; i < plane.values.size(); ++i) {
            double v = values[i * 3 + c];
            plane.values[i] = 255 * (light == Light::linear ? encode_srgb(v) : v);
        }
        out.channels[c] = std::move(plane);
    }
    return out;
}

metrics::Image rounded(const metrics::Image& image) {
    metrics::Image out = image;
    for (metrics::Plane& plane : out.channels)
        for (double& v : plane.values)
            v = std::clamp(std::round(v), 0.0, 255.0);
    return out;
}

} // namespace bench
