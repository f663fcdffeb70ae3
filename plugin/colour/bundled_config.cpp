// SPDX-License-Identifier: Apache-2.0
// Made by calls, not from a config's text: OpenColorIO reads the numbers of a text as the global
// C++ locale writes them, which fails in a host whose locale has a decimal comma.
#include "plugin/colour/bundled_config.h"

#include <vector>

#include "plugin/colour/encodings.h"

namespace ddt {
namespace {

namespace OCIO = OCIO_NAMESPACE;

struct Described {
    const char *name, *encoding, *description;
    std::vector<const char*> aliases;
};

void add(OCIO::Config& config, const Described& described, const OCIO::ConstTransformRcPtr& light) {
    auto space = OCIO::ColorSpace::Create();
    space->setName(described.name);
    space->setEncoding(described.encoding);
    space->setDescription(described.description);
    for (const char* alias : described.aliases)
        space->addAlias(alias);
    if (light)
        space->setTransform(light, OCIO::COLORSPACE_DIR_TO_REFERENCE);
    config.addColorSpace(space);
}

/// The curve of encodings.h of that name.
OCIO::TransformRcPtr curve(const char* name) {
    const Encoding& e = *encoding_of(name);
    if (e.offset == 0)
        return mirrored_power(e.gamma);
    auto transform = OCIO::ExponentWithLinearTransform::Create();
    transform->setGamma({e.gamma, e.gamma, e.gamma, 1.0});
    transform->setOffset({e.offset, e.offset, e.offset, 0.0});
    transform->setNegativeStyle(OCIO::NEGATIVE_MIRROR);
    return transform;
}

OCIO::TransformRcPtr builtin(const char* style,
                             OCIO::TransformDirection direction = OCIO::TRANSFORM_DIR_FORWARD) {
    auto transform = OCIO::BuiltinTransform::Create();
    transform->setStyle(style);
    transform->setDirection(direction);
    return transform;
}

OCIO::TransformRcPtr one_after_the_other(const OCIO::TransformRcPtr& first,
                                         const OCIO::TransformRcPtr& second) {
    auto group = OCIO::GroupTransform::Create();
    group->appendTransform(first);
    group->appendTransform(second);
    return group;
}

OCIO::TransformRcPtr adobe_primaries() {
    constexpr double to_rec709[16] = {1.3983557439607786,  -0.3983557439607786, 0, 0, 0, 1, 0, 0, 0,
                                      -0.0429289892944732, 1.0429289892944732,  0, 0, 0, 0, 1};
    auto transform = OCIO::MatrixTransform::Create();
    transform->setMatrix(to_rec709);
    return transform;
}

OCIO::ConstConfigRcPtr make_config() {
    OCIO::ConfigRcPtr config = OCIO::Config::Create();
    config->setVersion(2, 0);
    constexpr const char* ap1_to_rec709 = "UTILITY - ACES-AP1_to_LINEAR-REC709_BFD";
    add(*config,
        {"lin_rec709",
         "scene-linear",
         "Scene-linear light, primaries of Rec.709: the reference.",
         {"linear", "lin_srgb", "lin_rec709_srgb", "lin_rec709_scene", "lnf", "lnh", "lin",
          "Linear Rec.709 (sRGB)", "Utility - Linear - sRGB", "Utility - Linear - Rec.709"}},
        nullptr);
    add(*config,
        {"sRGB",
         "sdr-video",
         "IEC 61966-2-1.",
         {"srgb_tx", "srgb_texture", "srgb_rec709_scene", "srgb_rec709_display", "srgb_display",
          "sRGB - Texture", "sRGB - Display", "Utility - sRGB - Texture"}},
        curve("sRGB"));
    add(*config,
        {"Rec709",
         "sdr-video",
         "The camera curve of ITU-R BT.709.",
         {"Rec.709", "rec709_camera", "Camera Rec.709", "ITU709", "BT709"}},
        curve("Rec709"));
    add(*config,
        {"Gamma1.8",
         "sdr-video",
         "",
         {"g18_rec709", "g18_rec709_scene", "g18_rec709_tx", "Gamma 1.8 Rec.709 - Texture"}},
        curve("Gamma1.8"));
    add(*config,
        {"Gamma2.2",
         "sdr-video",
         "",
         {"GammaCorrected", "g22_rec709", "g22_rec709_scene", "g22_rec709_tx", "g22_rec709_display",
          "Gamma 2.2 Rec.709 - Texture"}},
        curve("Gamma2.2"));
    add(*config,
        {"Gamma2.4",
         "sdr-video",
         "",
         {"g24_rec709", "g24_rec709_scene", "g24_rec709_tx", "g24_rec709_display",
          "Gamma 2.4 Rec.709 - Texture", "Rec.1886 Rec.709 - Display"}},
        curve("Gamma2.4"));
    add(*config,
        {"AdobeRGB",
         "sdr-video",
         "Adobe RGB (1998), gamma 563/256.",
         {"adobe_rgb", "Adobe RGB", "Adobe RGB (1998)", "g22_adobergb_scene", "g22_adobergb_tx"}},
        one_after_the_other(mirrored_power(563.0 / 256.0), adobe_primaries()));
    add(*config, {"ACEScg", "scene-linear", "", {"lin_ap1", "lin_ap1_scene", "ACES - ACEScg"}},
        builtin(ap1_to_rec709));
    add(*config,
        {"ACES2065-1",
         "scene-linear",
         "",
         {"aces2065_1", "aces", "lin_ap0", "lin_ap0_scene", "ACES - ACES2065-1"}},
        one_after_the_other(builtin("ACEScg_to_ACES2065-1", OCIO::TRANSFORM_DIR_INVERSE),
                            builtin(ap1_to_rec709)));
    auto raw = OCIO::ColorSpace::Create();
    raw->setName("raw");
    raw->setEncoding("data");
    raw->setIsData(true);
    raw->addAlias("Utility - Raw");
    raw->addAlias("non-color");
    config->addColorSpace(raw);
    config->setRole(OCIO::ROLE_DEFAULT, "raw");
    config->setRole(OCIO::ROLE_DATA, "raw");
    config->setRole(OCIO::ROLE_SCENE_LINEAR, "lin_rec709");
    config->setRole(OCIO::ROLE_COLOR_PICKING, "sRGB");
    config->setRole(OCIO::ROLE_TEXTURE_PAINT, "sRGB");
    return config;
}

} // namespace

OCIO::TransformRcPtr mirrored_power(double gamma) {
    auto transform = OCIO::ExponentTransform::Create();
    transform->setValue({gamma, gamma, gamma, 1.0});
    transform->setNegativeStyle(OCIO::NEGATIVE_MIRROR);
    return transform;
}

OCIO::ConstConfigRcPtr bundled_config() {
    // Never destroyed: hosts may resize while static objects are being torn down.
    static const auto* config = new OCIO::ConstConfigRcPtr(make_config());
    return *config;
}

} // namespace ddt
