// SPDX-License-Identifier: Apache-2.0
#include "plugin/colour/encodings.h"

#include <cmath>
#include <map>
#include <mutex>

#include "ddt/guide.h"

namespace ddt {
namespace {

constexpr Encoding encodings[] = {
    {"linear", 1.0, 0.0},   {"sRGB", 2.4, 0.055},   {"Rec709", 2.22222222222222, 0.099},
    {"Gamma1.8", 1.8, 0.0}, {"Gamma2.2", 2.2, 0.0}, {"Gamma2.4", 2.4, 0.0},
};

const std::array<float, 3> rec709_luma{luminance_weights[0], luminance_weights[1],
                                       luminance_weights[2]};

/// Numbers that curve(|v|) replaces, of float32 arithmetic throughout.
template <class Curve>
Light::Exact mirrored(Curve curve) {
    return [=](float* rgb, size_t count) {
        for (float* v = rgb; v < rgb + 3 * count; ++v)
            *v = std::copysign(curve(std::fabs(*v)), *v);
    };
}

Light::Exact to_light(const Encoding& e) {
    const auto gamma = float(e.gamma);
    if (e.offset == 0)
        return mirrored([=](float v) { return std::pow(v, gamma); });
    // The line's end is where the curve's tangent goes through 0.
    const double end = e.offset / (e.gamma - 1);
    const double at_end = std::pow(e.offset * e.gamma / ((e.gamma - 1) * (1 + e.offset)), e.gamma);
    const auto border = float(end), slope = float((e.gamma - 1) / e.offset * at_end);
    const auto scale = float(1 / (1 + e.offset)), shift = float(e.offset / (1 + e.offset));
    return mirrored(
        [=](float v) { return v <= border ? v * slope : std::pow(v * scale + shift, gamma); });
}

Light::Exact from_light(const Encoding& e) {
    const auto gamma = float(1 / e.gamma);
    if (e.offset == 0)
        return mirrored([=](float v) { return std::pow(v, gamma); });
    const double end = std::pow(e.offset * e.gamma / ((e.gamma - 1) * (1 + e.offset)), e.gamma);
    const double rise = std::pow((e.gamma - 1) / e.offset, e.gamma - 1) *
                        std::pow((1 + e.offset) / e.gamma, e.gamma);
    const auto border = float(end), slope = float(rise);
    const auto scale = float(1 + e.offset), shift = float(e.offset);
    return mirrored(
        [=](float v) { return v <= border ? v * slope : std::pow(v, gamma) * scale - shift; });
}

Light light_of(const Encoding& e) {
    if (e.gamma == 1.0)
        return Light::linear(rec709_luma);
    Light light;
    Light::curves(to_light(e), from_light(e), rec709_luma, light);
    return light;
}

bool same_name(std::string_view a, std::string_view b) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; };
    if (a.size() != b.size())
        return false;
    for (size_t i = 0; i < a.size(); ++i)
        if (lower(a[i]) != lower(b[i]))
            return false;
    return true;
}

} // namespace

const Encoding* encoding_of(std::string_view name) {
    for (const Encoding& e : encodings)
        if (same_name(name, e.name))
            return &e;
    return nullptr;
}

std::shared_ptr<const Light> find_encoding(std::string_view name) {
    static std::mutex mutex;
    // Never destroyed: hosts may resize while static objects are being torn down.
    static auto& known = *new std::map<const Encoding*, std::shared_ptr<const Light>>;
    const Encoding* e = encoding_of(name);
    if (!e)
        return nullptr;
    const std::lock_guard<std::mutex> lock(mutex);
    auto& light = known[e];
    if (!light)
        light = std::make_shared<Light>(light_of(*e));
    return light;
}

std::vector<std::string> encoding_names() {
    std::vector<std::string> names;
    for (const Encoding& e : encodings)
        names.emplace_back(e.name);
    return names;
}

} // namespace ddt
