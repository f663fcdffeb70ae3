// SPDX-License-Identifier: Apache-2.0
// The light of a space by itself, for spaces whose way to scene_linear loses colours.
//
// From the spaces that a config has under display_colorspaces OpenColorIO goes there by the
// config's default view transform. Where that tone maps, scene_linear is not proportional to what
// the display shows, and has no room for the brightest of it. From others it goes through primaries
// of which some colours are cut off (ACEScc).
#pragma once

#include <array>

#include <OpenColorIO/OpenColorIO.h>

#include "plugin/colour/config.h"

namespace ddt {

/// A way from a space's numbers to light.
struct WayToLight {
    OCIO_NAMESPACE::ConstTransformRcPtr transform;
    std::array<double, 3> luma; ///< shares of the light's channels in luminance
};

/// True for a display's space if OpenColorIO's way from it to scene_linear is more than a matrix
/// from the display's light, or leads nowhere. The config has the role.
bool is_tone_mapped(const Space& space);

/// The space's own conversion to the reference, less the matrices and clamps that it ends with:
/// without these numbers come back, and more exactly where curves are steep (PQ near black). The
/// luminance is that of the reference: of displays CIE XYZ's Y, else that of scene_linear. Throws
/// OCIO::Exception.
WayToLight own_light(const Space& space);

} // namespace ddt
