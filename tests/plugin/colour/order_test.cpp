// SPDX-License-Identifier: Apache-2.0
// Which config knows a name, with a stand-in for the one that comes with OpenColorIO 2.2 and later:
// this program's ocio_builtin_config() is found before the library's.
#include "plugin/colour/ocio_builtin_config.h"

#include <optional>
#include <sstream>

#include <gtest/gtest.h>

#include "plugin/colour/space_light.h"
#include "tests/environment.h"

namespace ddt {

OCIO_NAMESPACE::ConstConfigRcPtr ocio_builtin_config() {
    std::istringstream text(R"(ocio_profile_version: 2
luma: [0.5, 0.25, 0.25]
roles: {default: raw, scene_linear: built-in linear}
displays:
  none:
    - !<View> {name: raw, colorspace: raw}
colorspaces:
  - !<ColorSpace>
    name: built-in linear
  - !<ColorSpace>
    name: raw
    isdata: true
  - !<ColorSpace>
    name: sRGB
    aliases: [srgb_rec709_scene]
    to_scene_reference: !<ExponentTransform> {value: 3, style: mirror}
  - !<ColorSpace>
    name: new in this version
    to_scene_reference: !<ExponentTransform> {value: 3, style: mirror}
)");
    return OCIO_NAMESPACE::Config::CreateFromStream(text);
}

} // namespace ddt

namespace {

float red_luma(const char* option, const char* space) {
    std::string error;
    const auto light = ddt::find_light(option, space, error);
    EXPECT_TRUE(light && light->known()) << space << error;
    return light ? light->luma()[0] : 0;
}

TEST(Order, TheCarriedConfigIsAskedBeforeOpenColorIOs) {
    const ddt::Environment none_named("OCIO", std::nullopt);
    for (const char* space : {"sRGB", "srgb_rec709_scene", "linear", "g22_rec709_scene"}) {
        EXPECT_FLOAT_EQ(red_luma("auto", space), 0.2126f) << space;
        EXPECT_FLOAT_EQ(red_luma(space, ""), 0.2126f) << space;
    }
}

TEST(Order, OpenColorIOsConfigKnowsTheRest) {
    const ddt::Environment none_named("OCIO", std::nullopt);
    EXPECT_FLOAT_EQ(red_luma("auto", "new in this version"), 0.5f);
    EXPECT_FLOAT_EQ(red_luma("new in this version", ""), 0.5f);
}

} // namespace
